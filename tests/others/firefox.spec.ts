/** What somebody does at first with the page, in Firefox. */
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { off, sphere } from '../fixtures';
import { cameraAtRest } from '../rest';
import { Host } from '../server';
import { Firefox, PROGRAM } from './firefox';

const [WIDTH, HEIGHT] = [800, 560];
/** Where the reference was drawn by another driver, edges of stripes differ. */
const MOST_DIFFERING = 0.02;
/** Of 255. */
const SAME = 40;
const REFERENCE = join('tests', 'pictures', 'firefox.png');

let firefox: Firefox;
let host: Host;

test.skip(!existsSync(PROGRAM), 'there is no Firefox');

test.beforeAll(async () => {
  host = await Host.start();
  firefox = await Firefox.start(WIDTH, HEIGHT);
});

test.afterAll(async () => {
  await firefox.stop();
  await host.stop();
});

test('in Firefox a first visit opens, drops, clicks, drags, shares, saves, and goes on without a network', async () => {
  const { page, saved } = firefox;
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto(`${host.page}#m=icosphere&crowd=0`);
  // Modules may wait for texts beyond the load of the page.
  await page.waitForFunction(() => 'heatwalk' in window);
  await page.evaluate(() => window.heatwalk.settled());
  expect(await page.evaluate(() => window.heatwalk.backend)).toBe('WebGL2');
  const scene = () => page.evaluate(() => window.heatwalk.scene);

  // Drawn as elsewhere.
  const drawn = PNG.sync.read(Buffer.from(await page.evaluate(pictureOf), 'base64'));
  if (process.env['HEATWALK_REDRAW']) writeFileSync(REFERENCE, PNG.sync.write(drawn));
  expect(differing(drawn, PNG.sync.read(readFileSync(REFERENCE)))).toBeLessThan(MOST_DIFFERING);

  // Save, and copy the link.
  const press = (name: string) => page.locator(`#section-share ::-p-text(${name})`).click();
  await page.locator('#tab-share').click();
  await press('Save image');
  await expect.poll(() => readdirSync(saved).filter((name) => name.endsWith('.png'))).toEqual(['icosphere.png']);
  await press('Copy link');
  await page.waitForSelector('#section-share ::-p-text(Copied.)');

  // Drop a file.
  await page.evaluate(
    (content) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], 'ball.off'));
      for (const type of ['dragenter', 'dragover', 'drop'])
        document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
    },
    off(sphere(12)),
  );
  await page.waitForFunction(() => window.heatwalk.mesh?.name === 'ball.off');
  await page.evaluate(() => window.heatwalk.settled());

  // Click a source, then drag it, then turn the model.
  await page.evaluate(cameraAtRest);
  const [x, y] = await page.evaluate(() => window.heatwalk.centre);
  await page.mouse.click(x, y);
  const place = await page.evaluate(([left, top]) => window.heatwalk.placeAt(left, top), [x, y] as const);
  await expect.poll(async () => (await scene()).sources).toEqual([place]);
  await page.evaluate(() => window.heatwalk.settled());
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 5);
  await page.mouse.move(x + 40, y + 10);
  await page.mouse.up();
  await expect.poll(async () => (await scene()).sources[0]).not.toEqual(place);
  const before = await page.evaluate(() => window.heatwalk.camera);
  await page.mouse.move(20, 230);
  await page.mouse.down();
  await page.mouse.move(80, 210);
  await page.mouse.up();
  await expect.poll(() => page.evaluate(() => window.heatwalk.camera)).not.toEqual(before);

  // The browser has kept the file: a reload shows it, and the way back one of another scene.
  await page.reload();
  await page.waitForFunction(() => window.heatwalk?.mesh?.name === 'ball.off');
  await page.evaluate(() => window.heatwalk.open({ preset: 'icosphere' }));
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('m=icosphere');
  await page.evaluate(() => history.back());
  await page.waitForFunction(() => window.heatwalk.mesh?.name === 'ball.off');

  // A link opens the scene that it names.
  await page.goto(`${host.page}#m=torus&s=12&look=gold`);
  await page.waitForFunction(() => window.heatwalk?.mesh?.name === 'torus');
  await page.evaluate(() => window.heatwalk.settled());
  expect(await scene()).toMatchObject({ sources: [{ vertex: 12 }], style: { name: 'gold' } });

  // Without a network.
  await page.evaluate(() => {
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await expect.poll(() => page.evaluate(keptBy), { timeout: 60_000 }).toBe('a worker in control');
  await host.stop();
  await page.reload();
  await page.evaluate(() => window.heatwalk.settled());
  expect((await scene()).sources).toEqual([{ vertex: 12 }]);
  await page.evaluate(() => (location.hash = '#m=teapot'));
  await page.waitForFunction(() => window.heatwalk?.mesh?.name === 'teapot');
  expect(errors).toEqual([]);
});

/** Runs in the page: its picture, in base64. */
async function pictureOf(): Promise<string> {
  const bytes = new Uint8Array(await (await window.heatwalk.picture()).arrayBuffer());
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

/** Runs in the page: how far its service worker is. It takes control once it has kept everything. */
async function keptBy(): Promise<string> {
  if (navigator.serviceWorker.controller) return 'a worker in control';
  const registration = await navigator.serviceWorker.getRegistration();
  if (!registration) return 'no worker';
  const { installing, waiting, active } = registration;
  return `installing: ${installing?.state}, waiting: ${waiting?.state}, active: ${active?.state}`;
}

/** Share of the pixels that differ. */
function differing(one: PNG, other: PNG): number {
  expect([one.width, one.height]).toEqual([other.width, other.height]);
  let count = 0;
  for (let at = 0; at < one.data.length; at += 4) {
    if ([0, 1, 2].some((channel) => Math.abs(one.data[at + channel] - other.data[at + channel]) > SAME)) count += 1;
  }
  return (4 * count) / one.data.length;
}
