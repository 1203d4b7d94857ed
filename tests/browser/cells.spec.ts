import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { encodeGround, LEVEL } from '../../web/state/ground';
import { grid, off } from '../fixtures';
import { expect, test } from '../page';

const N = 24;
const GRID = off(grid(N));
const vertex = (i: number, j: number) => i + (N + 1) * j;
const VIEW = 'up=z&cam=0,1.5,2.6,0,0,0&method=auto&w=none';

const table = (page: Page) => page.locator('.rows').filter({ hasText: 'Nearest source' });

test('cells have areas, and borders that are saved, in the link and in undo', async ({ heatwalk, page }) => {
  const sources = [vertex(6, 12), vertex(18, 12)];
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&s=${sources.join()}`);
  const cells = page.getByRole('switch', { name: 'Cells' });
  await expect(cells).not.toBeChecked();
  await cells.check();
  await heatwalk.settled();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('cells');
  await expect(table(page).locator('tbody tr')).toHaveText([/Vertex 306 ?.*50 %/, /Vertex 318 ?.*50 %/]);
  await page.getByRole('combobox', { name: 'Borders' }).selectOption('csv');
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save borders' }).click();
  const [, ...rows] = (await readFile(await (await downloading).path())).toString().trim().split('\n');
  const places = rows.map((row) => row.split(',').map(Number));
  const middle = (vertex(0, 0) + N / 2) / N;
  expect(places.length).toBeGreaterThan(N);
  for (const [, cell, other, , x] of places)
    expect([cell, other, Math.abs((x ?? 0) - middle) < 1e-5]).toEqual([0, 1, true]);
  await page.keyboard.press('Control+z');
  await expect(cells).not.toBeChecked();
  await expect(table(page)).toHaveCount(0);
});

test('a line is one source, and cells of one source or with costs are refused in words', async ({ heatwalk, page }) => {
  const ends = [vertex(0, 0), vertex(24, 0)];
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&s=${vertex(12, 24)}&sets=line:${ends.join('-')}&show=cells`);
  await heatwalk.settled();
  await expect(table(page).locator('tbody tr')).toHaveCount(2);
  // Below a parabola: a half and a twenty-fourth.
  await expect(table(page).locator('tbody tr').last().locator('td')).toHaveText(['0.542', '54 %']);
  await page.getByRole('button', { name: 'Delete source 2' }).click();
  await heatwalk.settled();
  await expect(table(page)).toHaveCount(0);
  await page.getByRole('switch', { name: 'Cells' }).uncheck();
  await expect(page.getByText('Cells are of two sources or more.')).toBeVisible();
  await expect(page.getByRole('switch', { name: 'Cells' })).toBeDisabled();
});

test('walls part cells', async ({ heatwalk, page }) => {
  const sources = [vertex(2, 2), vertex(22, 22)];
  const vertices = Array.from({ length: N + 1 }, (_, i) => vertex(i, 6));
  const walls = encodeGround({ ...LEVEL, faces: new Uint8Array(2 * N * N), lines: [{ vertices, open: false }] });
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&s=${sources.join()}&show=cells&ground=${walls}`);
  await heatwalk.settled();
  // The part below the wall is a quarter.
  await expect(table(page).locator('tbody tr').first()).toContainText('25 %');
});

test('sources are spread, and relaxed in one step of undo', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&s=${vertex(0, 0)}&show=cells`);
  const count = page.getByRole('spinbutton', { name: 'Number of sources' });
  await count.fill('1');
  await page.getByRole('button', { name: 'Spread' }).click();
  await expect(page.getByText('Spread 2 to 1,000 sources.')).toBeVisible();
  await count.fill('4');
  await page.getByRole('button', { name: 'Spread' }).click();
  // The corners, each as far from those before as can be.
  const corners = [vertex(0, 0), vertex(N, N), vertex(0, N), vertex(N, 0)];
  const sources = async () => (await heatwalk.scene()).sources;
  await expect.poll(sources).toHaveLength(4);
  expect(new Set((await sources()).map((source) => 'vertex' in source && source.vertex))).toEqual(new Set(corners));
  const relax = page.getByRole('button', { name: 'Relax' });
  await relax.click();
  await expect(relax).toBeEnabled({ timeout: 60_000 });
  await heatwalk.settled();
  // A quarter each, to what a row of vertices makes of it.
  await expect(table(page).locator('tbody tr')).toHaveText(corners.map(() => /2[456] %$/));
  const middle = await heatwalk.distanceAt({ vertex: vertex(N / 2, N / 2) });
  const side = await heatwalk.distanceAt({ vertex: vertex(0, 0) });
  expect(Math.abs(middle - side)).toBeLessThan(0.05 * side);
  await page.keyboard.press('Control+z');
  expect(new Set((await sources()).map((source) => 'vertex' in source && source.vertex))).toEqual(new Set(corners));
  await page.getByRole('button', { name: 'Mean' }).click();
  // The middle of the corners.
  await expect.poll(async () => (await heatwalk.scene()).walker).toEqual({ vertex: vertex(N / 2, N / 2) });
});
