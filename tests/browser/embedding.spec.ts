import type { Page } from '@playwright/test';
import type { EmbeddedHeatwalk, Request } from '../../web/embed';
import { off, sphere } from '../fixtures';
import { expect, expectRefused, test } from '../page';
import { Host, ISOLATED } from '../server';

declare global {
  interface Window {
    embedded: EmbeddedHeatwalk[];
    told: { frame: number; event: string; detail: unknown }[];
    isolated: boolean;
  }
}

const BALL = sphere(8);

/** A page of another origin with the built page in so many frames. */
const hostPage = (count: number) => `<!doctype html><title>Host</title><body><script type="module">
  const page = 'http://localhost:' + location.port + '/in/a/folder/';
  const { EmbeddedHeatwalk } = await import(page + 'embed.js');
  window.told = [];
  window.embedded = Array.from({ length: ${count} }, (_, frame) => {
    const element = document.createElement('iframe');
    element.src = page + '?gpu=webgl#m=icosphere&kiosk=1';
    element.width = 400;
    element.height = 300;
    document.body.append(element);
    const heatwalk = new EmbeddedHeatwalk(element);
    for (const event of ['ready', 'loading', 'opened', 'placed', 'solved', 'picked', 'error'])
      heatwalk.on(event, (detail) => window.told.push({ frame, event, detail }));
    return heatwalk;
  });
</script>`;

async function openHost(page: Page, count: number, headers: Record<string, string>): Promise<Host> {
  // What the module needs comes from another origin.
  const host = await Host.start({ 'Access-Control-Allow-Origin': '*', ...headers }, { '/host.html': hostPage(count) });
  await page.goto(`${host.other}/host.html`);
  await page.waitForFunction(() => window.embedded);
  return host;
}

