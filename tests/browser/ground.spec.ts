import { grid, off } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';
import { cubeMsh } from '../tetrahedra';

const N = 24;
const GRID = off(grid(N));
const at = (i: number, j: number) => ({ vertex: i + (N + 1) * j });
const [SOURCE, BEHIND] = [at(3, 12), at(21, 12)];
const VIEW = 'up=z&cam=0,1.5,3,0,0,0';
const SIZE = 'Size';

/** A grid seen from above. */
async function openGrid(heatwalk: HeatwalkPage, options = 'method=auto'): Promise<void> {
  const link = `${VIEW}&s=${SOURCE.vertex}&w=${BEHIND.vertex}&${options}`;
  await heatwalk.openInSection('ground', 'grid.off', GRID, link);
}

async function choose(heatwalk: HeatwalkPage, material: string, tool = 'brush'): Promise<void> {
  const section = heatwalk.page.locator('#section-ground');
  await section.getByRole('combobox', { name: 'Tool' }).selectOption(tool);
  if (tool === 'brush' || tool === 'fill') await section.getByRole('button', { name: material, exact: true }).click();
}

/** Drags from one vertex to another. */
async function stroke(heatwalk: HeatwalkPage, from: { vertex: number }, to: { vertex: number }): Promise<void> {
  const { mouse } = heatwalk.page;
  const [[x0, y0], [x1, y1]] = [await heatwalk.pixelOf(from), await heatwalk.pixelOf(to)];
  // Between triangles nothing is picked that is not in one.
  await mouse.move(x0 + 1, y0 + 1);
  await mouse.down();
  await mouse.move(x1 + 1, y1 + 1, { steps: 12 });
  await mouse.up();
  await heatwalk.settled();
}

async function click(heatwalk: HeatwalkPage, place: { vertex: number }): Promise<void> {
  const [x, y] = await heatwalk.pixelOf(place);
  await heatwalk.page.mouse.click(x + 1, y + 1);
  await heatwalk.settled();
}

async function painted(heatwalk: HeatwalkPage): Promise<number> {
  const { ground } = await heatwalk.scene();
  return Object.values(ground.faces).filter((code) => code !== 0).length;
}

test('where it costs the same everywhere, what is measured is a cost, and exact', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  const before = await heatwalk.distanceAt(BEHIND);
  await choose(heatwalk, 'Mud', 'fill');
  await page.locator('#section-ground').getByRole('button', { name: 'Fill all' }).click();
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(BEHIND)).toBeGreaterThan(1.5 * before);
  expect(await heatwalk.refining()).toBe('exact');
  await page.mouse.move(...(await heatwalk.pixelOf(at(12, 12))));
  await expect(page.locator('.readout')).toHaveText(/^costs 1\.5 m \(assumed\) · vertex \d+$/);
  // Where slopes cost what they do to a hiker, the time stands beside it.
  await page.locator('#section-ground').getByText('Slope', { exact: true }).click();
  await heatwalk.settled();
  await page.mouse.move(...(await heatwalk.pixelOf(at(12, 14))));
  await expect(page.locator('.readout')).toHaveText(/^costs [\d.]+ m \(assumed\), \d+ min · vertex \d+$/);
  await page.locator('.stage').press('l');
  const legend = page.getByRole('region', { name: 'Legend' }).getByRole('img');
  await expect(legend).toHaveAttribute('aria-label', /least cost/i);
  await page.getByRole('tab', { name: 'Solver' }).click();
  await expect(page.getByText('Greatest cost', { exact: true })).toBeVisible();
});

for (const method of ['auto', 'heat']) {
  test(`behind mud it is farther, by ${method}, and undo takes the stroke back`, async ({ heatwalk, page }) => {
    await openGrid(heatwalk, `method=${method}`);
    const before = await heatwalk.distanceAt(BEHIND);
    expect(before).toBeCloseTo(18 / N, 2);
    await choose(heatwalk, 'Mud');
    await expect.poll(() => page.locator('.material[aria-pressed=true]').textContent()).toBe('Mud');
    await page.getByRole('slider', { name: SIZE }).fill('80');
    await stroke(heatwalk, at(12, 2), at(12, 22));
    expect(await painted(heatwalk)).toBeGreaterThan(100);
    const behind = await heatwalk.distanceAt(BEHIND);
    expect(behind).toBeGreaterThan(1.2 * before);
    expect(await heatwalk.refining()).toBe('costs');
    const walker = await page.evaluate(() => window.heatwalk.walker);
    expect(walker?.cost).toBeGreaterThan(1.1 * (walker?.length ?? 0));
    await expect(page.locator('.ground-legend')).toContainText('no distances are exact');

    await page.keyboard.press('Control+z');
    await heatwalk.settled();
    expect(await painted(heatwalk)).toBe(0);
    expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(before, 3);
    await page.keyboard.press('Control+Shift+z');
    await heatwalk.settled();
    expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(behind, 3);
  });
}

