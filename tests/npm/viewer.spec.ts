/** `<heatwalk-viewer>` of the npm package, with the built page on another origin. */
import { mkdtempSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, type Page, test } from '@playwright/test';
import * as esbuild from 'esbuild';
import { Host } from '../server';
import { installed } from './installed';

/** The part of an element that is tried. */
interface Viewer extends HTMLElement {
  sources: unknown;
  walker: unknown;
  mesh: unknown;
  distance(): Promise<{ values: Float64Array } | null>;
  path(): Promise<{ length: number } | null>;
  toBlob(wanted?: object): Promise<Blob>;
}

declare global {
  interface Window {
    heard: { id: string; type: string; detail: Record<string, unknown> }[];
    viewer(id: string): Viewer;
  }
}

const SQUARE = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';
const MAIN = `import 'heatwalk/viewer';
globalThis.heard = [];
globalThis.viewer = (id) => document.getElementById(id);
for (const viewer of document.querySelectorAll('heatwalk-viewer')) {
  for (const type of ['load', 'progress', 'distance', 'sourcechange', 'pick', 'error'])
    viewer.addEventListener(type, ({ detail }) => heard.push({ id: viewer.id, type, detail }));
}
`;
const ROOT_2 = Math.SQRT2;

const folder = installed();

let app: Host;
let built: Host;

test.beforeAll(async () => {
  const own = mkdtempSync(join(folder(), 'viewer-'));
  writeFileSync(join(own, 'main.js'), MAIN);
  writeFileSync(join(own, 'square.off'), SQUARE);
  await esbuild.build({
    entryPoints: [join(own, 'main.js')],
    bundle: true,
    format: 'esm',
    outfile: join(own, 'out.js'),
  });
  // The page asks for meshes of the application, which is of another origin.
  app = await Host.start({ 'Access-Control-Allow-Origin': '*' }, {}, own);
  built = await Host.start();
});

test.afterAll(async () => {
  await app.stop();
  await built.stop();
});

const viewer = (id: string, attributes: string, page = `${built.page}?gpu=webgl`) =>
  `<heatwalk-viewer id="${id}" page="${page}" ${attributes} style="width: 400px; height: 300px"></heatwalk-viewer>`;

async function open(page: Page, body: string) {
  app.pages['/in/a/folder/'] =
    `<!doctype html><title>Application</title>${body}<script type="module" src="out.js"></script>`;
  await page.goto(app.page);
  await page.waitForFunction(() => 'heard' in window);
}

const told = (page: Page, id: string, type: string) =>
  page.evaluate(
    ([who, what]) => window.heard.filter((each) => each.id === who && each.type === what).map(({ detail }) => detail),
    [id, type] as const,
  );

/** The values of the last event of a viewer. */
async function values(page: Page, id: string): Promise<number[]> {
  return page.evaluate((who) => {
    const last = window.heard.findLast((each) => each.id === who && each.type === 'distance');
    return Array.from((last?.detail['values'] ?? []) as Float64Array, (value) => Number(value.toFixed(6)));
  }, id);
}

const rounded = (numbers: number[]) => numbers.map((number) => Number(number.toFixed(6)));

test('a mesh of an address is shown with the distances from its sources, which attributes and the user change', async ({
  page,
}) => {
  const attributes = 'src="square.off" sources="0" walker="2" method="exact" alt="A square"';
  await open(page, viewer('one', attributes));
  await expect.poll(() => values(page, 'one')).toEqual(rounded([0, 1, ROOT_2, 1]));
  expect(await told(page, 'one', 'load')).toMatchObject([{ name: 'square.off', inputVertices: 4 }]);
  expect((await told(page, 'one', 'progress')).length).toBeGreaterThan(0);
  const frame = page.locator('iframe');
  await expect(frame).toHaveAttribute('title', 'A square');

  await page.evaluate(() => (window.viewer('one').sources = [{ vertex: 1, offset: 0.5 }]));
  await expect.poll(() => values(page, 'one')).toEqual([1.5, 0.5, 1.5, rounded([ROOT_2 + 0.5])[0]]);
  await expect(page.locator('heatwalk-viewer')).toHaveAttribute('sources', '1@0.5');
  const asked = await page.evaluate(async () => {
    const one = window.viewer('one');
    one.setAttribute('walker', '3');
    const path = await one.path();
    const blob = await one.toBlob({ scale: 2 });
    return { length: path?.length, type: blob.type, sources: one.sources, walker: one.walker };
  });
  expect(asked).toMatchObject({ type: 'image/png', sources: [{ vertex: 1, offset: 0.5 }], walker: { vertex: 3 } });
  expect(asked.length).toBeCloseTo(ROOT_2, 6);
  // What was set is no news.
  expect(await told(page, 'one', 'sourcechange')).toEqual([]);
  expect(await told(page, 'one', 'error')).toEqual([]);

  // The middle of the square is the middle of the picture.
  const box = await frame.boundingBox();
  if (!box) throw new Error('the frame is not in view');
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await expect.poll(async () => (await told(page, 'one', 'sourcechange')).length).toBeGreaterThan(0);
  expect((await told(page, 'one', 'pick')).length).toBe(1);
  await expect.poll(async () => (await values(page, 'one'))[1]).toBeGreaterThan(0.5);

  await page.evaluate(() => window.viewer('one').setAttribute('look', 'nothing'));
  await expect
    .poll(() => told(page, 'one', 'error'))
    .toEqual([{ message: expect.stringContaining('look=nothing: no such value.') }]);
  await page.evaluate(() => window.viewer('one').setAttribute('look', 'gold'));
  await page.evaluate(() => window.viewer('one').setAttribute('src', 'missing.off'));
  await expect
    .poll(async () => (await told(page, 'one', 'error')).at(-1))
    .toEqual({ message: expect.stringContaining('missing.off') });
});