test('two frames in a page of another origin are told apart, asked and heard', async ({ page }) => {
  const host = await openHost(page, 2, {});
  const file = off(BALL);
  const answers = await page.evaluate(async (content) => {
    const [first, second] = window.embedded;
    const [ball, torus] = await Promise.all([
      first.open({ files: [{ name: 'ball.off', content: new Blob([content]) }], options: { look: 'gold', s: '0' } }),
      second.open({ preset: 'torus' }),
    ]);
    await first.setSources([{ vertex: 3 }, { face: 5, weights: [0.5, 0.25, 0.25], offset: 0.25 }]);
    await first.setWalker({ vertex: 100 });
    await first.set({ period: 0.1, way: 'exact' });
    const distances = await first.distances();
    const path = await first.path();
    const state = await first.state();
    const picture = await second.picture({ clear: true });
    return {
      ball,
      torus,
      state,
      values: Array.from(distances?.values ?? []),
      isDouble: distances?.values instanceof Float64Array,
      points: Array.from(path?.points ?? []),
      length: path?.length ?? 0,
      picture: [picture.type, picture.size > 1000],
      other: (await second.state()).sources,
    };
  }, file);
  const count = BALL.positions.length;
  expect(answers.ball).toMatchObject({ name: 'ball.off', inputVertices: count });
  expect(answers.torus.triangles).toBe(17_280);
  expect(answers.isDouble).toBe(true);
  expect(answers.values).toHaveLength(count);
  expect(answers.values[3]).toBe(0);
  // On a sphere of radius 1, from one vertex to another.
  expect(Math.max(...answers.values)).toBeLessThan(Math.PI);
  expect(answers.picture).toEqual(['image/png', true]);
  expect(answers.state).toMatchObject({
    sources: [{ vertex: 3 }, { face: 5, weights: [0.5, 0.25, 0.25], offset: 0.25 }],
    walker: { vertex: 100 },
    refining: 'exact',
  });
  expect(answers.state.link).toContain('look=gold');
  expect(answers.state.link).toContain('way=exact');
  // Nothing of the one reaches the other.
  expect(answers.other).toEqual([{ vertex: 7264 }]);
  // The path is in the axes and the unit of the file: it starts at the walker.
  BALL.positions[100].forEach((along, axis) => expect(answers.points[axis]).toBeCloseTo(along, 5));
  let length = 0;
  for (let i = 3; i < answers.points.length; i += 3)
    length += Math.hypot(...[0, 1, 2].map((axis) => answers.points[i + axis] - answers.points[i + axis - 3]));
  expect(length).toBeCloseTo(answers.length, 5);

  // What is opened in frames is no step back of the page around them.
  await expect
    .poll(() => page.frames()[1].evaluate(() => [location.hash, history.state] as const))
    .toEqual([expect.stringContaining('name=ball.off'), { heatwalk: 0 }]);

  // A click of the user is told by the frame where it was, with the place under the pointer.
  const told = (event: string) => page.evaluate((name) => window.told.filter((each) => each.event === name), event);
  const box = await page.locator('iframe').first().boundingBox();
  if (!box) throw new Error('the frame is not in view');
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await expect.poll(async () => (await told('picked')).map(({ frame }) => frame)).toEqual([0]);
  expect(await told('loading')).toContainEqual(expect.objectContaining({ frame: 1, event: 'loading' }));
  expect(await told('placed')).toContainEqual({
    frame: 0,
    event: 'placed',
    detail: { sources: answers.state.sources, walker: { vertex: 100 } },
  });
  expect(
    (await told('opened')).some(({ frame, detail }) => frame === 1 && JSON.stringify(detail).includes('torus')),
  ).toBe(true);

  // What is wrong is named, and nothing changes.
  const refusals = await page.evaluate(async () => {
    const [first] = window.embedded;
    const before = JSON.stringify((await first.state()).sources);
    const asked = [
      first.setSources([{ vertex: 1e6 }]),
      first.set({ look: 'nothing' }),
      first.set({ colour: 'red' }),
      first.set({ fill: 5000 }),
      first.open({ preset: 'nothing' }),
      first.open({ files: [{ name: 'bad.off', content: new Blob(['no mesh']) }] }),
      first.ask('paint' as 'state', {}),
    ];
    const reasons = await Promise.all(
      asked.map((answer) =>
        answer.then(
          () => 'done',
          (error: Error) => error.message,
        ),
      ),
    );
    return { reasons, isKept: before === JSON.stringify((await first.state()).sources) };
  });
  expectRefused(refusals, [
    'sources[0], {"vertex":1000000}, is not on ball.off.',
    'look=nothing: no such value.',
    'There is no option colour.',
    'fill belong to the mesh',
    'is no preset: see window.heatwalk.presets',
    'bad.off was not opened',
    'There is no method “paint”',
  ]);
  await host.stop();
});

test('a page that is isolated from others holds a frame as well, and only the host of a frame is answered', async ({
  page,
}) => {
  const host = await openHost(page, 1, ISOLATED);
  expect(await page.evaluate(() => crossOriginIsolated)).toBe(true);
  const { version, state } = await page.evaluate(async () => {
    const [heatwalk] = window.embedded;
    return { version: (await heatwalk.ask('hello', {})).version, state: await heatwalk.state() };
  });
  expect(version).toBe(1);
  expect(state.link).toContain(host.page);
  // Another window that asks the same frame hears nothing.
  const heard = await page.evaluate(async () => {
    const ids: unknown[] = [];
    addEventListener('message', ({ data }) => ids.push(data.id));
    const stranger = document.createElement('iframe');
    document.body.append(stranger);
    stranger.contentWindow?.addEventListener('message', ({ data }) => ids.push(data.id));
    const asked: Request = { heatwalk: 1, id: 7, method: 'state' };
    const script = document.createElement('script');
    script.textContent = `parent.frames[0].postMessage(${JSON.stringify(asked)}, '*')`;
    stranger.contentDocument?.body.append(script);
    // Asked after that, and answered after that.
    await window.embedded[0].ask('hello', {});
    await window.embedded[0].state();
    return ids;
  });
  expect(heard).not.toEqual([]);
  expect(heard).not.toContain(7);
  await host.stop();
});