test('the field follows while the stroke is drawn', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await choose(heatwalk, 'Mud');
  const before = await heatwalk.distanceAt(BEHIND);
  const [x, y] = await heatwalk.pixelOf(at(12, 12));
  await page.mouse.move(x + 1, y + 1);
  await expect.poll(() => page.locator('.material[aria-pressed=true]').textContent()).toBe('Mud');
  await page.mouse.down();
  await page.mouse.move(x + 1, y + 40, { steps: 4 });
  await expect.poll(() => heatwalk.distanceAt(BEHIND)).not.toBeCloseTo(before, 3);
  await page.mouse.up();
  expect((await heatwalk.scene()).camera).not.toBeNull();
});

test('a wall across is not crossed, and is left exact; a gate in it opens and closes', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await choose(heatwalk, 'Wall');
  // The brush reaches over a triangle on, to the boundary.
  await stroke(heatwalk, at(12, 1), at(12, 23));
  expect(await heatwalk.distanceAt(BEHIND)).toBe(Infinity);
  expect(await heatwalk.refining()).toBe('exact');

  await choose(heatwalk, 'Gate');
  await stroke(heatwalk, at(12, 20), at(12, 20));
  expect(await heatwalk.distanceAt(BEHIND)).toBe(Infinity);
  await choose(heatwalk, '', 'toggle');
  await click(heatwalk, at(12, 20));
  const through = await heatwalk.distanceAt(BEHIND);
  expect(through).toBeGreaterThan(18 / N);
  expect(through).toBeLessThan(40 / N);
  await click(heatwalk, at(12, 20));
  expect(await heatwalk.distanceAt(BEHIND)).toBe(Infinity);
  await page.getByRole('button', { name: 'Clear' }).click();
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(18 / N, 5);
});

test('a wall along edges is walked around, and opens by a click', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await choose(heatwalk, '', 'line');
  await click(heatwalk, at(12, 4));
  await click(heatwalk, at(12, 24));
  await expect.poll(async () => (await heatwalk.scene()).ground.lines.length).toBe(1);
  await page.keyboard.press('Escape');
  await heatwalk.settled();
  const { ground } = await heatwalk.scene();
  expect(ground.lines).toEqual([{ vertices: Array.from({ length: 21 }, (_, j) => at(12, 4 + j).vertex), open: false }]);
  // Around its end at (12, 4).
  const around = 2 * Math.hypot(9, 8);
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(around / N, 5);
  expect(await heatwalk.refining()).toBe('exact');

  await choose(heatwalk, '', 'toggle');
  await click(heatwalk, at(12, 14));
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(18 / N, 5);
  await page.keyboard.press('Control+z');
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(around / N, 5);
});

test('the ground is in the link', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await choose(heatwalk, 'Sand');
  await stroke(heatwalk, at(12, 4), at(12, 20));
  await choose(heatwalk, '', 'line');
  await click(heatwalk, at(6, 6));
  await click(heatwalk, at(6, 16));
  await expect.poll(async () => (await heatwalk.scene()).ground.lines.length).toBe(1);
  await page.getByRole('switch', { name: 'Slope' }).check();
  await heatwalk.settled();
  const { ground } = await heatwalk.scene();
  const behind = await heatwalk.distanceAt(BEHIND);
  await expect(page).toHaveURL(/&ground=[\w-]+&slope=1/);
  const link = new URL(page.url()).hash;
  // The browser keeps the file.
  await heatwalk.kept();
  await heatwalk.open(link);
  await heatwalk.settled();
  expect((await heatwalk.scene()).ground).toEqual(ground);
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(behind, 4);
});

