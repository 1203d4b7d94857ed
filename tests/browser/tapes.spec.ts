import { readFile } from 'node:fs/promises';
import { grid, off } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';

const N = 24;
const at = (i: number, j: number) => ({ vertex: i + (N + 1) * j });
/** The unit square seen from above. */
const VIEW = `up=z&cam=0,1.5,2.6,0,0,0&s=${at(0, 0).vertex}&method=auto`;
/** Pixels are small beside the square. */
const PIXEL = 0.006;

async function click(heatwalk: HeatwalkPage, place: { vertex: number }): Promise<void> {
  const [x, y] = await heatwalk.pixelOf(place);
  await heatwalk.page.mouse.click(x + 1, y + 1);
}

const tapes = (heatwalk: HeatwalkPage) => heatwalk.page.evaluate(() => window.heatwalk.tapes);

/** Until the newest tape has so many legs, all exact. */
async function exact(heatwalk: HeatwalkPage, legs: number) {
  await expect
    .poll(async () => (await tapes(heatwalk)).at(-1)?.legs.map(({ state }) => state))
    .toEqual(Array.from({ length: legs }, () => 'exact'));
  const newest = (await tapes(heatwalk)).at(-1);
  if (!newest) throw new Error('no tape');
  return newest;
}

test('a tape is laid, dragged, closed, told in a known scale, saved, undone, shared and charted', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.withoutLegend();
  await heatwalk.openFile('square.off', off(grid(N)), VIEW);
  await heatwalk.settled();
  await heatwalk.closeSummary();
  const solves = await heatwalk.solves();
  await page.keyboard.press('m');
  await expect(page.getByRole('button', { name: 'Measure' }).first()).toHaveAttribute('aria-pressed', 'true');
  await click(heatwalk, at(6, 6));
  await click(heatwalk, at(18, 6));
  const first = await exact(heatwalk, 1);
  expect(Math.abs((first.length ?? 0) - 0.5)).toBeLessThan(PIXEL);
  expect(first.legs[0].straight).toBeCloseTo(first.length ?? 0, 6);
  await expect(page.locator('.tape-label').first()).toHaveText(/^0\.\d+ m$/);

  // The last place is dragged; that is one step of undo.
  const [x, y] = await heatwalk.pixelOf(at(18, 18));
  const place = page.getByRole('button', { name: 'Tape 1, place 2' });
  await place.hover();
  await page.mouse.down();
  await page.mouse.move(x - 40, y + 30, { steps: 3 });
  await page.mouse.move(x, y, { steps: 3 });
  await page.mouse.up();
  await expect.poll(async () => (await exact(heatwalk, 1)).length).toBeCloseTo(Math.hypot(0.5, 0.5), 2);

  // A click on the first place closes the tape: a triangle of a quarter of half the square.
  await click(heatwalk, at(18, 6));
  await page.getByRole('button', { name: 'Tape 1, place 1' }).click();
  const ring = await exact(heatwalk, 3);
  expect(ring.closed).toBe(true);
  await expect.poll(async () => (await tapes(heatwalk))[0].area).toBeCloseTo(0.125, 2);
  expect(await heatwalk.solves()).toBe(solves);

  // No label lies on another one, and a screen reader is told.
  const meeting = () =>
    page.locator('.tape-label > span').evaluateAll((labels) => {
      const boxes = labels.map((label) => label.getBoundingClientRect());
      return boxes.flatMap((a, i) =>
        boxes.slice(i + 1).filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom),
      ).length;
    });
  expect(await meeting()).toBe(0);
  await expect(page.locator('.tape-layer [aria-live]')).toHaveText(/^Tape 1: 1\.7\d m, area 0\.12\d? m²\.$/);
  // From far away all of them are in one place.
  await page.evaluate(() => document.querySelector('.stage')?.dispatchEvent(new WheelEvent('wheel', { deltaY: 1500 })));
  await heatwalk.rest();
  expect(await meeting()).toBe(0);
  await page.keyboard.press('f');
  await heatwalk.rest();

  const section = await openSection(page, 'measure');
  await expect(section).toContainText('Area enclosed: 0.12');
  await expect(section.getByRole('row')).toHaveCount(5);
  await section.getByRole('spinbutton', { name: 'Known length of tape 1' }).fill('3.4');
  await section.getByRole('combobox', { name: 'Unit of the known length' }).selectOption('cm');
  await section.getByRole('button', { name: 'Set scale' }).click();
  await expect(section.locator('.tape-head')).toContainText('3.4 cm');
  await expect(page.locator('.tape-label.sum')).toContainText('Σ 3.4 cm');
  await expect(section).toContainText('cm².');

  const download = page.waitForEvent('download');
  await section.getByRole('button', { name: 'Save CSV' }).click();
  const lines = (await readFile(await (await download).path(), 'utf8')).trim().split('\r\n');
  expect(lines).toHaveLength(5);
  expect(lines[4]).toMatch(/^1,total,,,3\.4,/);

  // The picture holds a label where the page has it, twice as large.
  const label = await page.locator('.tape-label.sum > span').boundingBox();
  if (!label) throw new Error('no label');
  const picture = await heatwalk.drawing(2, false);
  // The picture is centered on the model, as the window is without the panel.
  const [x0, y0] = await page.evaluate(() => window.heatwalk.centre);
  const [dx, dy] = [picture.width / 4 - x0, picture.height / 4 - y0];
  const paper = (px: number, py: number) => {
    const start = 4 * (Math.round(2 * py) * picture.width + Math.round(2 * px));
    return [...picture.data.subarray(start, start + 3)];
  };
  expect(paper(dx + label.x + 3, dy + label.y + label.height / 2)).toEqual([255, 255, 255]);
  expect(paper(dx + label.x - 6, dy + label.y - 6)).not.toEqual([255, 255, 255]);

  const address = page.url();
  expect(address).toMatch(/&tape=[^&]*!/);
  await page.keyboard.press('Control+z');
  await expect(page.locator('.tape-label.sum')).toContainText('1.71 m');
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await tapes(heatwalk))[0].closed).toBe(false);
  await page.keyboard.press('Control+Shift+z');
  await page.keyboard.press('Control+Shift+z');
  await expect(page.locator('.tape-label.sum')).toContainText('Σ 3.4 cm');

  // By the keyboard: a place under the reticle, and one taken away.
  await page.locator('.stage').focus();
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await tapes(heatwalk)).length).toBe(2);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Tape 2, place 1' }).focus();
  await page.keyboard.press('Delete');
  await expect(page.locator('.stage')).toBeFocused();
  await expect.poll(async () => (await tapes(heatwalk)).length).toBe(1);

  await heatwalk.forgetFiles();
  await heatwalk.openFile('square.off', off(grid(N)), new URL(address).hash.replace(/^#v=1&m=file&name=[^&]*&/, ''));
  await exact(heatwalk, 3);
  await expect(page.locator('.tape-label.sum')).toContainText('Σ 3.4 cm');

  // Charts of the distance and of the tape, in the same scale.
  const charts = await openSection(page, 'charts');
  await expect(charts.getByRole('img')).toHaveCount(4);
  await expect(charts).toContainText('Along the tape (cm)');
  const chart = page.waitForEvent('download');
  await charts.getByRole('button', { name: 'Save Area within a distance as SVG' }).click();
  const file = await readFile(await (await chart).path(), 'utf8');
  expect(file).toMatch(/^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
  expect(file).not.toContain('var(');
});

test('a known length corrects the size, and leaves the unit that lengths are converted to', async ({
  heatwalk,
  page,
}) => {
  const options = `tape=${at(0, 0).vertex},${at(N, 0).vertex}&unit=m&shown=mm`;
  await heatwalk.openInSection('measure', 'grid.off', off(grid(N)), options);
  const section = page.locator('#section-measure');
  await expect(section.locator('.tape-head')).toContainText('1000 mm');
  await section.getByRole('spinbutton', { name: 'Known length of tape 1' }).fill('3.4');
  await section.getByRole('combobox', { name: 'Unit of the known length' }).selectOption('cm');
  await section.getByRole('button', { name: 'Set scale' }).click();
  await expect(section.locator('.tape-head')).toContainText('34 mm');
});

test('scripts that wait until the page has settled have the lengths of tapes', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&refine=0');
  for (let i = 0; i < 3; i++) {
    const states = await page.evaluate(async (first) => {
      await window.heatwalk.setTapes([{ points: [0, 700, 1500].map((vertex) => ({ vertex: vertex + first })) }]);
      await window.heatwalk.settled();
      return window.heatwalk.tapes.flatMap(({ legs }) => legs.map(({ state }) => state));
    }, i);
    expect(states).toEqual(['exact', 'exact']);
  }
});

