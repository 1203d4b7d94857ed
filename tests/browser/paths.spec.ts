/** Curves of paths on the surface, and directions that are carried over it. */
import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { ARM, armGlb } from '../animated';
import { grid, type Mesh, off } from '../fixtures';
import { difference, expect, openSection, test } from '../page';

/** The corners of a square at a height. */
function ring(half: number, z: number): Mesh['positions'] {
  return [
    [-half, -half, z],
    [half, -half, z],
    [half, half, z],
    [-half, half, z],
  ];
}

/** A torus: its tube is a square of 0.5, and its axis a square too. */
function frame(): Mesh {
  const positions = [ring(1, 0), ring(1.5, 0), ring(1.5, 0.5), ring(1, 0.5)].flat();
  const triangles: Mesh['triangles'] = [];
  for (let side = 0; side < 4; side++) {
    for (let k = 0; k < 4; k++) {
      const [a, b] = [4 * side + k, 4 * side + ((k + 1) % 4)];
      const [c, d] = [(b + 4) % 16, (a + 4) % 16];
      triangles.push([a, c, b], [a, d, c]);
    }
  }
  return { positions, triangles };
}

/** What a button saves. */
async function saved(page: Page, button: string): Promise<string> {
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: button }).click();
  return (await readFile(await (await downloading).path())).toString();
}

test('loops around a handle have lengths, and a file', async ({ heatwalk, page }) => {
  await heatwalk.openInSection('loops', 'frame.off', off(frame()), 'up=z&method=auto&w=none&s=0&open=measure');
  const loops = page.getByRole('switch', { name: 'Loops around handles' });
  await loops.check();
  await heatwalk.settled();
  // Around the tube and around the hole.
  await expect(page.getByText(/^2 loops\. The shortest: 2\b.* and 8\b/)).toBeVisible();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('loops');
  await page.getByRole('combobox', { name: 'Loops' }).selectOption('obj');
  const text = await saved(page, 'Save loops');
  expect(text.match(/^g loop_\d$/gm)).toEqual(['g loop_1', 'g loop_2']);
  await loops.uncheck();
  await expect(page.getByText('2 loops.')).toBeHidden();
});

test('a surface without handles has none, in words', async ({ heatwalk, page }) => {
  const options = 'up=z&method=auto&w=none&s=0&open=measure&show=loops';
  await heatwalk.openInSection('loops', 'grid.off', off(grid(4)), options);
  await expect(page.getByText('The surface has no handle')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Save loops' })).toBeHidden();
});

test('a loop goes through the sources, and they control a Bézier curve', async ({ heatwalk, page }) => {
  await heatwalk.openInSection('loops', 'grid.off', off(grid(4)), 'method=auto&w=none&s=0,4,24&open=measure');
  await page.getByRole('switch', { name: 'Loop through the sources' }).check();
  // A corner of the unit square, and its diagonal.
  await expect(page.getByText(/^The loop is 3\.41\b/)).toBeVisible();
  await page.getByRole('switch', { name: 'Bézier curve of the sources' }).check();
  // Of speed 2 √((1 − t)² + t²).
  await expect(page.getByText(/^The curve is 1\.62\b/)).toBeVisible();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('loop,bezier');

  await page.getByRole('combobox', { name: 'Curve', exact: true }).selectOption('csv');
  const rows = (await saved(page, 'Save the curve')).trim().split('\n').slice(1);
  const points = rows.map((row) => row.split(',').slice(-3).map(Number));
  // In a plane it is the parabola: with x = 1 − (1 − t)² and y = t² that is √(1 − x) + √y = 1.
  for (const [x = NaN, y = NaN] of points)
    expect(Math.sqrt(1 - Math.min(x, 1)) + Math.sqrt(Math.max(y, 0))).toBeCloseTo(1, 2);

  // They follow, and two places in a plane hold no loop.
  await page.evaluate(() => {
    location.hash = location.hash.replace('s=0,4,24', 's=0,24');
  });
  await expect(page.getByText(/^The curve is 1\.41\b/)).toBeVisible();
  await expect(page.getByText('This loop shrinks to a point')).toBeVisible();
  await expect(page.getByText(/^The loop is/)).toBeHidden();
});

test('a loop is of the pose that is shown', async ({ heatwalk, page }) => {
  const sources = [ARM.ring(5, 0), ARM.ring(5, 8), ARM.ring(5, 16)].join();
  const link = `v=1&m=file&name=arm.glb&p=0&method=auto&w=none&s=${sources}&show=loop&open=measure&clip=1`;
  await heatwalk.open(`#${link}`);
  await heatwalk.dropAndOpen([['arm.glb', armGlb()]]);
  await heatwalk.closeSummary();
  await openSection(page, 'loops');
  const told = page.getByText(/^The loop is/);
  await expect(told).toBeVisible();
  const length = async () => Number(/[\d.]+/.exec(await told.innerText()));
  const small = await length();
  expect(small).toBeGreaterThan(2.5);
  // After two seconds the arm is twice as large.
  await page.evaluate(() => {
    location.hash += '&time=2';
  });
  await expect.poll(async () => (await length()) / small).toBeCloseTo(2, 2);
});

test('a heading at the source is carried over the surface, and is the axis of the log map', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.openInSection('display', 'grid.off', off(grid(4)), 'method=auto&w=none&s=12&open=look');
  const none = await heatwalk.drawing(1, false);
  await page.getByRole('radio', { name: 'Carried from the sources' }).check();
  const upright = await heatwalk.drawing(1, false);
  expect(difference(none, upright)).toBeGreaterThan(0);
  const heading = page.getByRole('slider', { name: 'Heading' });
  await heading.fill('90');
  const left = await heatwalk.drawing(1, false);
  expect(difference(upright, left)).toBeGreaterThan(0);
  await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/show=scenery,carried&heading=90|heading=90/);
  await page.getByRole('radio', { name: 'No arrows' }).check();
  await expect(heading).toBeHidden();
  expect(difference(none, await heatwalk.drawing(1, false))).toBe(0);

  await page.getByRole('tab', { name: 'Share' }).click();
  const section = await openSection(page, 'export');
  await section.getByRole('combobox', { name: 'Distances', exact: true }).selectOption('log-map.csv');
  const [head, ...rows] = (await saved(page, 'Save distances')).trim().split('\n');
  expect(head).toBe('vertex,u (m),v (m)');
  expect(rows).toHaveLength(25);
  rows.forEach((row, index) => {
    const [vertex = NaN, u = NaN, v = NaN] = row.split(',').map(Number);
    expect(vertex).toBe(index);
    // Upright is y; a quarter turn counterclockwise from there is −x, and left of that −y.
    expect(u).toBeCloseTo(0.5 - (index % 5) / 4, 9);
    expect(v).toBeCloseTo(0.5 - Math.floor(index / 5) / 4, 9);
  });
});
