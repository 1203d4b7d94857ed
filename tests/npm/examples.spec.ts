/** The examples of the package run in a browser, and look as they should. */
import { cpSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import * as esbuild from 'esbuild';
import { PNG } from 'pngjs';
import { Host } from '../server';
import { installed } from './installed';

const ROOT = join(import.meta.dirname, '..', '..');
const MAIN = `import { show } from './three.js';
globalThis.shown = show(document.querySelector('canvas'));
`;
const [WIDTH, HEIGHT] = [480, 360];

const folder = installed();

test('agents of the example of three.js walk on its surface', async ({ page }) => {
  const own = folder();
  cpSync(join(ROOT, 'crate', 'npm', 'examples', 'three.js'), join(own, 'three.js'));
  writeFileSync(join(own, 'main.js'), MAIN);
  writeFileSync(
    join(own, 'index.html'),
    `<!doctype html><canvas width="${WIDTH}" height="${HEIGHT}"></canvas><script type="module" src="out.js"></script>`,
  );
  await esbuild.build({
    entryPoints: [join(own, 'main.js')],
    bundle: true,
    format: 'esm',
    outfile: join(own, 'out.js'),
    nodePaths: [join(ROOT, 'node_modules')],
  });
  const host = await Host.start({}, {}, own);
  try {
    await page.goto(host.page);
    const positions = () =>
      page.evaluate(async () => {
        type Shown = { instanced: { instanceMatrix: { array: Float32Array } } };
        const { instanced } = await (globalThis as unknown as { shown: Promise<Shown> }).shown;
        const { array } = instanced.instanceMatrix;
        return Array.from({ length: 10_000 }, (_, k) => [12, 13, 14].map((entry) => array[16 * k + entry] ?? NaN));
      });
    const before = await positions();
    await expect
      .poll(async () => (await positions()).filter((place, k) => String(place) !== String(before[k])).length)
      .toBeGreaterThan(9000);
    // All of them lie within the extent of the knot.
    for (const place of await positions()) expect(Math.hypot(...place)).toBeLessThan(2);
    const png = PNG.sync.read(await page.locator('canvas').screenshot());
    const isPink = (k: number) => (png.data[4 * k] ?? 0) > 1.5 * (png.data[4 * k + 1] ?? 0) + 20;
    const pink = Array.from({ length: png.width * png.height }, (_, k) => k).filter(isPink).length;
    expect(pink / (png.width * png.height)).toBeGreaterThan(0.005);
  } finally {
    await host.stop();
  }
});
