/** Help where it is needed: keys and gestures, a line on every setting, the documents, the first hints. */
import type { Route } from '@playwright/test';
import { violations } from '../axe';
import { expect, openSection, test } from '../page';

test('help tells what the keys do, explains every setting, and leads to documents with a search', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  await page.keyboard.press('?');
  const dialog = page.getByRole('dialog', { name: 'Help' });
  await expect(dialog.getByRole('row', { name: 'Frame the model' })).toContainText('F');
  await expect(dialog.getByRole('columnheader', { name: 'Mouse' })).toBeVisible();
  await dialog.getByLabel('Explain every setting').check();
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);

  // Every setting has its line, also those that are not to be seen now, or are fetched when their section is expanded.
  const unexplained = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('.panel .field')]
        .filter((field) => !field.nextElementSibling?.classList.contains('explanation'))
        .map((field) => `${field.closest('[id^=section-]')?.id}: ${field.querySelector('span')?.textContent}`),
    );
  await openSection(page, 'export');
  await expect(page.getByLabel('Isolines at', { exact: true })).toBeVisible();
  const compare = await openSection(page, 'compare');
  await compare.scrollIntoViewIfNeeded();
  await expect(compare.getByRole('button').first()).toBeVisible();
  await expect.poll(unexplained).toEqual([]);
  await openSection(page, 'style');
  await expect(page.locator('#section-style .explanation').first()).toBeVisible();
  await openSection(page, 'solver');

  const documents = page.waitForEvent('popup');
  await page.locator('#section-solver').getByRole('link', { name: 'More about Path' }).click();
  const method = await documents;
  await expect(method.getByRole('heading', { name: 'Paths' })).toBeInViewport();
  await method.getByRole('searchbox').fill('intrinsic delaunay');
  await method.getByRole('link', { name: /intrinsic Delaunay triangulation/ }).click();
  await expect(method).toHaveURL(/method\.html#operator-the-intrinsic-delaunay-triangulation$/);
  await method.goto('./docs/gallery.html');
  await expect(method.getByRole('img').first()).toHaveJSProperty('complete', true);
  expect(
    await method
      .getByRole('img')
      .first()
      .evaluate((image: HTMLImageElement) => image.naturalWidth),
  ).toBeGreaterThan(0);
});

test('help tells what becomes of files, where the source is, and how a fault is reported, with nothing sent', async ({
  heatwalk,
  page,
}) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await heatwalk.open();
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  const dialog = page.getByRole('dialog', { name: 'Help' });
  const openHelp = () => page.getByRole('button', { name: 'Help' }).click();
  await openHelp();
  await expect(dialog).toContainText('Nothing is uploaded, counted or tracked');
  await expect(dialog).toContainText('kept in this browser only');
  await expect(dialog).toContainText('has not said where its source is');
  expect(await violations(page)).toEqual([]);
  await dialog.getByRole('button', { name: 'Copy report' }).click();
  await expect(dialog.getByText('Copied.')).toBeVisible();
  const report = JSON.parse(await page.evaluate(() => navigator.clipboard.readText())) as Record<string, unknown>;
  expect(report).toMatchObject({ backend: 'WebGL2', mesh: { name: 'bunny', triangles: 3674 }, method: 'heat' });
  expect(report['link']).toBe(page.url());
  expect(report['build']).toMatch(/assets\/index-.*\.js$/);
  const saving = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save scene' }).click();
  expect((await saving).suggestedFilename()).toBe('bunny.heatwalk.zip');
  const { origin } = new URL(page.url());
  expect(asked.filter((address) => !address.startsWith(origin) && !address.startsWith('blob:'))).toEqual([]);

  // As a build has it that was told.
  await page.keyboard.press('Escape');
  await page.evaluate(() => {
    document.head.append(
      Object.assign(document.createElement('meta'), {
        name: 'heatwalk-source',
        content: 'https://code.example/heatwalk/',
      }),
    );
  });
  await openHelp();
  const link = (name: string) => dialog.getByRole('link', { name });
  await expect(link('The source, and its license')).toHaveAttribute('href', 'https://code.example/heatwalk');
  await expect(link('A new report')).toHaveAttribute('href', 'https://code.example/heatwalk/issues/new');
  await expect(link('What the page is made of')).toHaveAttribute('href', './docs/licenses.html');

  // What is shown beside a link to the page.
  const image = await page.evaluate(async () => {
    const address = document.querySelector<HTMLMetaElement>('meta[property="og:image"]')?.content ?? '';
    const file = await (await fetch(address)).blob();
    const { width, height } = await createImageBitmap(file);
    return { width, height, type: file.type, bytes: file.size };
  });
  expect(image).toMatchObject({ width: 1200, height: 630, type: 'image/jpeg' });
  expect(image.bytes).toBeLessThan(100_000);
});

test('hints follow what the hand does, and are not told again', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const hint = page.locator('.hint');
  await expect(hint).toContainText('Click the surface');
  const [x, y] = await heatwalk.pixelOnModel();
  await page.mouse.click(x, y);
  await expect(hint).toContainText('Drag the pin');
  const [pin] = (await heatwalk.scene()).sources;
  const place = await heatwalk.pixelOf(pin);
  await page.mouse.move(...place);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 10, { steps: 3 });
  await page.mouse.up();
  await expect(hint).toContainText('sends the walker');
  await heatwalk.open();
  await expect(hint).toContainText('sends the walker');
  // Without sources there is nothing to lead to; with another tool a click does something else.
  await page.getByRole('button', { name: 'Delete source 1' }).click();
  await expect(hint).toContainText('Click the surface');
  await page.keyboard.press('m');
  await expect(hint).toBeHidden();
  await page.keyboard.press('m');
  await page.keyboard.press('Control+z');
  await expect(hint).toContainText('sends the walker');
  await page.keyboard.down('Alt');
  await page.mouse.click(...(await heatwalk.pixelOnModel(0.08, 0.05)));
  await page.keyboard.up('Alt');
  await expect(hint).toBeHidden();
});

test('what the hand has done before hints have come needs none', async ({ heatwalk, page }) => {
  const held: Route[] = [];
  await page.route('**/assets/later-*.js', (route) => {
    held.push(route);
  });
  const asked = page.waitForRequest('**/assets/later-*.js');
  await heatwalk.open();
  await asked;
  await page.mouse.click(...(await heatwalk.pixelOnModel()));
  await expect.poll(async () => 'face' in (await heatwalk.scene()).sources[0]).toBe(true);
  for (const route of held) await route.continue();
  await expect(page.locator('.hint')).toContainText('Drag the pin');
});
