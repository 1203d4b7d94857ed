/** No mesh ends the page: what cannot be opened changes nothing, and what is lost is made anew. */
import type { Page } from '@playwright/test';
import { grid, off, sphere } from '../fixtures';
import { difference, expect, type HeatwalkPage, openSection, SEEN, test } from '../page';
import { runInWorkers } from '../worker';

test.use(SEEN);

const N = 24;
const GRID = off(grid(N));
const at = (i: number, j: number) => i + (N + 1) * j;
const SOURCES = [at(3, 4), at(20, 20)];
const OPTIONS = `s=${SOURCES.join(',')}&w=${at(20, 2)}&b=dirichlet&refine=0&show=edges&crowd=20&look=lagoon`;

const BALL = off(sphere(16));

/** A module whose one function, `trap`, divides by zero. */
const TRAP = [
  [0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00],
  [0x01, 0x04, 0x01, 0x60, 0x00, 0x00],
  [0x03, 0x02, 0x01, 0x00],
  [0x07, 0x08, 0x01, 0x04, 0x74, 0x72, 0x61, 0x70, 0x00, 0x00],
  [0x0a, 0x0a, 0x01, 0x08, 0x00, 0x41, 0x01, 0x41, 0x00, 0x6d, 0x1a, 0x0b],
].flat();

/** In the page: the next call of a function of WebGL ends as in a module that traps. */
function trapIn({ bytes, name }: { bytes: readonly number[]; name: 'bufferData' | 'createFramebuffer' }): void {
  const { trap } = new WebAssembly.Instance(new WebAssembly.Module(Uint8Array.from(bytes))).exports;
  const { prototype } = WebGL2RenderingContext;
  const original = prototype[name];
  const trapping = () => {
    Object.assign(prototype, { [name]: original });
    return (trap as () => never)();
  };
  Object.assign(prototype, { [name]: trapping });
}

/** What must outlive whatever fails. */
async function everything(heatwalk: HeatwalkPage) {
  const { page } = heatwalk;
  return {
    scene: await heatwalk.scene(),
    mesh: await heatwalk.mesh(),
    field: await distances(heatwalk),
    camera: await page.evaluate(() => window.heatwalk.camera),
    fragment: new URL(page.url()).hash,
    heading: await page.locator('.heading').innerText(),
    sources: await page.locator('#section-sources').innerText(),
  };
}

const distances = ({ page }: HeatwalkPage) =>
  page.evaluate(
    (count) => Array.from({ length: count }, (_, vertex) => window.heatwalk.distanceAt({ vertex })),
    (N + 1) ** 2,
  );

async function openGrid(heatwalk: HeatwalkPage): Promise<void> {
  await heatwalk.openFile('grid.off', GRID, OPTIONS);
  await expect(heatwalk.page).toHaveURL(/hash=[\da-f]{64}/);
}

test('a mesh that cannot be drawn changes nothing, and the next one opens', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await heatwalk.rest();
  const before = await everything(heatwalk);
  const picture = await heatwalk.lastPicture();
  await page.evaluate(trapIn, { bytes: TRAP, name: 'bufferData' as const });
  await heatwalk.drop([['ball.off', BALL]]);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('ball.off was not opened: The renderer failed and was restarted');
  await heatwalk.rest();
  expect(await everything(heatwalk)).toEqual(before);
  await expect.poll(async () => difference(picture, await heatwalk.picture())).toBe(0);

  await page.mouse.click(...(await heatwalk.pixelOnModel()));
  await expect.poll(async () => (await heatwalk.scene()).sources).toHaveLength(1);
  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  await expect(alert).toBeEmpty();
});

test('a renderer that traps while it is made says so, and another one can be asked for', async ({ heatwalk, page }) => {
  await page.addInitScript(trapIn, { bytes: TRAP, name: 'createFramebuffer' as const });
  await page.goto('./#v=1&m=teapot');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('The scene cannot be drawn');
  expect(await page.evaluate(() => window.heatwalk.backend)).toBeNull();
  await alert.getByRole('button', { name: 'Try again' }).click();
  await expect.poll(() => page.evaluate(() => window.heatwalk.backend)).not.toBeNull();
  await expect(alert).toBeEmpty();
  await heatwalk.settled();
  expect((await heatwalk.picture()).width).toBeGreaterThan(0);
});

test('coordinates near the limits of floating point are drawn or refused, and the next mesh opens', async ({
  heatwalk,
  page,
}) => {
  await openGrid(heatwalk);
  const { positions, triangles } = sphere(16);
  const far = positions.map(([x, y, z]) => [1e25 * (x + 1), 1e25 * y, 1e25 * z] as [number, number, number]);
  await heatwalk.drop([['far.off', off({ positions: far, triangles })]]);
  const outcome = page.locator('.message', { hasText: 'far.off' });
  await expect(outcome).toBeVisible();
  await heatwalk.settled();
  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  await expect(page.getByRole('alert')).toBeEmpty();
  expect((await heatwalk.field()).maxDistance).toBeCloseTo(Math.PI, 1);
  const solves = await heatwalk.solves();
  await page.mouse.click(...(await heatwalk.pixelOnModel()));
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
});

