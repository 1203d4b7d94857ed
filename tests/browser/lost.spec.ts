import { crossings, expect, HeatwalkPage, test } from '../page';

// Only WebGL lets a page lose its context on purpose; what follows is the same on both backends.
test('a lost graphics context is restored with the scene intact', async ({ page }) => {
  const heatwalk = new HeatwalkPage(page, 'WebGL2');
  await heatwalk.open();
  const [x, y] = await heatwalk.pixelOnModel();
  const stripes = async () => crossings(await heatwalk.picture(), x, y - 150, y + 150);
  const before = await stripes();
  expect(before).toBeGreaterThanOrEqual(6);

  const lost = await page.locator('canvas').elementHandle();
  await page.evaluate(() => {
    document.querySelector('canvas')?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await expect.poll(() => lost?.evaluate((canvas) => canvas.isConnected)).toBe(false);
  await expect.poll(() => page.evaluate(() => window.heatwalk.backend)).toBe('WebGL2');
  await expect.poll(stripes).toBe(before);
});
