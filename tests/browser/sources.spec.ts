import { readFileSync } from 'node:fs';
import { grid, obj, off } from '../fixtures';
import { expect, type HeatwalkPage, test } from '../page';

const N = 24;
const GRID = off(grid(N));
const at = (i: number, j: number) => ({ vertex: i + (N + 1) * j });
const VIEW = 'up=z&cam=0,1.5,2.6,0,0,0&method=auto';

async function click(heatwalk: HeatwalkPage, place: { vertex: number }, modifier?: string): Promise<void> {
  const [x, y] = await heatwalk.pixelOf(place);
  if (modifier) await heatwalk.page.keyboard.down(modifier);
  await heatwalk.page.mouse.click(x + 1, y + 1);
  if (modifier) await heatwalk.page.keyboard.up(modifier);
}

const rows = ({ page }: HeatwalkPage) => page.locator('.source-name');

async function paste(heatwalk: HeatwalkPage, text: string): Promise<void> {
  await heatwalk.page.evaluate((given) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', given);
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  }, text);
}

test('a line, a boundary and a list are entries of the list, with undo, and the link opens the same', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.withoutLegend();
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&s=${at(6, 12).vertex}`);
  await heatwalk.closeSummary();
  await click(heatwalk, at(12, 12), 'Shift');
  await expect(rows(heatwalk)).toHaveText(['Line of 7 vertices']);
  await click(heatwalk, at(12, 18), 'Shift');
  await expect(rows(heatwalk)).toHaveText(['Line of 13 vertices']);
  await heatwalk.settled();
  // Exact in the plane: a corner of the line is the nearest place of it, or a vertex in its middle.
  expect(await heatwalk.distanceAt(at(18, 18))).toBeCloseTo(6 / N, 5);
  expect(await heatwalk.distanceAt(at(9, 9))).toBeCloseTo(3 / N, 5);
  const initial = page.getByRole('spinbutton', { name: 'Initial distance of source 1' });
  await initial.fill('0.5');
  await expect.poll(() => heatwalk.distanceAt(at(9, 12))).toBeCloseTo(0.5, 5);
  await initial.fill('-1');
  const why = page.getByText('An initial distance is a number, 0 or more.');
  await initial.blur();
  await expect(initial).toHaveValue('0.5');
  await expect(why).toBeVisible();
  await initial.fill('0.5');
  await expect(why).toBeHidden();
  await page.keyboard.press('Escape');
  await page.locator('.stage').focus();
  await page.keyboard.press('Escape');

  await page.getByRole('combobox', { name: 'Draw' }).selectOption('boundary');
  await click(heatwalk, at(12, 1));
  await expect(rows(heatwalk)).toHaveText(['Line of 13 vertices', `Boundary of ${4 * N} vertices`]);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(at(0, 24))).toBe(0);
  expect(await heatwalk.distanceAt(at(4, 20))).toBeCloseTo(4 / N, 5);
  await page.keyboard.press('Control+z');
  await expect(rows(heatwalk)).toHaveText(['Line of 13 vertices']);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(at(0, 24))).toBeGreaterThan(0.5);
  await page.keyboard.press('Control+Shift+z');

  await paste(heatwalk, `vertex,offset\n${at(20, 4).vertex},0\n${at(20, 5).vertex},0\n9999,0`);
  await expect(page.getByText('List, line 4: there is no vertex 9999')).toBeVisible();
  await paste(heatwalk, '9999');
  await expect(page.getByText('What was pasted: there is no vertex 9999')).toBeVisible();
  await expect(rows(heatwalk)).toHaveCount(2);
  // Its last corner is dragged, and the line is found anew; that is one step of undo.
  const [from, to] = [await heatwalk.pixelOf(at(12, 18)), await heatwalk.pixelOf(at(20, 18))];
  const lineNow = async () => (await heatwalk.scene()).sets[0];
  const before0 = await lineNow();
  await page.mouse.move(from[0] + 1, from[1] + 1);
  await page.mouse.down();
  await page.mouse.move(to[0] + 1, to[1] + 1, { steps: 5 });
  await page.mouse.up();
  await expect.poll(async () => (await lineNow()).shape).toMatchObject({ corners: [306, 312, at(20, 18).vertex] });
  expect((await lineNow()).points).toContainEqual(at(20, 18));
  await page.keyboard.press('Control+z');
  expect(await lineNow()).toEqual(before0);
  // The keyboard moves a corner from vertex to vertex; arrows in a row are one step of undo too.
  await rows(heatwalk).first().click();
  const corner = page.getByRole('button', { name: /^Corner 3 of 3/ });
  await corner.focus();
  await page.keyboard.down('ArrowRight');
  await expect(corner).toHaveAccessibleName(`Corner 3 of 3, vertex ${at(13, 18).vertex}`);
  await page.keyboard.down('ArrowRight');
  await expect(corner).toHaveAccessibleName(`Corner 3 of 3, vertex ${at(14, 18).vertex}`);
  await page.keyboard.up('ArrowRight');
  await expect(page.locator('.corner-layer [aria-live]')).toHaveText(`Corner 3 of 3, vertex ${at(14, 18).vertex}`);
  expect((await lineNow()).shape).toMatchObject({ corners: [306, 312, at(14, 18).vertex] });
  await expect(corner).toBeFocused();
  await page.keyboard.press('Control+z');
  expect(await lineNow()).toEqual(before0);
  await page.keyboard.press('Escape');
  await expect(corner).toHaveCount(0);
  await paste(heatwalk, `x y z offset\n0.5 0.25 7 0\n${5 / N} ${7 / N} 0 0.125`);
  await expect(rows(heatwalk)).toHaveText([/^Line/, /^Boundary/, 'List: 2']);
  await expect(page.getByText('2 sources added, at most 7 m (assumed) away')).toBeVisible();
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(at(12, 6))).toBe(0);
  expect(await heatwalk.distanceAt(at(5, 7))).toBeCloseTo(0.125, 5);

  const before = await heatwalk.scene();
  await expect(page).toHaveURL(/sets=line:306-312-462@0.5,boundary:\d+,list:List:/);
  const { hash } = new URL(page.url());
  await heatwalk.forgetFiles();
  await heatwalk.open(hash);
  await heatwalk.dropAndOpen([['grid.off', GRID]]);
  await heatwalk.settled();
  expect((await heatwalk.scene()).sets).toEqual(before.sets);
  expect(await heatwalk.distanceAt(at(5, 7))).toBeCloseTo(0.125, 5);

  // The file of all sources brings them back where they are dropped.
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save sources' }).click();
  const table = readFileSync(await (await downloading).path(), 'utf8');
  await page.getByRole('button', { name: 'Delete all' }).click();
  await expect(rows(heatwalk)).toHaveCount(0);
  await heatwalk.drop([['sources.csv', table]]);
  await expect(rows(heatwalk)).toHaveText([`sources.csv: ${13 + 4 * N + 2}`]);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(at(9, 12))).toBeCloseTo(Math.hypot(3, 6) / N, 5);
  expect(await heatwalk.distanceAt(at(5, 7))).toBeCloseTo(0.125, 5);
});

test('what is placed on parts that stay active stays where it is, whatever becomes of the others', async ({
  heatwalk,
  page,
}) => {
  const sheet = (z: number) => {
    const { positions, triangles } = grid(N);
    return { positions: positions.map(([x, y]): [number, number, number] => [x, y, z]), triangles };
  };
  const before = (N + 1) ** 2;
  const there = (i: number, j: number) => before + at(i, j).vertex;
  const sets = `line:${there(6, 6)}-${there(12, 6)}@0.5,boundary:${there(0, 3)}@0.25,part:0,line:3-5,part:1@0.75`;
  const places = `s=${there(12, 12)},7&w=${there(20, 20)}&tape=${there(3, 3)},${there(3, 6)};1,2&sets=${sets}`;
  await heatwalk.openFile('sheets.obj', obj({ low: sheet(0), high: sheet(1) }), `${places}&up=z&method=auto&refine=0`);
  await expect(rows(heatwalk)).toHaveCount(7);
  await page.getByRole('checkbox', { name: 'low' }).click();
  await expect.poll(async () => (await heatwalk.mesh()).active).toEqual([1]);
  await heatwalk.settled();
  const now = await heatwalk.scene();
  const on = (i: number, j: number) => ({ vertex: there(i, j) });
  expect(now).toMatchObject({ sources: [on(12, 12)], walker: on(20, 20), tapes: [{ points: [on(3, 3), on(3, 6)] }] });
  expect(now.sets).toMatchObject([
    { shape: { kind: 'line', corners: [there(6, 6), there(12, 6)] }, points: { length: 7 }, offset: 0.5 },
    { shape: { kind: 'boundary' }, points: { length: 4 * N }, offset: 0.25 },
    { shape: { kind: 'part', part: 1 }, points: { length: before }, offset: 0.75 },
  ]);
  expect(await heatwalk.distanceAt(on(12, 12))).toBe(0);
  expect(await heatwalk.distanceAt(on(0, 12))).toBeCloseTo(0.25, 6);
});

test('a stroke is drawn by hand and closed where it began; a part by a click; a vertex by its number', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.withoutLegend();
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&refine=0`);
  await heatwalk.closeSummary();
  await page.getByRole('button', { name: 'Delete source 1' }).click();
  await expect(rows(heatwalk)).toHaveCount(0);
  // The focus goes to where another one is set.
  await expect(page.locator('.stage')).toBeFocused();
  await page.getByRole('combobox', { name: 'Draw' }).selectOption('stroke');
  const solves = await heatwalk.solves();
  const corners = [at(6, 6), at(18, 6), at(18, 18), at(6, 18), at(6, 6)];
  const path = await Promise.all(corners.map((corner) => heatwalk.pixelOf(corner)));
  // Between triangles nothing is picked that is not in one.
  await page.mouse.move(path[0][0] + 1, path[0][1] + 1);
  await page.mouse.down();
  for (const [x, y] of path) await page.mouse.move(x + 1, y + 1, { steps: 6 });
  // The field follows the pen.
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
  await page.mouse.up();
  await expect(rows(heatwalk)).toHaveText([/^Closed curve of \d+ points$/]);
  await heatwalk.settled();
  // No farther than half of the way from one place of the stroke to the next.
  for (const [place, distance] of [
    [at(12, 12), 6 / N],
    [at(12, 6), 0],
    [at(6, 11), 0],
    [at(2, 12), 4 / N],
  ] as const) {
    expect(Math.abs((await heatwalk.distanceAt(place)) - distance)).toBeLessThan(0.02);
  }
  await page.keyboard.press('Control+z');
  await expect(rows(heatwalk)).toHaveCount(0);

  const field = page.getByRole('textbox', { name: 'Source to add' });
  await field.fill(String(at(3, 4).vertex));
  await field.press('Enter');
  await expect(rows(heatwalk)).toHaveText([`Vertex ${at(3, 4).vertex}`]);
  await field.fill(String(at(3, 4).vertex));
  await field.press('Enter');
  await expect(page.getByText('This place is a source already.')).toBeVisible();
  await expect(rows(heatwalk)).toHaveCount(1);
  await field.fill('9999');
  await field.press('Enter');
  await expect(page.getByText('What was typed: there is no vertex 9999;')).toBeVisible();
  await field.fill('0.3 0.3 1');
  await field.press('Enter');
  await expect(page.getByText('Added, 1 m (assumed) away from there.')).toBeVisible();
  await expect(rows(heatwalk)).toHaveCount(2);

  await page.locator('.stage').focus();
  await page.keyboard.press('7');
  await expect(page.getByRole('combobox', { name: 'Draw' })).toHaveValue('part');
  await page.keyboard.press('Enter');
  await expect(rows(heatwalk).nth(2)).toHaveText(`Component of ${(N + 1) ** 2} vertices`);
  await heatwalk.settled();
  expect((await heatwalk.field()).maxDistance).toBe(0);
});
