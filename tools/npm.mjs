// The npm package: its files, from the wasm modules that were built last and the TypeScript of crate/npm/package.

import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { fail, npmProgram, root } from './steps.mjs';

const source = join(root, 'crate', 'npm', 'package');
const wasm = join(root, 'web', 'wasm');
const made = join(root, 'target', 'npm');
/** What is packed. */
const folder = join(made, 'package');

const named = 'The message above names the place.';

/** Makes the package, in more time and smaller where it is to be published; gives the file that npm would publish. */
export async function packPackage(isPublished = false) {
  rmSync(made, { recursive: true, force: true });
  mkdirSync(join(folder, 'dist'), { recursive: true });
  await bundle('solver', { PACKED_MODULE: await packed('package', 'heatwalk_npm', isPublished) });
  await bundle('reader', { PACKED_MODULE: await packed('package-reader', 'heatwalk_reader', isPublished) });
  await bundle('worker');
  const WORKER = JSON.stringify(readFileSync(join(folder, 'dist', 'worker.js'), 'utf8'));
  await bundle('text', { WORKER });
  await bundle('index');
  await bundle('inline');
  await bundle('viewer');
  writeTypes();
  for (const name of ['README.md', 'package.json']) cpSync(join(source, name), join(folder, name));
  for (const name of ['LICENSE-MIT', 'LICENSE-APACHE']) cpSync(join(root, name), join(folder, name));
  const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const manifest = JSON.parse(readFileSync(join(source, 'package.json'), 'utf8'));
  writeFileSync(join(folder, 'package.json'), `${JSON.stringify({ ...manifest, version }, null, 2)}\n`);
  const { status, stdout, stderr } = spawnSync('npm', ['pack', '--json', '--pack-destination', made], {
    cwd: folder,
    encoding: 'utf8',
  });
  if (status !== 0) fail(`npm could not pack the package: ${stderr}`);
  return join(made, JSON.parse(stdout)[0].filename);
}

/** The types of the package, and beside them those of the page's messages, which lie elsewhere here. */
function writeTypes() {
  const types = join(made, 'types');
  const options = ['--project', join(source, 'tsconfig.json'), '--outDir', types];
  npmProgram("Writing the npm package's types", 'typescript/bin/tsc', options, named);
  const own = join(types, 'crate', 'npm', 'package', 'src');
  const dist = join(folder, 'dist');
  cpSync(own, dist, { recursive: true });
  cpSync(join(types, 'web', 'embed.d.ts'), join(dist, 'embed.d.ts'));
  const viewer = readFileSync(join(own, 'viewer.d.ts'), 'utf8');
  writeFileSync(join(dist, 'viewer.d.ts'), viewer.replaceAll('../../../../web/embed', './embed'));
}

/** A wasm module, deflated, in base64, as text of JavaScript. */
async function packed(module, name, isPublished) {
  const bytes = readFileSync(join(wasm, module, `${name}_bg.wasm`));
  // What npm installs is not there before it has.
  const deflated = isPublished ? await (await import('@gfx/zopfli')).deflateAsync(bytes, {}) : deflateRawSync(bytes);
  return JSON.stringify(Buffer.from(deflated).toString('base64'));
}

/** What is large is in files of its own, and all else of an entry in one. */
const apart = {
  name: 'apart',
  setup({ onResolve }) {
    onResolve({ filter: /^\.\/(solver|reader|text)\.ts$/ }, ({ path }) => ({
      path: path.replace('.ts', '.js'),
      external: true,
    }));
  },
};

async function bundle(entry, define = {}) {
  const { build } = await import('esbuild');
  await build({
    entryPoints: [join(source, 'src', `${entry}.ts`)],
    outdir: join(folder, 'dist'),
    bundle: true,
    format: 'esm',
    target: 'es2022',
    minify: true,
    define,
    plugins: [apart],
    logLevel: 'warning',
  });
}
