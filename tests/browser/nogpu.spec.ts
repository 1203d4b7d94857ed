import { expect, openSection, test } from '../page';

test.use({
  launchOptions: {
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-quic', '--disable-gpu', '--disable-software-rasterizer', '--disable-3d-apis'],
  },
});

test('without a GPU the page says so and still solves', async ({ page }) => {
  await page.goto('./');
  await page.evaluate(() => window.heatwalk.ready);
  expect(await page.evaluate(() => window.heatwalk.backend)).toBeNull();
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('The scene cannot be drawn');
  await expect(alert.getByRole('button', { name: 'Try again' })).toBeVisible();
  const maxDistance = () => page.evaluate(() => window.heatwalk.field?.maxDistance ?? 0);
  const bunny = await maxDistance();
  expect(bunny).toBeGreaterThan(0);
  await page.getByRole('button', { name: 'Torus', exact: true }).click();
  await expect.poll(maxDistance).not.toBe(bunny);
  await openSection(page, 'numbers');
  await expect(page.locator('#section-numbers')).toContainText('17,280');
  await expect(alert).toContainText('The scene cannot be drawn');
});