test('a source in a wall is told, and the scene stays', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await choose(heatwalk, 'Wall');
  await stroke(heatwalk, at(6, 12), at(3, 12));
  await expect(page.getByRole('alert')).toContainText('in a wall');
  // What was answered last stays.
  expect(await heatwalk.distanceAt(BEHIND)).toBeLessThan(30 / N);
  expect((await heatwalk.scene()).sources).toEqual([SOURCE]);
  // What is asked about the field that there is not has no answer.
  const asked = await page.evaluate(async (place) => {
    const { exactDistanceAt, bestDistanceAt } = window.heatwalk;
    return [await exactDistanceAt(place), await bestDistanceAt(place)];
  }, BEHIND);
  expect(asked).toEqual([null, null]);
  await page.mouse.move(...(await heatwalk.pixelOf(at(18, 20))));
  await expect(page.locator('.readout')).toHaveText(/^vertex \d+$/);
  await expect(page.getByRole('alert')).toContainText('in a wall');
  await page.keyboard.press('Control+z');
  await expect.poll(() => painted(heatwalk)).toBe(0);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(18 / N, 5);
});

test('with a modifier the brush lets the camera move', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await choose(heatwalk, 'Mud');
  const [x, y] = await heatwalk.pixelOf(at(12, 12));
  const yaw = () => page.evaluate(() => window.heatwalk.camera?.[0] ?? Number.NaN);
  const before = await yaw();
  await page.keyboard.down('Control');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.up('Control');
  await expect.poll(yaw).not.toBeCloseTo(before, 2);
  expect(await painted(heatwalk)).toBe(0);
});

test('the brush is put away inside of tetrahedra, where its button and its key say why', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  await page.keyboard.press('b');
  const brush = page.getByRole('toolbar').getByRole('button', { name: 'Brush' });
  await expect(brush).toHaveAttribute('aria-pressed', 'true');
  await heatwalk.dropAndOpen([['cube.msh', cubeMsh(2)]]);
  await expect(brush).toHaveAttribute('aria-pressed', 'false');
  await expect(brush).toBeDisabled();
  await expect(brush).toHaveAttribute('title', 'Inside of tetrahedra there is no ground.');
  await page.keyboard.press('b');
  await expect(page.getByRole('alert')).toContainText('Inside of tetrahedra there is no ground.');
  await heatwalk.dropAndOpen([['grid.off', GRID]]);
  await expect(brush).toBeEnabled();
});

test('a table of costs that is dropped is painted, and one that is none is named', async ({ heatwalk, page }) => {
  await openGrid(heatwalk);
  const rows = Array.from({ length: 2 * N * N }, (_, triangle) => `${triangle},2`);
  await heatwalk.drop([['costs.csv', `triangle,cost\n${rows.join('\n')}\n`]]);
  await expect.poll(() => heatwalk.distanceAt(BEHIND)).toBeCloseTo(36 / N, 5);
  expect((await heatwalk.mesh()).name).toBe('grid.off');
  await heatwalk.drop([['costs.csv', `0,2\n${2 * N * N},2`]]);
  await expect(page.locator('.message').first()).toContainText(`costs.csv, line 2: there is no triangle ${2 * N * N}`);
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(36 / N, 5);
  await page.keyboard.press('Control+z');
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(18 / N, 5);

  await heatwalk.drop([
    ['costs.csv', '0,2'],
    ['more.csv', '1,2'],
  ]);
  await expect(page.getByRole('alert')).toContainText(
    'costs.csv and more.csv are tables, of which one is taken at a time.',
  );
  expect(await painted(heatwalk)).toBe(0);
});

test('what a file says that its vertices cost is painted by a button', async ({ heatwalk, page }) => {
  const { positions, triangles } = grid(N);
  const ply = [
    'ply\nformat ascii 1.0',
    `element vertex ${positions.length}\nproperty float x\nproperty float y\nproperty float z\nproperty float weight`,
    `element face ${triangles.length}\nproperty list uchar int vertex_indices\nend_header`,
    ...positions.map((place) => `${place.join(' ')} 4`),
    ...triangles.map((corners) => `3 ${corners.join(' ')}`),
  ].join('\n');
  await heatwalk.openFile('grid.ply', ply, `${VIEW}&s=${SOURCE.vertex}&method=auto`);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo(18 / N, 5);
  await openSection(page, 'ground');
  await page.getByRole('button', { name: 'Costs of the file (weight)' }).click();
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(BEHIND)).toBeCloseTo((4 * 18) / N, 4);
});
