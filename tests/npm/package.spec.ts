/** The npm package as it would be published, in a fresh folder: in Node, and in a browser under each bundler. */
import { cpSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { nodeResolve } from '@rollup/plugin-node-resolve';
import { expect, test, type Page } from '@playwright/test';
import * as esbuild from 'esbuild';
import { rollup } from 'rollup';
import * as vite from 'vite';
import webpack from 'webpack';
import { Host } from '../server';
import { installed } from './installed';

const ENTRIES = ['heatwalk', 'heatwalk/inline'];
const MAIN = `import { tried } from './trial.js';
tried().then((told) => (globalThis.told = told), (error) => (globalThis.told = String(error?.stack ?? error)));
`;

/** What there is to learn in the plane. */
const EXPECTED = {
  distances: [0, 1, 2, 1, Math.SQRT2, Math.sqrt(5), 2, Math.sqrt(5), Math.sqrt(8)],
  length: Math.sqrt(8),
  ended: 'AbortError',
  polygons: 1,
  single: ['Float32Array', Math.fround(Math.SQRT2)],
  refused: [true, 'no-such-vertex'],
  again: Math.sqrt(8),
  start: [2, 2, 0, 2, 1, 0],
  matrices: 32,
  lost: 'no-such-agent',
  stayed: ['AbortError', true],
  packed: [1, 1, 'malformed', 'over-budget'],
};

const folder = installed();

/** A folder of an application that uses an entry. */
function application(name: string, entry: string): string {
  const own = mkdtempSync(join(folder(), `${name}-`));
  writeFileSync(join(own, 'main.js'), MAIN);
  const trial = readFileSync(join(import.meta.dirname, 'trial.js'), 'utf8');
  writeFileSync(join(own, 'trial.js'), trial.replace("'heatwalk'", `'${entry}'`));
  return own;
}

function expectPlane(told: typeof EXPECTED) {
  expect(told).toEqual({ ...EXPECTED, distances: told.distances, length: told.length, again: told.again });
  for (const [vertex, distance] of EXPECTED.distances.entries())
    expect(told.distances[vertex]).toBeCloseTo(distance, 12);
  expect(told.length).toBeCloseTo(EXPECTED.length, 12);
  expect(told.again).toBeCloseTo(EXPECTED.again, 12);
}

const html = (script: string) => `<!doctype html><title>Trial</title><script type="module" src="${script}"></script>`;

async function opened(page: Page, address: string) {
  await page.goto(address);
  await expect.poll(() => page.evaluate(() => 'told' in globalThis)).toBe(true);
  expectPlane(await page.evaluate(() => (globalThis as unknown as { told: typeof EXPECTED }).told));
}

/** Serves a folder to a page that runs its script. */
async function served(page: Page, own: string, script: string, headers = {}) {
  writeFileSync(join(own, 'index.html'), html(script));
  const host = await Host.start(headers, {}, own);
  try {
    await opened(page, host.page);
  } finally {
    await host.stop();
  }
}

for (const entry of ENTRIES) {
  test.describe(entry, () => {
    test('runs in Node', async () => {
      const { tried } = await import(pathToFileURL(join(application('node', entry), 'trial.js')).href);
      expectPlane(await tried());
    });

    test('runs bundled by esbuild', async ({ page }) => {
      const own = application('esbuild', entry);
      const outfile = join(own, 'out', 'main.js');
      await esbuild.build({ entryPoints: [join(own, 'main.js')], bundle: true, format: 'esm', outfile });
      await served(page, join(own, 'out'), 'main.js');
    });

    test('runs bundled by Rollup', async ({ page }) => {
      const own = application('rollup', entry);
      const bundle = await rollup({ input: join(own, 'main.js'), plugins: [nodeResolve({ browser: true })] });
      await bundle.write({ dir: join(own, 'out'), format: 'es' });
      await served(page, join(own, 'out'), 'main.js');
    });

    test('runs bundled by webpack', async ({ page }) => {
      const own = application('webpack', entry);
      const path = join(own, 'out');
      const compiler = webpack({
        context: own,
        entry: './main.js',
        mode: 'production',
        output: { path, filename: 'main.js' },
        performance: false,
      });
      const stats = await new Promise<webpack.Stats | undefined>((resolve, reject) => {
        compiler?.run((error, result) => (error ? reject(error) : resolve(result)));
      });
      expect(stats?.toJson().errors).toEqual([]);
      expect(stats?.toJson().warnings).toEqual([]);
      await served(page, path, 'main.js');
    });

    test('runs built by Vite', async ({ page }) => {
      const own = application('vite', entry);
      writeFileSync(join(own, 'index.html'), html('./main.js'));
      await vite.build({ root: own, base: './', configFile: false, logLevel: 'error' });
      const host = await Host.start({}, {}, join(own, 'dist'));
      await opened(page, host.page).finally(() => host.stop());
    });

    test('runs in the server of Vite', async ({ page }) => {
      const own = application('vite-server', entry);
      writeFileSync(join(own, 'index.html'), html('./main.js'));
      const server = await vite.createServer({
        root: own,
        configFile: false,
        logLevel: 'error',
        server: { port: 0, strictPort: false },
      });
      try {
        await server.listen();
        await opened(page, server.resolvedUrls?.local[0] ?? '');
      } finally {
        await server.close();
      }
    });
  });
}

/** The package beside an application, as it is, and the application with its address. */
function unbundled(name: string, address: string): string {
  const own = application(name, address);
  cpSync(join(folder(), 'node_modules', 'heatwalk', 'dist'), join(own, 'heatwalk'), { recursive: true });
  return own;
}

test('a script of a page takes it as it is, under a policy that allows neither blobs nor eval', async ({ page }) => {
  const own = unbundled('script', './heatwalk/index.js');
  const policy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'";
  await served(page, own, 'main.js', { 'Content-Security-Policy': policy });
});

test('a page takes it from another origin', async ({ page }) => {
  const own = unbundled('far', './heatwalk/index.js');
  const far = await Host.start({ 'Access-Control-Allow-Origin': '*' }, {}, own);
  const address = `${far.other}/in/a/folder/heatwalk/index.js`;
  const near = application('near', address);
  await served(page, near, 'main.js').finally(() => far.stop());
});
