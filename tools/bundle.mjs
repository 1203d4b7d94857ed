// The wasm modules and the page that is bundled with them.

import { join } from 'node:path';
import { requireWasm } from './needs.mjs';
import { cargo, npmProgram, root } from './steps.mjs';

const named = 'The message above names the cause.';

/** Where the page for tests is bundled, beside the one that is published. */
export const TESTED_PAGE = join(root, 'target', 'page');
export const TESTED_FILE = join(root, 'target', 'page-single');

/** The wasm modules with their bindings, in web/wasm, as they are published: small, fast, minutes to compile. */
export function publishModules() {
  requireWasm();
  cargo('Building the wasm modules to publish (minutes the first time, seconds after)', ['xtask', 'wasm'], named);
}

/** The same to develop with: larger, and compiled in less time. */
export function buildModules() {
  requireWasm();
  cargo('Building the wasm modules (minutes the first time, seconds after)', ['xtask', 'wasm', '--quick'], named);
}

/** Those of the npm package, as they are published. */
export function publishPackageModules() {
  requireWasm();
  cargo("Building the npm package's modules to publish", ['xtask', 'wasm-package'], named);
}

/** The page with the modules that were built last. */
export function bundle(folder = 'dist') {
  const args = ['build', '--logLevel', 'warn', '--outDir', folder, '--emptyOutDir'];
  npmProgram('Bundling the page', 'vite/bin/vite.js', args, named);
}

/** The site that is published, in dist/. */
export function buildSite() {
  bundle();
  const types = ['--ignoreConfig', '--declaration', '--emitDeclarationOnly', '--strict', '--target', 'es2024'];
  const place = ['--module', 'esnext', '--outDir', 'dist', 'web/embed.ts'];
  npmProgram('Writing the types of dist/embed.js', 'typescript/bin/tsc', [...types, ...place], named);
}

/** The same in one file. */
export function bundleSingle(folder = 'dist-single') {
  const args = [
    'build',
    '--logLevel',
    'warn',
    '--config',
    'vite.single.config.ts',
    '--outDir',
    folder,
    '--emptyOutDir',
  ];
  npmProgram('Bundling the page in one file', 'vite/bin/vite.js', args, named);
}