test('two viewers show triangles of the page each, one of them once it is in view, and give all back', async ({
  page,
}) => {
  const far = `<div style="height: 3000px"></div>${viewer('two', 'sources="3" loading="lazy"')}`;
  await open(page, viewer('one', 'sources="0"') + far);
  await page.evaluate(() => {
    const positions = [0, 0, 0, 3, 0, 0, 3, 4, 0];
    window.viewer('one').mesh = { positions };
    window.viewer('two').mesh = { positions: [...positions, 0, 4, 0], indices: new Uint16Array([0, 1, 2, 0, 2, 3]) };
  });
  await expect.poll(() => values(page, 'one')).toEqual([0, 3, 5]);
  await expect(page.locator('iframe')).toHaveCount(1);
  expect(
    await page.evaluate(() =>
      window
        .viewer('two')
        .distance()
        .catch((error) => error.message),
    ),
  ).toContain('Nothing is shown');
  await page.locator('#two').scrollIntoViewIfNeeded();
  await expect.poll(() => values(page, 'two')).toEqual([4, 5, 3, 0]);
  expect(await values(page, 'one')).toEqual([0, 3, 5]);

  const ended = await page.evaluate(async () => {
    const one = window.viewer('one');
    const asked = one.distance().catch((error: Error) => error.message);
    // It is on its way to the frame, and no answer can have come.
    for (let turn = 0; turn < 5; turn++) await Promise.resolve();
    one.remove();
    const message = await asked;
    document.body.append(one);
    return message;
  });
  expect(ended).toContain('closed');
  await expect.poll(() => page.evaluate(() => window.heard.filter(({ type }) => type === 'load').length)).toBe(3);
  const again = await page.evaluate(async () => Array.from((await window.viewer('one').distance())?.values ?? []));
  expect(again).toEqual([0, 3, 5]);
  expect(await told(page, 'one', 'error')).toEqual([]);
});

test('where no page answers, an error says so', async ({ page }) => {
  await page.clock.install();
  await open(page, viewer('one', 'src="square.off"', `${app.page}nothing/`));
  await page.locator('iframe').waitFor();
  await page.waitForTimeout(500);
  await page.clock.fastForward(60_000);
  await expect
    .poll(() => told(page, 'one', 'error'))
    .toEqual([{ message: expect.stringMatching(/nothing\/ does not answer; give the address of a build/) }]);
});

test('nobody but the page is heard: neither another frame nor what the own frame is led to', async ({ page }) => {
  const lie = { heatwalk: 1, event: 'error', detail: { message: 'a lie' } };
  const lying = `<script>setInterval(() => parent.postMessage(${JSON.stringify(lie)}, '*'), 50)</script>`;
  const stranger = await Host.start({}, { '/stranger.html': lying });
  // Of the same origin as the page, which is no reason to hear it.
  built.pages['/stranger.html'] = lying;
  try {
    const other = `<iframe src="${new URL('/stranger.html', built.page).href}"></iframe>`;
    await open(page, viewer('one', 'preset="icosphere"') + other);
    await expect.poll(async () => (await told(page, 'one', 'load')).length).toBe(1);
    await page.evaluate((away) => {
      const frame = window.viewer('one').shadowRoot?.querySelector('iframe');
      window.addEventListener('message', ({ data, source }) => {
        if (data.detail?.message !== 'a lie') return;
        window.heard.push({ id: 'page', type: source === frame?.contentWindow ? 'own lie' : 'lie', detail: {} });
      });
      // As a link in it would, and the address in the element stays.
      frame?.contentWindow?.location.replace(away);
    }, `${stranger.other}/stranger.html`);
    const own = () => page.evaluate(() => window.heard.filter(({ type }) => type === 'own lie').length);
    await expect.poll(own).toBeGreaterThan(0);
    expect((await told(page, 'page', 'lie')).length).toBeGreaterThan(0);
    expect(await told(page, 'one', 'error')).toEqual([]);
  } finally {
    await stranger.stop();
  }
});
