/** Which build of the renderer a browser fetches, what it falls back to, and the bytes until the first picture. */
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';
import type { Page } from '@playwright/test';
import { PAGE } from '../built';
import { expect, type HeatwalkPage, test } from '../page';

/** Bytes of all files until the first picture, each after brotli; on either backend. */
const BAR = 0.75e6;

const RENDERER = /heatwalk_viewer_(webgpu|webgl2)_bg-[^/]*\.wasm$/;

/** The paths of what the page asks its host for from now on. */
function requests(page: Page): Set<string> {
  const paths = new Set<string>();
  page.on('request', (request) => {
    const { protocol, pathname } = new URL(request.url());
    if (protocol === 'http:') paths.add(pathname);
  });
  return paths;
}

/** Of which graphics interfaces the renderer was fetched, in this order. */
const fetched = (paths: Set<string>) => [...paths].flatMap((path) => RENDERER.exec(path)?.[1] ?? []);

const backend = ({ page }: HeatwalkPage) => page.evaluate(() => window.heatwalk.backend);

/** Opens the page, with nothing in the address that chooses; the files until its first picture, each once. */
async function firstPicture(page: Page): Promise<Set<string>> {
  await page.goto('./');
  // By the page's own clock: what comes after the first picture is on its way a moment later.
  const addresses = await page.evaluate(async () => {
    await window.heatwalk.ready;
    return performance.getEntriesByType('resource').map(({ name }) => name);
  });
  return new Set(addresses.filter((address) => address.startsWith('http:')).map((address) => basename(address)));
}

test('of the renderers only the one is fetched that the browser can use', async ({ heatwalk, page }) => {
  const paths = requests(page);
  await firstPicture(page);
  expect(await backend(heatwalk)).toBe(heatwalk.backend);
  expect(fetched(paths)).toEqual([heatwalk.backend.toLowerCase()]);
});

// Of the page as it is published, which the slow tests are about.
test('the first picture takes few bytes', { tag: '@slow' }, async ({ page }) => {
  const files = await firstPicture(page);
  const bytes = ['index.html', ...[...files].map((name) => join('assets', name))].map((file) => {
    const content = readFileSync(join(PAGE, file));
    return brotliCompressSync(content, { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } }).length;
  });
  const sum = bytes.reduce((all, each) => all + each, 0);
  // Everything was seen: page, style, solver, renderer, mesh.
  expect(sum).toBeGreaterThan(BAR / 2);
  expect(sum).toBeLessThan(BAR);
});

test('where WebGPU gives no device, the page draws with WebGL2', async ({ heatwalk, page }, info) => {
  test.skip(info.project.name !== 'webgpu', 'the browser has no WebGPU that could fail');
  await page.addInitScript(() => {
    GPUAdapter.prototype.requestDevice = () => Promise.reject(new DOMException('refused', 'OperationError'));
  });
  const paths = requests(page);
  await page.goto('./');
  await page.evaluate(() => window.heatwalk.ready);
  expect(await backend(heatwalk)).toBe('WebGL2');
  expect(fetched(paths)).toEqual(['webgpu', 'webgl2']);
  await expect(page.getByRole('alert')).toBeEmpty();
  await heatwalk.pixelOnModel();
});

test('where WebGPU fails again and again, the page draws with WebGL2', async ({ heatwalk, page }, info) => {
  test.skip(info.project.name !== 'webgpu', 'the browser has no WebGPU that could fail');
  await heatwalk.open();
  const camera = await page.evaluate(() => window.heatwalk.camera);
  // Asked for while there is a renderer: the first frame after the next step takes it away.
  const pixel = await heatwalk.pixelOnModel();
  await page.evaluate(() => {
    GPURenderPassEncoder.prototype.drawIndexed = () => {
      throw new WebAssembly.RuntimeError('unreachable');
    };
  });
  await page.mouse.move(...pixel);
  await page.mouse.wheel(0, 1);
  await expect.poll(() => backend(heatwalk)).toBe('WebGL2');
  await heatwalk.pixelOnModel();
  expect((await page.evaluate(() => window.heatwalk.camera))?.[0]).toBeCloseTo(camera?.[0] ?? NaN);
  // Restarting goes on with what works.
  const lost = await page.locator('.stage canvas').elementHandle();
  await page.evaluate(() => {
    document.querySelector('canvas')?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await expect.poll(() => lost?.evaluate((canvas) => canvas.isConnected)).toBe(false);
  await expect.poll(() => backend(heatwalk)).toBe('WebGL2');
});
