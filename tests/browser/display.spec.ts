/** The Display section, the turntable, saved images and videos. */
import fs from 'node:fs';
import { PNG } from 'pngjs';
import { expect, type HeatwalkPage, test } from '../page';

async function expand(heatwalk: HeatwalkPage, title: string): Promise<void> {
  const section = heatwalk.page.locator('details', { has: heatwalk.page.locator('summary', { hasText: title }) });
  if (!(await section.evaluate((details: HTMLDetailsElement) => details.open)))
    await section.locator('summary').click();
}

test('overlays are switched on and off, and one gradient replaces the other', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=hemisphere');
  await expand(heatwalk, 'Display');
  await page.getByLabel('Mesh edges').check();
  await page.getByLabel('Heat gradient').check();
  await page.getByLabel('Distance gradient').check();
  expect((await heatwalk.scene()).overlays).toEqual(['scenery', 'edges', 'distance']);
  await page.getByLabel('Inactive parts (scenery)').uncheck();
  expect((await heatwalk.scene()).overlays).toEqual(['edges', 'distance']);
  await expect(page.locator('.message.error')).toHaveCount(0);
});

test('an inactive part is hidden and shown again, and the link stores it', async ({ heatwalk, page }) => {
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

test('the error is shown once it is known', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&refine=0');
  await expand(heatwalk, 'Display');
  await page.getByLabel('Color by').selectOption('error of the heat method');
  await expect(page.getByText('The error is known once all distances are exact.')).toBeVisible();
  await heatwalk.open('#v=1&m=bunny&paint=error');
  await expand(heatwalk, 'Display');
  await heatwalk.settled();
  await expect(page.getByText(/Relative error: mean [\d.]+ %/)).toBeVisible();
});

test('a crowd walks, and stands still while paused', async ({ heatwalk, page }) => {
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

test('the turntable rotates the model until it is stopped', async ({ heatwalk, page }) => {
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

test('an image of twice the size of the window is saved', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  await heatwalk.settled();
  await expand(heatwalk, 'Share');
  const saving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save image' }).click();
  const download = await saving;
  expect(download.suggestedFilename()).toBe('bunny.png');
  const picture = PNG.sync.read(fs.readFileSync(await download.path()));
  expect([picture.width, picture.height]).toEqual([2200, 1440]);
});

for (const subject of ['Turntable', 'The walk']) {
  test(`a video is saved: ${subject}`, async ({ heatwalk, page }) => {
    await page.setViewportSize({ width: 900, height: 480 });
    // The user asked for the video, so it moves all the same.
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await heatwalk.open('#v=1&m=teapot');
    await heatwalk.settled();
    await expand(heatwalk, 'Share');
    await page.getByLabel('Video').selectOption(subject);
    const saving = page.waitForEvent('download', { timeout: 60_000 });
    await page.getByRole('button', { name: 'Save video' }).click();
    const download = await saving;
    expect(download.suggestedFilename()).toBe('teapot.webm');
    const video = fs.readFileSync(await download.path());
    // Every EBML file, as WebM is one, begins so.
    expect(video.subarray(0, 4).toString('hex')).toBe('1a45dfa3');
    expect(video.length).toBeGreaterThan(10_000);
  });
}
