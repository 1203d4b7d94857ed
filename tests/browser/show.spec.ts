/** What the panel shows beside the distance, the turntable, and pictures and films to keep. */
import fs from 'node:fs';
import { PNG } from 'pngjs';
import { expect, type HeatwalkPage, test } from '../page';

async function unfold(heatwalk: HeatwalkPage, title: string): Promise<void> {
  const section = heatwalk.page.locator('details', { has: heatwalk.page.locator('summary', { hasText: title }) });
  if (!(await section.evaluate((details: HTMLDetailsElement) => details.open)))
    await section.locator('summary').click();
}

test('overlays are switched on and off, and one kind of arrows takes the place of the other', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#v=1&m=hemisphere');
  await unfold(heatwalk, 'Show');
  await page.getByLabel('Edges of the mesh').check();
  await page.getByLabel('Arrows, gradient of heat').check();
  await page.getByLabel('Arrows, gradient of distance').check();
  expect((await heatwalk.scene()).overlays).toEqual(['scenery', 'edges', 'distance']);
  await page.getByLabel('Parts not walked on').uncheck();
  expect((await heatwalk.scene()).overlays).toEqual(['edges', 'distance']);
  await expect(page.locator('.message.error')).toHaveCount(0);
});

test('a part that is not walked on is hidden and shown again, and the link says so', async ({ heatwalk, page }) => {
  await page.setViewportSize({ width: 900, height: 480 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await heatwalk.open('#v=1&m=hemisphere');
  await heatwalk.settled();
  const picture = () => page.evaluate(async () => (await window.heatwalk.picture(0.5, true)).size);
  const whole = await picture();
  await page.getByRole('button', { name: /^Hide / }).click();
  await expect.poll(picture).not.toBe(whole);
  expect((await heatwalk.scene()).hidden).toEqual([1]);
  await expect.poll(() => page.url()).toContain('hide=1');
  await page.getByRole('button', { name: /^Show / }).click();
  await expect.poll(picture).toBe(whole);
});

test('the error is told once it is known', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&refine=0');
  await unfold(heatwalk, 'Show');
  await page.getByLabel('Painted').selectOption('error of the heat method');
  await expect(page.getByText('The error is known once every distance is exact.')).toBeVisible();
  await heatwalk.open('#v=1&m=bunny&paint=error');
  await unfold(heatwalk, 'Show');
  await heatwalk.settled();
  await expect(page.getByText(/Relative to the exact distance: [\d.]+ % in the mean/)).toBeVisible();
});

test('a crowd walks, and stands still when it is paused', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&w=none&crowd=300');
  await heatwalk.settled();
  const picture = () =>
    page.evaluate(async () => {
      const bytes = new Uint8Array(await (await window.heatwalk.picture(0.5)).arrayBuffer());
      return Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
    });
  const before = await picture();
  await expect.poll(async () => (await picture()) === before).toBe(false);
  await page.keyboard.press('p');
  await expect
    .poll(async () => {
      const one = await picture();
      return (await picture()) === one;
    })
    .toBe(true);
});

test('the turntable turns the model until it is stopped', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  const yaw = () => page.evaluate(() => window.heatwalk.camera?.[0] ?? 0);
  const before = await yaw();
  await page.getByRole('button', { name: 'Turntable' }).click();
  await expect.poll(yaw).not.toBe(before);
  await page.keyboard.press('t');
  await heatwalk.rest();
  const after = await yaw();
  await expect.poll(async () => (await heatwalk.scene()).camera?.[0]).toBe(after);
});

test('a picture of twice the size of the window is saved', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  await heatwalk.settled();
  await unfold(heatwalk, 'Share');
  const saving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save picture' }).click();
  const download = await saving;
  expect(download.suggestedFilename()).toBe('bunny.png');
  const picture = PNG.sync.read(fs.readFileSync(await download.path()));
  expect([picture.width, picture.height]).toEqual([2200, 1440]);
});

for (const subject of ['One turn', 'The walk home']) {
  test(`a film is saved: ${subject}`, async ({ heatwalk, page }) => {
    await page.setViewportSize({ width: 900, height: 480 });
    // A film was asked for: it moves all the same.
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await heatwalk.open('#v=1&m=teapot');
    await heatwalk.settled();
    await unfold(heatwalk, 'Share');
    await page.getByLabel('Film').selectOption(subject);
    const saving = page.waitForEvent('download', { timeout: 60_000 });
    await page.getByRole('button', { name: 'Save film' }).click();
    const download = await saving;
    expect(download.suggestedFilename()).toBe('teapot.webm');
    const film = fs.readFileSync(await download.path());
    // Every EBML file, as WebM is one, begins so.
    expect(film.subarray(0, 4).toString('hex')).toBe('1a45dfa3');
    expect(film.length).toBeGreaterThan(10_000);
  });
}
