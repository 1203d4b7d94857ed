// npm test: everything. Checks, the Rust tests, the solver's tests on wasm32, the page in a real Chromium, Firefox and WebKit.

import { findReaders } from './peers.mjs';
import {
  cargo,
  findFirefox,
  findWebKit,
  hasSoftwareVulkan,
  npmProgram,
  prepare,
  requireChromium,
  root,
  run,
} from './steps.mjs';

const named = 'The message above names the test.';

prepare();
const chromium = requireChromium();
const firefox = findFirefox();
findWebKit();
const readers = findReaders();
const gpu = hasSoftwareVulkan() ? { HEATWALK_REQUIRE_GPU: '1' } : {};
run('Checking format, lint and types', process.execPath, [`${root}tools/check.mjs`], 'npm run check repeats it.');
// Tests that need large meshes are ignored where the folder of these is not known.
const all = process.env.HEATWALK_MESHES ? ['--', '--include-ignored'] : [];
cargo('Running the Rust tests', ['test', '--workspace', ...all], named, gpu);
cargo("Running the solver's tests on wasm32", ['xtask', 'test-wasm'], named);
run('Building the page', process.execPath, [`${root}tools/build.mjs`], 'npm run build repeats it.');
const single = [`${root}tools/build.mjs`, '--single'];
run('Building the page in one file', process.execPath, single, 'npm run build:single repeats it.');
const browsers = { CHROMIUM: chromium, FIREFOX: firefox, HEATWALK_PYTHON: readers };
npmProgram('Running the page in Chromium, Firefox and WebKit', '@playwright/test/cli.js', ['test'], named, browsers);