test('after a trap the solver restarts with the same scene', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  const [first] = page.workers();
  await page.keyboard.press('Enter');
  await heatwalk.settled();
  const solves = await heatwalk.solves();
  const { sources } = await heatwalk.scene();
  // The clock is read between the steps of every answer.
  await first.evaluate((bytes) => {
    const { trap } = new WebAssembly.Instance(new WebAssembly.Module(Uint8Array.from(bytes))).exports;
    performance.now = trap as () => number;
  }, TRAP);
  await page.keyboard.press('Control+z');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText(/stopped unexpectedly \(divide by zero\)\. The solver was restarted/);
  await heatwalk.settled();
  expect(page.workers()).not.toContain(first);
  expect(await heatwalk.solves()).toBe(solves + 1);
  const after = await heatwalk.scene();
  expect(after.sources).toEqual(SOURCES.map((vertex) => ({ vertex })));
  expect(after.parameters.boundary).toBe('dirichlet');
  for (const vertex of SOURCES) expect(await heatwalk.distanceAt({ vertex })).toBe(0);
  expect(await page.evaluate(() => window.heatwalk.walker?.length)).toBeGreaterThan(0.5);

  // Undo goes on where it was.
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => heatwalk.solves()).toBe(solves + 2);
  expect((await heatwalk.scene()).sources).toEqual(sources);
});

test('a solver that stops while idle restarts with the same scene', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await heatwalk.settled();
  const before = await everything(heatwalk);
  const picture = await heatwalk.picture();
  await page.workers()[0].evaluate(() => {
    setTimeout(() => {
      throw new Error('a defect');
    });
  });
  await expect(page.getByRole('alert')).toContainText('The solver was restarted; the scene is unchanged.');
  await heatwalk.settled();
  expect(await everything(heatwalk)).toEqual(before);
  await expect.poll(async () => difference(picture, await heatwalk.picture())).toBe(0);
});

test('a query that traps every solver is sent only twice', async ({ heatwalk, page }) => {
  let sent = 0;
  page.on('console', (message) => {
    if (message.text() === 'three sources') sent += 1;
  });
  await runInWorkers(
    page,
    `addEventListener('message', (event) => {
      const { path, argumentList } = event.data;
      if (path?.[0] !== 'solve' || argumentList[0].value.length !== 3) return;
      event.stopImmediatePropagation();
      console.info('three sources');
      throw new Error('three');
    });`,
  );
  await openGrid(heatwalk);
  const before = await distances(heatwalk);
  await page.keyboard.press('Shift+Enter');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('The solver stopped unexpectedly (Uncaught Error: three).');
  await expect(alert.getByRole('button', { name: 'Open the mesh again' })).toBeVisible();
  await heatwalk.settled();
  await expect.poll(() => sent).toBe(2);
  // What is shown stays of use, and another question is answered.
  expect(await distances(heatwalk)).toEqual(before);
  await page.keyboard.press('Control+z');
  await expect(alert).toContainText('The solver was restarted');
  expect(await distances(heatwalk)).toEqual(before);
  expect(sent).toBe(2);
});

/** Answers each step of refinement of a worker but the first with an error of this name and message, and counts them. */
async function refuseToRefine(page: Page, name: string, message: string): Promise<() => number> {
  let asked = 0;
  page.on('console', (told) => {
    if (told.text() === 'a second step') asked += 1;
  });
  await runInWorkers(
    page,
    `let steps = 0;
      addEventListener('message', (event) => {
        const { id, path } = event.data;
        if (path?.[0] !== 'refine' || ++steps === 1) return;
        event.stopImmediatePropagation();
        console.info('a second step');
        const value = { isError: true, value: { name: '${name}', message: '${message}', stack: '' } };
        postMessage({ id, type: 'HANDLER', name: 'throw', value });
      });`,
  );
  return () => asked;
}

/** Takes many steps to be refined. */
const FINE = off(sphere(80));

test('where memory does not suffice to refine on, what is exact stays', async ({ heatwalk, page }) => {
  const asked = await refuseToRefine(page, 'out-of-memory', 'no memory');
  await heatwalk.openFile('fine.off', FINE, 's=0&w=2000&method=auto&windows=2');
  const [first] = page.workers();
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('memory');
  const { exactBelow, refineMs } = await heatwalk.field();
  expect(refineMs).toBeGreaterThan(0);
  await openSection(page, 'solver');
  await expect(page.locator('#section-solver').getByRole('status')).toHaveText(
    /^By propagation with 2 windows: exact below .* Refinement stopped because memory ran out\.$/,
  );
  await expect(page.getByRole('alert')).toBeEmpty();
  expect(page.workers()).toContain(first);

  // The walker asks for no more.
  const before = asked();
  await page.keyboard.down('Alt');
  await page.mouse.click(...(await heatwalk.pixelOnModel(0.05, 0.05)));
  await page.keyboard.up('Alt');
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('memory');
  expect((await heatwalk.field()).exactBelow).toBe(exactBelow);
  expect(asked()).toBe(before);
});

test('a solver that refinement ends for want of memory restarts, and the mesh is not refined again', async ({
  heatwalk,
  page,
}) => {
  const asked = await refuseToRefine(page, 'RuntimeError', 'unreachable');
  await heatwalk.openFile('fine.off', FINE, 's=0&w=2000&method=exact&windows=2');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText(
    /^Refinement needed more memory than the browser gives; distances were exact below [\d.]+ m \(assumed\)\. The solver was restarted/,
  );
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('memory');
  expect((await heatwalk.field()).windows).toBe(2);
  const [solves, before] = [await heatwalk.solves(), asked()];
  await page.locator('.stage').press('Enter');
  await expect.poll(() => heatwalk.solves()).toBe(solves + 1);
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('memory');
  expect(asked()).toBe(before);

  // Another mesh is.
  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  await expect.poll(() => heatwalk.refining()).not.toBe('memory');
});
