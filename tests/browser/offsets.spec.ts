import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { encodeGround, LEVEL } from '../../web/state/ground';
import { grid, off } from '../fixtures';
import { expect, test } from '../page';

const N = 24;
const GRID = off(grid(N));
const vertex = (i: number, j: number) => i + (N + 1) * j;
const VIEW = 'up=z&cam=0,1.5,2.6,0,0,0&method=auto&w=none&s=0';
/** A square of a half around the middle, clockwise: its inside is the smaller side all the same. */
const SQUARE = `sets=loop:${[vertex(6, 6), vertex(6, 18), vertex(18, 18), vertex(18, 6)].join('-')}`;

const control = (page: Page) => page.getByRole('switch', { name: 'Distance from curves' });

/** Distance, x and y of the points of the file of offsets. */
async function offsets(page: Page): Promise<{ distance: number; x: number; y: number }[]> {
  await page.getByRole('combobox', { name: 'Offsets' }).selectOption('csv');
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save offsets' }).click();
  const [head = '', ...rows] = (await readFile(await (await downloading).path())).toString().trim().split('\n');
  const names = head.split(',').map((name) => name.replace(/ .*/, ''));
  return rows.map((row) => {
    const cells = row.split(',').map(Number);
    const at = (name: string) => cells[names.indexOf(name)] ?? NaN;
    return { distance: at('value'), x: at('x'), y: at('y') };
  });
}

test('distance from a closed curve has its inside, in the link, in undo and in files', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&${SQUARE}&period=0.25`);
  await control(page).check();
  await heatwalk.settled();
  await expect(page.getByText('Blue is inside, up to 0.25')).toBeVisible();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('curves');
  const points = await offsets(page);
  // From the square, whose corners are round outside.
  for (const { distance, x, y } of points) {
    const [dx, dy] = [Math.abs(x - 0.5) - 0.25, Math.abs(y - 0.5) - 0.25];
    const outside = Math.hypot(Math.max(dx, 0), Math.max(dy, 0));
    expect(distance).toBeCloseTo(outside > 0 ? outside : Math.max(dx, dy), 3);
  }
  const values = new Set(points.map(({ distance }) => distance));
  expect([Math.min(...values) < -0.05, values.has(0), Math.max(...values) > 0.25]).toEqual([true, true, true]);
  // What is read is of what is painted.
  const legend = page.getByRole('region', { name: 'Legend' }).getByRole('img');
  await expect(legend).toHaveAttribute(
    'aria-label',
    /Distance from curves: 0\.25 .*inside to 0\.35\d .*outside, by color\./,
  );
  const at = async (name: number) => page.mouse.move(...(await heatwalk.pixelOf({ vertex: name })));
  await at(vertex(12, 12));
  await expect(page.locator('.readout')).toContainText(/0\.2\d* .*inside of the curve/);
  await at(vertex(12, 22));
  await expect(page.locator('.readout')).toContainText(/0\.1[67]\d* .*from the curve/);
  await page.keyboard.press('Control+z');
  await expect(control(page)).not.toBeChecked();
  await expect(legend).not.toHaveAttribute('aria-label', /curves/);
});

test('an open curve has two sides, too, and follows when it is drawn on', async ({ heatwalk, page }) => {
  const half = `sets=line:${[vertex(12, 0), vertex(12, 24)].join('-')}`;
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&${half}&show=curves`);
  await heatwalk.settled();
  await expect(page.getByText('Blue is inside, up to 0.5')).toBeVisible();
  await page.getByRole('button', { name: 'Delete source 2' }).click();
  await heatwalk.settled();
  await expect(page.getByText('Blue is inside')).toBeHidden();
  await expect(page.getByText('There is no curve yet')).toBeVisible();
});

test('where costs differ there is none, and words say so', async ({ heatwalk, page }) => {
  const costs = new Uint8Array(2 * N * N);
  costs.fill(40, 0, N);
  const ground = encodeGround({ ...LEVEL, faces: costs });
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&${SQUARE}&ground=${ground}`);
  await heatwalk.settled();
  await expect(control(page)).toBeDisabled();
  await expect(page.getByText('Where costs differ no distance from curves is known.')).toBeVisible();
});
