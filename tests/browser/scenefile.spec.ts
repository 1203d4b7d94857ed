/** Scenes that are saved as files and opened again. */
import { readFile } from 'node:fs/promises';
import { grid, off } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';

const N = 96;
const PLACE = { vertex: 40 + (N + 1) * 40 };

async function savedScene({ page }: HeatwalkPage): Promise<{ name: string; bytes: Buffer }> {
  await openSection(page, 'share');
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save scene' }).click();
  const download = await downloading;
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

async function dropScene(heatwalk: HeatwalkPage, name: string, bytes: Buffer, mesh: string): Promise<void> {
  await heatwalk.drop([[name, bytes]]);
  await expect.poll(() => heatwalk.page.evaluate(() => window.heatwalk.mesh?.name)).toBe(mesh);
  await heatwalk.rest();
}

/** What the scene is, but for what belongs to the moment. */
async function state(heatwalk: HeatwalkPage): Promise<unknown> {
  const { selected: _selected, ...rest } = await heatwalk.scene();
  return rest;
}

test('a scene is saved with its mesh, and opened again as it was', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', off(grid(N)), 'up=z&cam=0,1.5,2.6,0,0,0&method=auto&w=none&iso=0.25,');
  // More sources than a link holds.
  const rows = Array.from(
    { length: 9000 },
    (_, i) => `${(i * 7919) % (N + 1) ** 2},${(1 + (i % 977) / 1000).toFixed(3)}`,
  );
  await page.evaluate(
    (text) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text/plain', text);
      document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
    },
    `vertex,offset\n${rows.join('\n')}`,
  );
  await expect.poll(async () => (await heatwalk.scene()).sets.length).toBe(1);
  await heatwalk.settled();
  const [before, distance] = [await state(heatwalk), await heatwalk.distanceAt(PLACE)];
  expect(distance).toBeGreaterThan(0.5);
  const { name, bytes } = await savedScene(heatwalk);
  expect(name).toBe('grid.heatwalk.zip');

  await heatwalk.open('#v=1&m=icosphere');
  await dropScene(heatwalk, name, bytes, 'grid.off');
  await heatwalk.settled();
  expect(await state(heatwalk)).toEqual(before);
  expect(await heatwalk.distanceAt(PLACE)).toBeCloseTo(distance, 9);

  await heatwalk.open('#v=1&m=bunny&s=12&look=neon');
  await heatwalk.settled();
  const bunny = await state(heatwalk);
  const preset = await savedScene(heatwalk);
  expect(preset.bytes.length).toBeLessThan(1000);
  await heatwalk.open('#v=1&m=icosphere');
  await dropScene(heatwalk, preset.name, preset.bytes, 'bunny');
  expect(await state(heatwalk)).toEqual(bunny);

  await heatwalk.drop([['broken.heatwalk.zip', preset.bytes.subarray(0, -9)]]);
  await expect(page.getByRole('alert')).toContainText('broken.heatwalk.zip was not opened');
  expect(await state(heatwalk)).toEqual(bunny);
});
