import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { complaints } from '../gltf';
import { expect, test } from '../page';

async function saved(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: button }).click();
  const download = await downloading;
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

test('isolines are drawn, measured and saved, and distances with the materials of the file', async ({ heatwalk }) => {
  const { page } = heatwalk;
  await heatwalk.open('#m=torus&show=scenery,isolines');
  await heatwalk.settled();
  const section = page.locator('#section-export');
  await section.locator('summary').click();
  await section.scrollIntoViewIfNeeded();

  await page.getByLabel('Isolines at').fill('0.5, 1');
  await expect.poll(() => page.url()).toContain('&iso=0.5,1');
  await page.getByRole('button', { name: 'Measure isolines' }).click();
  const cells = section.locator('tbody tr').first().locator('td');
  await expect(cells.first()).toHaveText('0.5');
  await expect(cells.last()).toHaveText('1 of 1');

  const [curves, distances] = [section.locator('select').nth(0), section.locator('select').nth(1)];
  await curves.selectOption('csv');
  const table = await saved(page, 'Save isolines');
  expect(table.name).toBe('torus.isolines.csv');
  const rows = table.bytes.toString().trim().split('\n').slice(1);
  const values = new Set(rows.map((row) => Number(row.split(',')[1])));
  expect([...values]).toEqual([0.5, 1]);
  // The axis of the ring is Y, and its tube is 0.4 thick around a circle of radius 1.
  for (const row of rows.slice(0, 20)) {
    const [x, y, z] = row.split(',').slice(3).map(Number);
    expect(Math.abs(Math.hypot(Math.hypot(x, z) - 1, y) / 0.4 - 1)).toBeLessThan(0.05);
  }

  await curves.selectOption('glb');
  expect(await complaints((await saved(page, 'Save isolines')).bytes)).toEqual([]);
  await section.getByLabel('Path').selectOption('glb');
  const path = await saved(page, 'Save path');
  expect(path.name).toBe('torus.path.glb');
  expect(await complaints(path.bytes)).toEqual([]);

  await curves.selectOption('unrolled.svg');
  await page.getByRole('button', { name: 'Save isolines' }).click();
  await expect(section.getByRole('status')).toContainText('cannot be unrolled');

  await distances.selectOption('npy');
  const { bytes } = await saved(page, 'Save distances');
  expect(bytes.subarray(1, 6).toString()).toBe('NUMPY');
  const numbers = new Float64Array(new Uint8Array(bytes.subarray(10 + bytes.readUInt16LE(8))).buffer);
  expect(numbers.length).toBe(await page.evaluate(() => window.heatwalk.mesh?.vertices));
  const largest = await page.evaluate(() => window.heatwalk.field?.maxDistance ?? 0);
  expect(Math.max(...numbers)).toBeCloseTo(largest, 5);

  // What is saved is opened again.
  await distances.selectOption('glb');
  const scene = await saved(page, 'Save distances');
  expect(await complaints(scene.bytes)).toEqual([]);
  await heatwalk.dropAndOpen([['again.glb', scene.bytes]]);
  expect(await page.evaluate(() => window.heatwalk.mesh?.triangles)).toBe(17_280);
});
