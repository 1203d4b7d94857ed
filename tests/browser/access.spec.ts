/** What axe, a checker of accessibility, finds: nothing. */
import { violations } from '../axe';
import { everyWorkspace, expect, openSection, test } from '../page';

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, ${colorScheme}`, async ({ heatwalk, page }) => {
    await page.emulateMedia({ colorScheme });
    await heatwalk.open('#v=1&m=hemisphere&tape=10,200,400!&vs=b:dirichlet,at:0.4');
    await heatwalk.settled();
    await expect(page.getByRole('region', { name: 'Legend' })).toBeVisible();
    expect(await violations(page)).toEqual([]);
    // Fetched when they are seen first.
    await (await openSection(page, 'charts')).scrollIntoViewIfNeeded();
    await expect(page.locator('#section-charts svg').first()).toBeVisible();
    await (await openSection(page, 'compare')).scrollIntoViewIfNeeded();
    await expect(page.getByRole('button', { name: 'Swap sides' })).toBeVisible();
    await openSection(page, 'export');
    await expect(page.getByLabel('Isolines at')).toBeVisible();
    await everyWorkspace(page, async (workspace) =>
      expect([workspace, await violations(page)]).toEqual([workspace, []]),
    );
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: 'Search settings and commands' }).fill('e');
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Open', exact: true }).first().click();
    await expect(page.getByRole('dialog', { name: 'Open' })).toBeVisible();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Help', exact: true }).click();
    await page.getByLabel('Explain every setting').check();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
    expect(await violations(page)).toEqual([]);
    await page.goto('./docs/page.html');
    expect(await violations(page)).toEqual([]);
  });
}

const WINDOWS = [
  { width: 320, height: 640, colorScheme: 'light', forcedColors: 'none' },
  { width: 320, height: 640, colorScheme: 'dark', forcedColors: 'active' },
  { width: 844, height: 390, colorScheme: 'light', forcedColors: 'active' },
  { width: 2560, height: 1440, colorScheme: 'dark', forcedColors: 'none' },
] as const;
for (const { width, height, ...media } of WINDOWS) {
  const colors = media.forcedColors === 'active' ? `${media.colorScheme}, forced colors` : media.colorScheme;
  test(`axe finds nothing on ${width} × ${height} pixels, ${colors}`, async ({ heatwalk, page }) => {
    await page.setViewportSize({ width, height });
    await page.emulateMedia(media);
    await heatwalk.open('#v=1&m=hemisphere&tape=10,200,400!');
    await heatwalk.settled();
    expect(await violations(page)).toEqual([]);
    const handle = page.getByRole('button', { name: 'Expand the panel' });
    if (await handle.isVisible()) await handle.click();
    await everyWorkspace(page, async (workspace) =>
      expect([workspace, await violations(page)]).toEqual([workspace, []]),
    );
    // Nothing is wider than the window: WCAG 1.4.10.
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  });
}

test('what floats over the model is opaque where the system asks for less transparency', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=hemisphere');
  const session = await page.context().newCDPSession(page);
  const toolbar = async (value: string) => {
    await session.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-transparency', value }] });
    return page.locator('.toolbar').evaluate((element) => {
      const { backgroundColor, backdropFilter } = getComputedStyle(element);
      return [backgroundColor, backdropFilter];
    });
  };
  expect(await toolbar('no-preference')).toEqual(['rgba(255, 255, 255, 0.86)', 'blur(16px) saturate(1.4)']);
  expect(await toolbar('reduce')).toEqual(['rgb(255, 255, 255)', 'none']);
  await session.detach();
});

test('arrows scroll the panel while it has the focus; letters act there too, and nowhere once they are off', async ({
  heatwalk,
  page,
}) => {
  await page.setViewportSize({ width: 1000, height: 500 });
  await heatwalk.open();
  await heatwalk.settled();
  await heatwalk.rest();
  const camera = () => page.evaluate(() => window.heatwalk.camera);
  const paused = page.getByRole('button', { name: 'Resume', exact: true });
  const before = await camera();
  await page.locator('#section-scene summary').focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowDown');
  await expect.poll(() => page.locator('.panel-body').evaluate(({ scrollTop }) => scrollTop)).toBeGreaterThan(0);
  expect(await camera()).toEqual(before);
  await page.keyboard.press('p');
  await expect(paused).toBeVisible();
  await page.keyboard.press('?');
  await page.getByLabel('Single-key shortcuts').uncheck();
  await page.keyboard.press('Escape');
  await page.locator('.stage').focus();
  await page.keyboard.press('p');
  await expect(paused).toBeVisible();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(camera).not.toEqual(before);
  // They stay off from one visit to the next.
  await page.reload();
  await heatwalk.settled();
  await page.getByRole('button', { name: 'Help', exact: true }).click();
  await expect(page.getByLabel('Single-key shortcuts')).not.toBeChecked();
});

test('a notice stays until it is closed, and the same one is there once', async ({ heatwalk, page }) => {
  await page.clock.install();
  await heatwalk.open('#v=1&m=hemisphere&t=fast');
  await heatwalk.settled();
  const notice = page.locator('.message.notice', { hasText: 't=fast' });
  await expect(notice).toBeVisible();
  await page.clock.fastForward('10:00');
  await expect(notice).toHaveCount(1);
  await notice.getByRole('button', { name: 'Close the message' }).click();
  await expect(notice).toHaveCount(0);
});

test('what is closed, disabled or taken away leaves the focus near it, or on the model', async ({ heatwalk, page }) => {
  const stage = page.locator('.stage');
  await heatwalk.open('#v=1&m=bunny&tape=10,200;20,300&links=x');
  await heatwalk.settled();
  await page.locator('.message.notice').getByRole('button', { name: 'Close the message' }).press('Enter');
  await expect(stage).toBeFocused();
  const measure = await openSection(page, 'measure');
  await expect(measure.getByRole('button', { name: /^Delete tape/ })).toHaveCount(2);
  await measure.getByRole('button', { name: 'Delete tape 2' }).press('Enter');
  await expect(measure.getByRole('button', { name: /^Delete tape/ })).toHaveCount(1);
  // Whoever deletes one goes on with the next.
  await expect(measure.getByRole('button', { name: 'Delete tape 1' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(measure.locator('summary').first()).toBeFocused();
  const ground = await openSection(page, 'ground');
  await ground.getByRole('button', { name: 'Fill all' }).press('Enter');
  await ground.getByRole('button', { name: 'Clear' }).press('Enter');
  await expect(ground.locator('summary').first()).toBeFocused();
});
