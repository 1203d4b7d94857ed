import { readFileSync } from 'node:fs';
import { off, sphere } from '../fixtures';
import { expect, expectRefused, test } from '../page';

/** Those of the document, as they stand. */
const EXAMPLES = [
  ...readFileSync('docs/scripting.md', 'utf8')
    .split('## Examples')[1]
    .matchAll(/```js\n(.*?)```/gs),
].map(([, code]) => code);

/** What each says, in order. */
const SAID: readonly RegExp[][] = [
  [/^torus: 8640 vertices, the farthest \d\.\d{3} away$/],
  // From the corner 1 there is half a unit less: √2 to the corner across by way of the source 0, 1 by the side.
  [/^0\.000 0\.500 1\.414 1\.000$/],
  [/^m = 1: \d\.\d\d %$/, /^m = 10: \d\.\d\d %$/, /^m = 100: \d+\.\d\d %$/],
  [/^\d+\.\d mm$/],
  [/^sources\[0\], {"vertex":1000000000}, is not on .*\.$/, /^true$/],
  [],
];

test('scripts open, set, measure and wait; the examples of the document run as they stand', async ({
  heatwalk,
  page,
}) => {
  const said: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'log') said.push(message.text());
  });
  await heatwalk.open('#m=icosphere');
  expect(EXAMPLES).toHaveLength(SAID.length);
  for (const [index, code] of EXAMPLES.entries()) {
    const download = code.includes('download') ? page.waitForEvent('download') : null;
    await page.evaluate(`(async () => { ${code} })()`);
    expect(said, code).toHaveLength(SAID[index].length);
    SAID[index].forEach((expected, i) => expect(said[i]).toMatch(expected));
    if (download) expect((await download).suggestedFilename()).toBe('heatwalk.png');
    said.length = 0;
  }
  // The tape is as long as the path, and both in millimeters: half the way around a sphere of radius 1 cm at most.
  const tape = await page.evaluate(async () => {
    await window.heatwalk.settled();
    return { legs: window.heatwalk.tapes[0], path: (await window.heatwalk.path())?.length };
  });
  expect(tape.legs.length).toBeCloseTo(tape.path ?? 0, 6);

  // Files, and commands of the search.
  const state = await page.evaluate(
    async ({ content }) => {
      const mesh = await window.heatwalk.open({ files: [new File([content], 'ball.off')], options: { s: '3' } });
      const commands = await window.heatwalk.commands();
      await window.heatwalk.run('Legend on or off');
      await window.heatwalk.set({ sets: 'line:0-5-9', show: 'edges', height: 2 });
      await window.heatwalk.setTapes([{ points: [{ vertex: 1 }, { vertex: 2 }, { vertex: 40 }], closed: true }]);
      await window.heatwalk.setWalker({ face: 5, weights: [0.5, 0.25, 0.25] });
      return { mesh, commands, scene: window.heatwalk.scene, link: (await window.heatwalk.state()).link };
    },
    { content: off(sphere(8)) },
  );
  expect(state.mesh).toMatchObject({ name: 'ball.off', triangles: 224 });
  expect(state.commands).toContainEqual({ name: 'Undo', keys: ['ctrl+z'] });
  expect(state.scene).toMatchObject({ sources: [{ vertex: 3 }], overlays: ['edges'], ground: { highest: 2 } });
  expect(state.scene.sets[0].points.length).toBeGreaterThan(2);
  expect(state.scene.tapes).toEqual([{ points: [{ vertex: 1 }, { vertex: 2 }, { vertex: 40 }], closed: true }]);
  expect(state.link).toContain('height=2');
  await expect(page.locator('.legend')).toBeHidden();

  // Whatever is wrong is named, and the scene stays.
  const refusals = await page.evaluate(async () => {
    const before = JSON.stringify([window.heatwalk.scene, window.heatwalk.mesh]);
    const { heatwalk: api } = window;
    const wrong = api as unknown as Record<string, (...given: unknown[]) => Promise<unknown>>;
    const asked = [
      wrong['open'](),
      wrong['open']({ files: [{ name: 'a.off', content: 'OFF' }] }),
      api.open({ files: [{ name: 'bad.off', content: new Blob(['no mesh']) }] }),
      api.open({ preset: 'nothing' }),
      wrong['set']('gold'),
      api.set({ colour: 'red' }),
      api.set({ fill: 5000 }),
      api.set({ sets: 'line:0-9999' }),
      api.set({ tape: '0,9999' }),
      wrong['setSources']({ vertex: 1 }),
      api.setWalker({ face: 5, weights: [1, 1, 1] }),
      api.setTapes([{ points: [{ vertex: 1 }, { vertex: 2 }], closed: true }]),
      api.run('dance'),
    ];
    const reasons = await Promise.all(
      asked.map((each) =>
        each.then(
          () => 'done',
          (error: Error) => error.message,
        ),
      ),
    );
    return { reasons, isKept: JSON.stringify([api.scene, api.mesh]) === before };
  });
  expectRefused(refusals, [
    'open takes an object, not missing',
    'files[0].content is “OFF”; a Blob, File or ArrayBuffer is needed.',
    'bad.off was not opened',
    'is no preset: see window.heatwalk.presets',
    'options is “gold”; an object of keys of the link is needed.',
    'There is no option colour.',
    'fill belong to the mesh: give them to open.',
    'sets has 1 entries; 0 are on ball.off.',
    'tape[0].points[1], {"vertex":9999}, is not on ball.off.',
    'sources is {"vertex":1}; a list is needed.',
    'walker.weights is [1,1,1]; 3 numbers from 0 that sum to 1 are needed.',
    'tapes[0].points is [{"vertex":1},{"vertex":2}]; a list of 3 or more places is needed.',
    'There is no command “dance”; there are Set the source (1),',
  ]);
});
