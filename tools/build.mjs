// npm run build: a static site in dist/ that works from any folder of any static host.
// npm run build:single: the same in one file, dist-single/heatwalk.html, which opens without a host.

import { bundle, bundleSingle, publishModules } from './bundle.mjs';
import { prepare } from './needs.mjs';
import { npmProgram } from './steps.mjs';

prepare();
publishModules();
if (process.argv.includes('--single')) {
  bundleSingle();
} else {
  bundle();
  const types = ['--ignoreConfig', '--declaration', '--emitDeclarationOnly', '--strict', '--target', 'es2024'];
  const place = ['--module', 'esnext', '--outDir', 'dist', 'web/embed.ts'];
  npmProgram('Writing the types of dist/embed.js', 'typescript/bin/tsc', [...types, ...place], 'See above.');
}
