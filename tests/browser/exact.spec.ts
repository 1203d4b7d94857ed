import { grid, off, sphere } from '../fixtures';
import type { MeshPoint } from '../../web/protocol';
import { expect, type HeatwalkPage, openSection, test } from '../page';

const N = 24;
const GRID = off(grid(N));
const at = (i: number, j: number) => i + (N + 1) * j;
const SOURCE = at(6, 8);
/** Of values near 1 in 32-bit floats. */
const ROUNDING = 1e-6;

/** The largest difference between the distances shown and those in the plane, over all vertices. */
function largestError(heatwalk: HeatwalkPage, [x, y]: readonly [number, number], start = 0): Promise<number> {
  return heatwalk.page.evaluate(
    ([n, sourceX, sourceY, value]) => {
      let worst = 0;
      for (let j = 0; j <= n; j++) {
        for (let i = 0; i <= n; i++) {
          const exact = value + Math.hypot(i / n - sourceX, j / n - sourceY);
          const shown = window.heatwalk.distanceAt({ vertex: i + (n + 1) * j });
          worst = Math.max(worst, Math.abs(shown - exact));
        }
      }
      return worst;
    },
    [N, x, y, start] as const,
  );
}

test('on a flat grid every distance is refined to that of the plane', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${SOURCE}&w=${at(20, 22)}&near=0`);
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('exact');
  expect(await heatwalk.field()).toMatchObject({ exactBelow: Infinity, exactShare: 1 });
  expect(await largestError(heatwalk, [6 / N, 8 / N])).toBeLessThan(ROUNDING);
  await expect(page.locator('.exactness')).toHaveText('exact');

  const { error } = await heatwalk.field();
  if (!error) throw new Error('nothing to compare with');
  expect(error.mean).toBeGreaterThan(0);
  expect(error.max).toBeGreaterThan(error.mean);
  // Next to the source heat alone is off by 15 to 20 %.
  expect(error.max).toBeLessThan(0.5);
  await openSection(page, 'solver');
  await expect(page.locator('#section-solver').getByRole('status')).toHaveText(
    /^Exact\. Error of the heat method: mean [\d.]+ %, maximum [\d.]+ %\.$/,
  );
});

test('distances in faces are exact once all is, also under the pointer', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${SOURCE}&w=${at(20, 22)}&refine=0`);
  await heatwalk.settled();
  const exactAt = (point: MeshPoint) => page.evaluate((place) => window.heatwalk.exactDistanceAt(place), point);
  const [x, y] = await heatwalk.pixelOnModel();
  const place = await page.evaluate(([px, py]) => window.heatwalk.placeAt(px, py), [x, y] as const);
  if (!place || !('face' in place)) throw new Error('no face under the pointer');
  await page.mouse.move(x, y);
  const readout = page.locator('.readout');
  await expect(readout).toHaveText(/^≈ /);
  expect(await exactAt(place)).toBeNull();

  await openSection(page, 'solver');
  await page.getByRole('switch', { name: 'Refine to exact' }).check();
  await expect.poll(() => heatwalk.refining()).toBe('exact');
  const corners = grid(N).triangles[place.face].map((vertex) => grid(N).positions[vertex]);
  const whole = place.weights.reduce((sum, weight) => sum + weight, 0);
  const mean = (axis: number) =>
    place.weights.reduce((sum, weight, corner) => sum + (weight / whole) * corners[corner][axis], 0);
  const expected = Math.hypot(mean(0) - 6 / N, mean(1) - 8 / N);
  expect(Math.abs(((await exactAt(place)) ?? 0) - expected)).toBeLessThan(1e-12);
  expect(await exactAt({ vertex: SOURCE })).toBe(0);
  await page.mouse.move(x, y);
  await expect(readout).toHaveText(/^[\d.]+ /);
});

