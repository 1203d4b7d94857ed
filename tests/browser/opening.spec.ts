/** Large meshes: drawn before they are solved, and the former scene comes back where they are not. */
import type { Page } from '@playwright/test';
import { crossings, difference, expect, type HeatwalkPage, SEEN, test } from '../page';
import { off, sphere } from '../fixtures';
import { runInWorkers, workerThatPrints } from '../worker';

test.use(SEEN);

/** Drops a torus of 4 n² triangles, made in the page because it is too large to be sent there. */
async function dropTorus(page: Page, name: string, n: number): Promise<void> {
  await page.evaluate(
    ([file, around]) => {
      const along = 2 * around;
      const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${along * around}\nproperty float x\nproperty float y\nproperty float z\nelement face ${2 * along * around}\nproperty list uchar int vertex_indices\nend_header\n`;
      const body = new DataView(new ArrayBuffer(along * around * (12 + 2 * 13)));
      let at = 0;
      for (let i = 0; i < along; i++) {
        for (let j = 0; j < around; j++) {
          const [a, b] = [(2 * Math.PI * i) / along, (2 * Math.PI * j) / around];
          const radius = 1 + 0.4 * Math.cos(b);
          for (const value of [radius * Math.cos(a), 0.4 * Math.sin(b), radius * Math.sin(a)]) {
            body.setFloat32(at, value, true);
            at += 4;
          }
        }
      }
      const vertex = (i: number, j: number) => (i % along) * around + (j % around);
      for (let i = 0; i < along; i++) {
        for (let j = 0; j < around; j++) {
          const [p, q, r, s] = [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)];
          for (const triangle of [
            [p, q, r],
            [p, r, s],
          ]) {
            body.setUint8(at, 3);
            triangle.forEach((corner, k) => body.setInt32(at + 1 + 4 * k, corner, true));
            at += 13;
          }
        }
      }
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([header, body], file));
      document.body.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer }));
    },
    [name, n] as const,
  );
}

/** Notes what the loading bar says, stage after stage. */
async function stages(page: Page): Promise<() => Promise<string[]>> {
  await page.evaluate(() => {
    const said: string[] = [];
    const bar = document.querySelector('.loading-stage');
    const note = () => said.push(/: ([a-z]+)/.exec(bar?.textContent ?? '')?.[1] ?? '');
    if (bar) new MutationObserver(note).observe(bar, { childList: true });
    Object.assign(window, { said });
  });
  return () =>
    page.evaluate(() => {
      const { said } = window as unknown as { said: string[] };
      return said.filter((stage, i) => stage !== '' && stage !== said[i - 1]);
    });
}

test(
  'a mesh of a million triangles shows its stripes before anything is factored',
  { tag: '@slow' },
  async ({ heatwalk, page }) => {
    await heatwalk.open('#v=1&m=file&name=torus.ply&method=auto&refine=0&cam=0,1.2,3,0,0,0');
    const said = await stages(page);
    await dropTorus(page, 'torus.ply', 500);
    await expect.poll(async () => (await heatwalk.mesh()).name, { timeout: 60_000 }).toBe('torus.ply');
    expect(await said()).toEqual(['fetching', 'reading', 'welding', 'drawing', 'propagating']);
    expect(await heatwalk.mesh()).toMatchObject({ triangles: 1_000_000, vertices: 500_000, components: 1 });
    expect(await page.evaluate(() => window.heatwalk.factorNonzeros)).toBe(0);
    const { sources } = await heatwalk.scene();
    expect(await heatwalk.distanceAt(sources[0])).toBe(0);
    expect(await stripesAcross(heatwalk, 500)).toBeGreaterThanOrEqual(4);
  },
);

/** Across the ring of a torus, from its outer edge to the hole. */
async function stripesAcross(heatwalk: HeatwalkPage, n: number): Promise<number> {
  const first = 0.25 * n * n;
  const [outer, inner] = [await heatwalk.pixelOf({ vertex: first }), await heatwalk.pixelOf({ vertex: first + n / 2 })];
  return crossings(await heatwalk.picture(), outer[0], inner[1], outer[1]);
}

/**
 * A worker keeps back its first answer to a mesh from a file. The first that does is told to `release` it or to `refuse`, once it
 * has been asked.
 */
async function holdFirstAnswers(page: Page): Promise<(what: 'release' | 'refuse') => Promise<void>> {
  const held = workerThatPrints(page, 'held');
  await runInWorkers(
    page,
    `let isFile = false;
      let kept = null;
      addEventListener('message', (event) => {
        const { path, argumentList } = event.data;
        isFile ||= path?.[0] === 'open' && argumentList[0].value.kind === 'files';
        if (!isFile || path?.[0] !== 'propagate' || event.data === kept) return;
        event.stopImmediatePropagation();
        kept = event.data;
        console.info('held');
      });
      self.release = () => dispatchEvent(new MessageEvent('message', { data: kept }));
      self.refuse = () => {
        const value = { isError: true, value: { name: 'Error', message: 'no answer', stack: '' } };
        postMessage({ id: kept.id, type: 'HANDLER', name: 'throw', value });
      };`,
  );
  return async (what) => {
    await (await held).evaluate((method) => void (self as unknown as Record<string, () => void>)[method]?.(), what);
  };
}

const RINGS = 160;
const TRIANGLES = 4 * RINGS ** 2;

async function preview(heatwalk: HeatwalkPage): Promise<void> {
  const { page } = heatwalk;
  await dropTorus(page, 'torus.ply', RINGS);
  await expect(page.locator('.heading')).toContainText('torus.ply');
  await expect(page.locator('.heading')).toContainText(`${TRIANGLES.toLocaleString('en')} triangles`);
  await heatwalk.rest();
}

async function former(heatwalk: HeatwalkPage) {
  const { page } = heatwalk;
  return {
    scene: await heatwalk.scene(),
    mesh: await heatwalk.mesh(),
    camera: await page.evaluate(() => window.heatwalk.camera),
    fragment: new URL(page.url()).hash,
    heading: await page.locator('.heading').innerText(),
    walker: await page.evaluate(() => window.heatwalk.walker),
  };
}

test('a large mesh is drawn before its first answer, and keeps its view when that comes', async ({
  heatwalk,
  page,
}) => {
  const tell = await holdFirstAnswers(page);
  await heatwalk.open('#v=1&m=teapot&refine=0');
  const teapot = await heatwalk.picture();
  await preview(heatwalk);
  // The scene goes on behind it, out of reach.
  expect((await heatwalk.scene()).mesh).toEqual({ kind: 'preset', id: 'teapot' });
  expect((await heatwalk.mesh()).name).not.toBe('torus.ply');
  const [x, y] = await page.evaluate(() => window.heatwalk.centre);
  for (let shift = 0; shift < 300; shift += 20) {
    expect(await page.evaluate(([px, py]) => window.heatwalk.placeAt(px, py), [x + shift, y])).toBeNull();
  }
  await expect(page.getByRole('status').filter({ hasText: 'torus.ply:' })).toContainText('propagating');
  const plain = await heatwalk.screen();
  expect(difference(teapot, plain)).toBeGreaterThan(0.1);
  // It is turned like any other.
  await page.keyboard.press('ArrowLeft');
  await heatwalk.rest();
  const turned = await page.evaluate(() => window.heatwalk.camera);
  expect(difference(plain, await heatwalk.screen())).toBeGreaterThan(0.005);

  await tell('release');
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('torus.ply');
  await heatwalk.rest();
  expect(await page.evaluate(() => window.heatwalk.camera)).toEqual(turned);
  await expect.poll(async () => (await heatwalk.scene()).camera).toEqual(turned);
  expect((await heatwalk.scene()).mesh).toMatchObject({ kind: 'file', name: 'torus.ply' });
  expect(difference(plain, await heatwalk.picture())).toBeGreaterThan(0.1);
  expect(
    await page.evaluate(([px, py]) => window.heatwalk.placeAt(px, py), await heatwalk.pixelOf({ vertex: 0 })),
  ).not.toBeNull();
});

for (const [end, sentence] of [
  ['a failure', /torus\.ply was not opened: no answer/],
  ['Cancel', null],
] as const) {
  const title = `${end} after the first picture brings back the former scene, with what was changed behind it`;
  test(title, { tag: '@page' }, async ({ heatwalk, page }) => {
    const tell = await holdFirstAnswers(page);
    await heatwalk.open('#v=1&m=teapot&refine=0&show=edges');
    await page.mouse.click(...(await heatwalk.pixelOnModel()));
    await heatwalk.settled();
    await expect(page).toHaveURL(/&s=144:/);
    await heatwalk.rest();
    const before = await former(heatwalk);
    // Without the ring around what has the focus.
    const picture = await heatwalk.drawing(1, false);
    await preview(heatwalk);
    await page.keyboard.press('ArrowLeft');
    await heatwalk.rest();
    expect(difference(picture, await heatwalk.screen())).toBeGreaterThan(0.1);

    if (sentence) {
      await tell('refuse');
      await expect(page.getByRole('alert')).toContainText(sentence);
    } else {
      await page.getByRole('button', { name: 'Cancel' }).click();
    }
    await heatwalk.settled();
    await expect.poll(async () => difference(picture, await heatwalk.drawing(1, false))).toBe(0);
    expect(await former(heatwalk)).toEqual(before);

    // Undone behind the picture of another mesh, the source is back where it was.
    await preview(heatwalk);
    const solves = await heatwalk.solves();
    await page.keyboard.press('Control+z');
    await expect.poll(() => heatwalk.solves()).toBe(solves + 1);
    await page.getByRole('button', { name: 'Cancel' }).click();
    await heatwalk.settled();
    expect((await heatwalk.scene()).sources).not.toEqual(before.scene.sources);
    expect(difference(picture, await heatwalk.drawing(1, false))).toBeGreaterThan(0.01);
    expect(await page.evaluate(() => window.heatwalk.field)).not.toBeNull();
  });
}

test('what reads files is there before the first of them', async ({ heatwalk, page }) => {
  const asked: string[] = [];
  page.context().on('request', (request) => {
    if (/heatwalk_reader_bg/.test(request.url())) asked.push(request.url());
  });
  await heatwalk.open('#m=icosphere');
  await expect.poll(() => asked.length).toBe(1);
  await heatwalk.dropAndOpen([['ball.off', off(sphere(8))]]);
  // The worker after that has one too, from the store of the browser.
  expect(new Set(asked).size).toBe(1);
});