test('a tap on its last place ends a tape, and the next begins another', async ({ heatwalk, page }) => {
  await heatwalk.withoutLegend();
  await heatwalk.open('#v=1&m=bunny');
  await page.getByRole('button', { name: 'Measure', exact: true }).first().click();
  const places = [await heatwalk.pixelOnModel(0), await heatwalk.pixelOnModel(0.05), await heatwalk.pixelOnModel(0.1)];
  for (const [x, y] of places.slice(0, 2)) await page.mouse.click(x, y);
  const laid = async () => (await heatwalk.scene()).tapes.map(({ points }) => points.length);
  await expect.poll(laid).toEqual([2]);
  await page.waitForFunction((since) => performance.now() > since + 400, await page.evaluate(() => performance.now()));
  await page.mouse.click(...places[1]);
  await page.mouse.click(...places[2]);
  await expect.poll(laid).toEqual([2, 1]);
});

test('Enter on its last place ends a tape, and adds nothing to its only one', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  await page.locator('.stage').focus();
  await page.keyboard.press('m');
  const laid = async () => (await heatwalk.scene()).tapes.map(({ points }) => points.length);
  for (const [keys, places] of [
    [['Enter'], [1]],
    [['Enter'], [1]],
    [['ArrowLeft', 'ArrowLeft'], [1]],
    [['Enter'], [2]],
    [['Enter'], [2]],
    [['ArrowUp', 'ArrowUp'], [2]],
    [['Enter'], [2, 1]],
  ] as const) {
    for (const key of keys) await page.keyboard.press(key);
    await heatwalk.rest();
    expect(await laid()).toEqual(places);
  }
});

test('tapes of a link are measured where another scene was before and nothing is refined', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#m=torus&refine=0&tape=20,90');
  await expect.poll(() => page.evaluate(() => window.heatwalk.tapes[0]?.legs[0].state)).toBe('exact');
  await page.evaluate(() => (location.hash = '#m=torus&refine=0'));
  await expect.poll(() => page.evaluate(() => window.heatwalk.tapes)).toEqual([]);
  await page.evaluate(() => (location.hash = '#m=icosphere&refine=0&tape=10,200'));
  await expect.poll(() => page.evaluate(() => window.heatwalk.tapes[0]?.legs[0].state)).toBe('exact');
});