test('refinement can be switched off and on', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${SOURCE}&near=0&refine=0`);
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('off');
  const { exactBelow, refineMs } = await heatwalk.field();
  expect([exactBelow, refineMs]).toEqual([0, 0]);
  const instant = await largestError(heatwalk, [6 / N, 8 / N]);
  expect(instant).toBeGreaterThan(ROUNDING);
  expect(instant).toBeLessThan(0.1);

  const solves = await heatwalk.solves();
  await openSection(page, 'solver');
  await page.getByRole('switch', { name: 'Refine to exact' }).check();
  await heatwalk.settled();
  expect((await heatwalk.field()).refineMs).toBeGreaterThan(0);
  expect(await heatwalk.solves()).toBe(solves);
  await expect(page).not.toHaveURL(/refine=/);
  expect(await heatwalk.refining()).toBe('exact');
  await expect(page.locator('.exactness')).toHaveText('exact');
});

test('refinement that is switched off gives way to the field of the method, on screen, in the link and in lines', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.openFile('grid.off', GRID, `s=${SOURCE}&near=0&refine=0`);
  await heatwalk.settled();
  const instant = await largestError(heatwalk, [6 / N, 8 / N]);
  await heatwalk.openFile('grid.off', GRID, `s=${SOURCE}&near=0`);
  await heatwalk.settled();
  await openSection(page, 'solver');
  await page.getByRole('switch', { name: 'Refine to exact' }).uncheck();
  await expect(page.locator('.exactness')).toHaveText('heat method');
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('off');
  expect(await heatwalk.field()).toMatchObject({ exactBelow: 0, refineMs: 0 });
  expect(await largestError(heatwalk, [6 / N, 8 / N])).toBe(instant);
  await expect(page).toHaveURL(/refine=0/);

  await openSection(page, 'export');
  await page.getByRole('button', { name: 'Copy lines' }).click();
  await expect(page.getByLabel('Lines that reproduce the distances')).toHaveValue(/--method heat --near 0 /);
});

test('moving a source ends the refinement, and the new field is refined', async ({ heatwalk, page }) => {
  await heatwalk.openFile('ball.off', off(sphere(110)), 's=0&near=0');
  await heatwalk.settled();
  const solves = await heatwalk.solves();
  // In one go on the page, because a refinement lasts no longer than a few messages of the test.
  const seen = await page.evaluate(async () => {
    const phases: string[] = [];
    const note = () => phases.push(window.heatwalk.refining);
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }));
    note();
    while (['solving', 'resting'].includes(window.heatwalk.refining))
      await new Promise((resolve) => setTimeout(resolve));
    note();
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'z', ctrlKey: true, bubbles: true }));
    note();
    await window.heatwalk.settled();
    note();
    return phases;
  });
  expect(seen).toEqual(['solving', 'refining', 'solving', 'exact']);
  expect(await heatwalk.solves()).toBe(solves + 2);
  expect((await heatwalk.scene()).sources).toEqual([{ vertex: 0 }]);
  expect(await heatwalk.distanceAt({ vertex: 0 })).toBe(0);
  // Straight down the meridians of 110 rings, whose chords are a little shorter than their arcs.
  expect((await heatwalk.field()).maxDistance).toBeCloseTo(Math.PI, 3);
});

test('a drag shows the heat method, and its end starts refinement', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await page.mouse.click(...(await heatwalk.pixelOnModel()));
  await heatwalk.settled();
  const [x, y] = await heatwalk.pixelOf((await heatwalk.scene()).sources[0]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 10, { steps: 3 });
  const solves = await heatwalk.solves();
  await page.mouse.move(x + 30, y + 10);
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
  // Longer than a rest takes.
  await page.waitForTimeout(600);
  expect(await heatwalk.refining()).toBe('solving');
  expect((await heatwalk.field()).refineMs).toBe(0);
  await page.mouse.up();
  await heatwalk.settled();
  expect((await heatwalk.field()).refineMs).toBeGreaterThan(0);
});

test('placing the walker keeps the refined field', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${SOURCE}&w=${at(20, 22)}`);
  await heatwalk.settled();
  const before = await heatwalk.field();
  await page.keyboard.down('Alt');
  await page.mouse.click(...(await heatwalk.pixelOnModel(0.05, 0.05)));
  await page.keyboard.up('Alt');
  await expect.poll(async () => (await heatwalk.scene()).walker).toHaveProperty('face');
  await heatwalk.settled();
  expect(await heatwalk.field()).toEqual(before);
  expect(await heatwalk.refining()).toBe('exact');
});

test('a source has the initial distance that is typed', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${SOURCE}`);
  const initial = page.getByRole('spinbutton', { name: 'Initial distance of source 1' });
  await expect(initial).toHaveValue('0');
  await initial.fill('0.25');
  await expect(page).toHaveURL(new RegExp(`s=${SOURCE}@0.25`));
  await expect.poll(() => heatwalk.distanceAt({ vertex: SOURCE })).toBe(0.25);
  await heatwalk.settled();
  expect(await largestError(heatwalk, [6 / N, 8 / N], 0.25)).toBeLessThan(ROUNDING);

  await initial.fill('-1');
  await initial.blur();
  await expect(initial).toHaveValue('0.25');
  await page.keyboard.press('Control+z');
  await expect(initial).toHaveValue('0');
  await expect.poll(() => heatwalk.distanceAt({ vertex: SOURCE })).toBe(0);
});

test('initial distances decide which source is nearer', async ({ heatwalk }) => {
  // Between two sources 1 apart, the second of which starts at 0.5, the border lies at three quarters.
  await heatwalk.openFile('grid.off', GRID, `s=${at(0, 0)},${at(N, 0)}@0.5`);
  await heatwalk.settled();
  const distance = (i: number) => heatwalk.distanceAt({ vertex: at(i, 0) });
  expect(await distance((3 * N) / 4)).toBeCloseTo(0.75, 5);
  expect(await distance(N)).toBeCloseTo(0.5, 5);
});
