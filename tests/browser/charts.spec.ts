import { readFile } from 'node:fs/promises';
import type { Locator, Page } from '@playwright/test';
import { grid, off, sphere } from '../fixtures';
import { expect, openSection, test } from '../page';

const N = 24;
const CORNER = (N + 1) ** 2 - 1;

async function chartsOf(page: Page): Promise<Locator> {
  const charts = await openSection(page, 'charts');
  return charts;
}

/** Rows of numbers of a file that a button saves. */
async function numbers(page: Page, button: Locator): Promise<number[][]> {
  const downloading = page.waitForEvent('download');
  await button.click();
  const text = await readFile(await (await downloading).path(), 'utf8');
  const [, ...rows] = text.trim().split('\r\n');
  return rows.map((row) => row.split(',').map(Number));
}

test('distance along the path falls by what is walked', async ({ heatwalk, page }) => {
  await heatwalk.openFile('square.off', off(grid(N)), `s=0&w=${CORNER}&method=exact`);
  await heatwalk.settled();
  const charts = await chartsOf(page);
  const rows = await numbers(page, charts.getByRole('button', { name: 'Save Distance along the path as CSV' }));
  expect(rows.length).toBeGreaterThan(2);
  expect(rows[0][0]).toBe(0);
  expect(rows[0][1]).toBeCloseTo(Math.SQRT2, 9);
  expect(rows.at(-1)?.[0]).toBeCloseTo(Math.SQRT2, 9);
  // Along the diagonal distance is linear in every triangle.
  for (const [walked, left] of rows) expect(walked + left).toBeCloseTo(Math.SQRT2, 9);
});

test('labels of the vertical axis stand beside its title, however large values are', async ({ heatwalk, page }) => {
  await heatwalk.openFile('square.off', off(grid(N)), `s=0&w=${CORNER}&method=exact&scale=1000000`);
  await heatwalk.settled();
  const chart = (await chartsOf(page)).getByRole('img', { name: /^Distance along the path/ });
  const sides = (texts: string) =>
    chart.locator(texts).evaluateAll((all) => all.map((each) => each.getBoundingClientRect()));
  await expect(chart).toBeVisible();
  const [title] = await sides('text[transform]');
  for (const { left } of await sides('text[dy]')) expect(left).toBeGreaterThan(title.right);
});

test('residuals of both linear solvers are charted for fields by heat', async ({ heatwalk, page }) => {
  await heatwalk.open('#m=torus');
  await heatwalk.settled();
  const charts = await chartsOf(page);
  const compare = charts.getByRole('button', { name: 'Compare linear solvers' });
  await compare.click();
  for (const system of ['Heat system', 'Poisson system']) {
    const rows = await numbers(page, charts.getByRole('button', { name: `Save ${system} as CSV` }));
    expect(rows[0].slice(0, 2)).toEqual([0, 1]);
    expect(rows.at(-1)?.[1]).toBeLessThanOrEqual(1e-12);
    expect(rows[0][2]).toBeLessThan(1e-11);
  }
  await expect(charts.getByRole('img', { name: /^Heat system/ })).toContainText('10⁻');

  // They are of that field alone.
  await page.evaluate(() => (location.hash = '#m=torus&s=5'));
  await heatwalk.settled();
  await expect(charts.getByRole('img', { name: /^Heat system/ })).toHaveCount(0);
});

test('Table 1 of the report is measured, copied, saved, and cancelled', async ({ context, heatwalk, page }) => {
  test.slow();
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await heatwalk.open();
  await heatwalk.settled();
  const table = (await chartsOf(page)).getByRole('region', { name: 'Table 1 of the report' });
  await table.getByRole('button', { name: 'Measure Table 1' }).click();
  await table.getByRole('button', { name: 'Cancel' }).click();
  await expect(table.getByRole('status')).toHaveText('Cancelled.');

  await table.getByRole('button', { name: 'Measure Table 1' }).click();
  await expect(table.getByRole('status')).toContainText('of 11');
  await expect(table.getByRole('status')).toContainText('Done.', { timeout: 120_000 });
  await expect(table.locator('tbody')).toHaveCount(11);
  // The report's own times below those of this device.
  const cow = table.locator('tbody', { hasText: 'Cow' }).getByRole('row');
  await expect(cow).toHaveCount(2);
  await expect(cow.first().getByRole('cell')).toHaveText([/^[\d.]+ \/ [\d.]+$/, /^[\d.]+ \/ [\d.]+$/]);
  await expect(cow.last().getByRole('cell')).toHaveText(['62 / 109', '335 / 16']);
  const rows = await numbers(page, table.getByRole('button', { name: 'Save as CSV' }));
  const report = [3328, 5304, 5804, 5660, 9024, 6912, 3456, 12200, 5120, 39996, 20388];
  rows.forEach(([, triangles, ...times], index) => {
    // No more than the report has.
    expect(triangles).toBeLessThanOrEqual(report[index]);
    expect(triangles).toBeGreaterThan(0.5 * report[index]);
    expect(Math.min(...times)).toBeGreaterThan(0);
    // Factors answer faster than what iterates, which nothing on a busy machine undoes.
    expect(times[3]).toBeLessThan(times[1]);
  });
  await table.getByRole('button', { name: 'Copy as Markdown' }).click();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toMatch(/^\| Model \| Triangles \|/);
  expect(copied.split('\n').filter((line) => line.startsWith('| '))).toHaveLength(13);
});

test('errors by edge length are measured on the surface and on what it is split into, and cancelled', async ({
  context,
  heatwalk,
  page,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await heatwalk.openFile('ball.off', off(sphere(20)), 's=3&method=heat');
  await heatwalk.settled();
  const charts = await chartsOf(page);
  const study = charts.getByRole('region', { name: 'Convergence' });
  // One right after the other, so that nothing is done before.
  await study.evaluate((section) => {
    for (const name of ['Measure convergence', 'Cancel']) {
      [...section.querySelectorAll('button')].find(({ textContent }) => textContent === name)?.click();
    }
  });
  await expect(study.getByRole('status')).toHaveText('Cancelled.');

  await study.getByRole('button', { name: 'Measure convergence' }).click();
  await expect(study.getByRole('status')).toContainText('Done.', { timeout: 60_000 });
  for (const method of ['heat', 'propagation']) {
    const rows = await numbers(page, study.getByRole('button', { name: `Save Error of ${method} as CSV` }));
    expect(rows).toHaveLength(3);
    rows.forEach(([edge, most, mean], level) => {
      expect(edge).toBeCloseTo(rows[0][0] / 2 ** level, 4);
      expect(most).toBeGreaterThan(mean);
    });
    // Heat converges. The windows of propagation miss a share of the paths, however short the edges.
    if (method === 'heat') expect(rows[2][2]).toBeLessThan(rows[0][2] / 2);
  }
  await study.getByRole('button', { name: 'Copy as Markdown' }).click();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied.trim().split('\n')).toHaveLength(6);

  // Another surface has not been measured.
  await heatwalk.dropAndOpen([['sheet.off', off(grid(8))]]);
  await expect(study.locator('figure')).toHaveCount(0);
});
