// npm run build: a static site in dist/ that works from any folder of any static host.
// npm run build:single: the same in one file, dist-single/heatwalk.html, which opens without a host.

import { buildModules, npmProgram, prepare } from './steps.mjs';

prepare();
buildModules();
const named = 'The message above names the cause.';
if (process.argv.includes('--single')) {
  const args = ['build', '--config', 'vite.single.config.ts'];
  npmProgram('Bundling the page into dist-single/heatwalk.html', 'vite/bin/vite.js', args, named);
  process.exit();
}
npmProgram('Bundling the page into dist/', 'vite/bin/vite.js', ['build'], named);
const types = ['--ignoreConfig', '--declaration', '--emitDeclarationOnly', '--strict', '--target', 'es2024'];
const place = ['--module', 'esnext', '--outDir', 'dist', 'web/embed.ts'];
npmProgram('Writing the types of dist/embed.js', 'typescript/bin/tsc', [...types, ...place], named);
