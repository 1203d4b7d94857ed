import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { PAGE } from '../built';
import { expect, test } from '../page';
import { Host } from '../server';

test.use({ serviceWorkers: 'allow' });

// The next test has the same browser.
test.afterEach(({ context }) => context.setOffline(false));

const read = (path: string) => readFileSync(`${PAGE}/${path}`, 'utf8');

/** Each needs other files of the build: arrays in a module, a file, tetrahedra, a shape. */
const PRESETS = ['teapot', 'dragon', 'cave', 'robot'];

test('the page can be installed, and after one visit every preset opens without the host, from a folder of it', async ({
  page,
  context,
}) => {
  const host = await Host.start();
  const address = `${host.page}?gpu=webgl`;
  await page.goto(address);
  await page.evaluate(() => window.heatwalk.settled());
  await expectInstallable(page);
  // Until the page has been quiet for a while, or is not looked at any more, nothing more is fetched.
  expect(host.asked.some((path) => path.endsWith('/offline.js'))).toBe(false);
  // A connection that breaks does not lose what is kept.
  host.breaksOff = new URL('docs/gallery.html', address).pathname;
  await page.evaluate(() => {
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
    return navigator.serviceWorker.ready;
  });
  await expect.poll(() => page.evaluate(() => navigator.serviceWorker.controller?.state)).toBe('activated');
  expect(host.breaksOff).toBeNull();
  await host.stop();
  await context.setOffline(true);

  await page.goto(`${address}#m=${PRESETS[0]}`);
  await page.reload();
  await page.evaluate(() => window.heatwalk.ready);
  for (const preset of PRESETS) {
    await page.evaluate((name) => (location.hash = `#m=${name}`), preset);
    await expect.poll(() => page.evaluate(() => window.heatwalk.scene.mesh)).toEqual({ kind: 'preset', id: preset });
    await expect.poll(() => page.evaluate(() => window.heatwalk.mesh?.name.split('.')[0])).toBe(preset);
    await page.evaluate(() => window.heatwalk.settled());
    await expect(page).toHaveURL(new RegExp(`m=${preset}\\b`));
  }
  await expect(page.getByRole('alert')).toBeEmpty();

  // So do the documents, with their style, their pictures and their search.
  await page.goto(new URL('docs/', address).href);
  await page.getByRole('main').getByRole('link', { name: 'Gallery' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Gallery');
  const width = () =>
    page
      .locator('main img')
      .first()
      .evaluate((image: HTMLImageElement) => image.naturalWidth);
  await expect.poll(width).toBeGreaterThan(0);
  await page.getByRole('searchbox').fill('Dirichlet');
  await expect(page.locator('.found a').first()).toBeVisible();
});

test('a new version is offered, never forced: the page stays until it is reloaded, with its scene', async ({
  page,
}) => {
  const host = await Host.start();
  const hide = () =>
    page.evaluate(() => {
      Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
      return navigator.serviceWorker.ready;
    });
  const update = () => page.evaluate(async () => void (await (await navigator.serviceWorker.ready).update()));
  const build = () =>
    page.evaluate(() => document.querySelector('script[src*="assets/"]')?.getAttribute('src')?.split('/').pop());
  await page.goto(`${host.page}?gpu=webgl#m=icosphere`);
  await page.evaluate(() => window.heatwalk.settled());
  await hide();
  await expect.poll(() => page.evaluate(() => navigator.serviceWorker.controller?.state)).toBe('activated');
  const first = String(await build());
  const offer = page.getByText('A new version of this page is ready.');
  await update();

  // The same page as another build has it.
  const { pathname } = new URL(host.page);
  const renewed = (text: string) => text.replaceAll(first, 'renewed.js');
  host.pages[pathname] = renewed(read('index.html'));
  host.pages[`${pathname}assets/renewed.js`] = read(`assets/${first}`);
  host.pages[`${pathname}offline.js`] = renewed(read('offline.js')).replace(/"build":"\w+"/, '"build":"renewed"');
  expect(host.pages[`${pathname}offline.js`]).toContain('"build":"renewed"');
  await page.evaluate(() => window.heatwalk.setSources([{ vertex: 5 }]));
  await expect(page).toHaveURL(/s=5\b/);
  await expect(offer).toBeHidden();
  await update();
  await expect(offer).toBeVisible({ timeout: 30_000 });
  expect(await build()).toBe(first);
  expect(await page.evaluate(() => window.heatwalk.scene.sources)).toEqual([{ vertex: 5 }]);

  // Without the host: what waits is kept already.
  await page.context().setOffline(true);
  const loaded = page.waitForEvent('load');
  await page.getByRole('button', { name: 'Reload, with the scene as it is' }).click();
  await loaded;
  await page.waitForFunction(() => 'heatwalk' in window);
  await page.evaluate(() => window.heatwalk.ready);
  expect(await build()).toBe('renewed.js');
  expect(await page.evaluate(() => window.heatwalk.scene.sources)).toEqual([{ vertex: 5 }]);
  await page.context().setOffline(false);
  await hide();
  await expect(offer).toBeHidden();
  await host.stop();
});

/** What Chromium says that keeps a page from being installed, and what the system needs to open files with it. */
async function expectInstallable(page: Page): Promise<void> {
  const manifest = JSON.parse(read('manifest.webmanifest')) as {
    icons: { src: string; sizes: string }[];
    file_handlers: { accept: Record<string, string[]> }[];
  };
  for (const { src, sizes } of manifest.icons.filter((icon) => icon.sizes !== 'any')) {
    const width = await page.evaluate(
      async (file) => (await createImageBitmap(await (await fetch(file)).blob())).width,
      src,
    );
    expect(`${width}x${width}`).toBe(sizes);
  }
  const session = await page.context().newCDPSession(page);
  const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
  // A context of tests is one that keeps nothing.
  expect(installabilityErrors.map(({ errorId }) => errorId)).toEqual(['in-incognito']);
  const extensions = manifest.file_handlers.flatMap(({ accept }) => Object.values(accept).flat());
  for (const extension of ['.glb', '.gltf', '.obj', '.off', '.ply', '.stl', '.zip'])
    expect(extensions).toContain(extension);
}
