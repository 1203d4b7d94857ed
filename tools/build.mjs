// npm run build: a static site in dist/ that works from any folder of any static host.

import { buildModules, npmProgram, prepare } from './steps.mjs';

prepare();
buildModules();
const named = 'The message above names the cause.';
npmProgram('Bundling the page into dist/', 'vite/bin/vite.js', ['build'], named);
const types = ['--ignoreConfig', '--declaration', '--emitDeclarationOnly', '--strict', '--target', 'es2024'];
const place = ['--module', 'esnext', '--outDir', 'dist', 'web/embed.ts'];
npmProgram('Writing the types of dist/embed.js', 'typescript/bin/tsc', [...types, ...place], named);
