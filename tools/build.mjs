// npm run build: a static site in dist/ that works from any folder of any static host.

import { buildModules, npmProgram, prepare } from './steps.mjs';

prepare();
buildModules();
npmProgram('Bundling the page into dist/', 'vite/bin/vite.js', ['build'], 'The message above names the cause.');
