import type { Page } from '@playwright/test';
import { crossings, expect, HeatwalkPage, SEEN, test } from '../page';

test.use(SEEN);

/** The page with its first scene, a place on the model, and what counts the stripes there. */
async function striped(page: Page, backend: 'WebGL2' | 'WebGPU') {
  const heatwalk = new HeatwalkPage(page, backend);
  await heatwalk.open();
  const [x, y] = await heatwalk.pixelOnModel();
  const stripes = async () => crossings(await heatwalk.picture(), x, y - 150, y + 150);
  const before = await stripes();
  expect(before).toBeGreaterThanOrEqual(6);
  return { heatwalk, place: [x, y] as const, stripes, before };
}

// Only WebGL lets a page lose its context on purpose; what follows is the same on both backends.
test('a lost graphics context is restored with the scene intact', async ({ page }) => {
  const { stripes, before } = await striped(page, 'WebGL2');
  const lost = await page.locator('.stage canvas').elementHandle();
  await page.evaluate(() => {
    document.querySelector('canvas')?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await expect.poll(() => lost?.evaluate((canvas) => canvas.isConnected)).toBe(false);
  await expect.poll(() => page.evaluate(() => window.heatwalk.backend)).toBe('WebGL2');
  await expect.poll(stripes).toBe(before);
});

test('a renderer that traps restarts with the scene intact', async ({ page }, info) => {
  const backend = info.project.name === 'webgpu' ? 'WebGPU' : 'WebGL2';
  const { heatwalk, place, stripes, before } = await striped(page, backend);

  // The next draw call ends the renderer as a panic does: nothing that was borrowed is given back.
  const canvas = await page.locator('.stage canvas').elementHandle();
  await page.evaluate((isWebGpu) => {
    const target = isWebGpu ? GPURenderPassEncoder.prototype : WebGL2RenderingContext.prototype;
    const name = isWebGpu ? 'drawIndexed' : 'clear';
    const original = Object.getOwnPropertyDescriptor(target, name) ?? {};
    const trap = () => {
      Object.defineProperty(target, name, original);
      throw new WebAssembly.RuntimeError('unreachable');
    };
    Object.defineProperty(target, name, { ...original, value: trap });
  }, heatwalk.backend === 'WebGPU');
  await page.mouse.move(...place);
  await page.mouse.wheel(0, 1);
  await expect.poll(() => canvas?.evaluate((element) => element.isConnected)).toBe(false);
  await expect.poll(() => page.evaluate(() => window.heatwalk.backend)).toBe(heatwalk.backend);
  await expect.poll(stripes).toBe(before);
  await expect(page.getByRole('alert')).toContainText('The renderer failed and was restarted');

  // The fresh one takes another mesh.
  await page.getByRole('button', { name: 'Sphere', exact: true }).click();
  await expect.poll(() => page.evaluate(() => window.heatwalk.mesh?.name)).toBe('icosphere');
  await heatwalk.pixelOnModel();
});

test('an error of the graphics device is reported, and drawing goes on', async ({ page }, info) => {
  test.skip(info.project.name !== 'webgpu', 'the page can reach the device of WebGPU only');
  const heatwalk = new HeatwalkPage(page, 'WebGPU');
  await page.addInitScript(() => {
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function requestDevice(descriptor) {
      const device = await request.call(this, descriptor);
      Object.assign(window, { device });
      return device;
    };
  });
  await heatwalk.open();
  const before = await page.evaluate(() => window.heatwalk.camera?.[0]);
  // A buffer can be mapped for reading or for writing, not for both. The browser keeps the call back until something is
  // waited for or drawn, and nothing is drawn of its own accord here.
  await page.evaluate(async () => {
    const { device } = window as unknown as { device: GPUDevice };
    device.createBuffer({ size: 16, usage: 3 });
    await device.queue.onSubmittedWorkDone();
  });
  await expect(page.getByRole('alert')).toContainText('The graphics device refused a step');
  await page.locator('.stage').press('ArrowLeft');
  await expect.poll(() => page.evaluate(() => window.heatwalk.camera?.[0])).not.toBe(before);
  expect(await page.evaluate(() => window.heatwalk.backend)).toBe('WebGPU');
});
