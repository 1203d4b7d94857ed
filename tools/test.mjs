// npm test: checks, the Rust tests, those that depend on numbers on wasm32 too, the page in a real Chromium, Firefox and WebKit.
// The modules are those of development, which do the same: none is linked as a whole, which takes minutes.
// npm test -- WORD: the tests alone that have the word in their name.
// npm run test:slow: what is slow by nature: a million triangles, videos in real time, every preset, in the page as it is
// published.

import { join } from 'node:path';
import {
  buildModules,
  bundle,
  bundleSingle,
  publishModules,
  publishPackageModules,
  TESTED_FILE,
  TESTED_PAGE,
} from './bundle.mjs';
import { checkFormat, checkSpelling, lintPage, lintWhileCompiling } from './checks.mjs';
import { packCrates } from './crates.mjs';
import { findFirefox, findMesa, findShell, findWebKit, hasSoftwareVulkan, prepare, requireChromium } from './needs.mjs';
import { packPackage } from './npm.mjs';
import { findReaders } from './peers.mjs';
import { buildPackages, testPackage } from './python.mjs';
import { cargo, npmProgram, output, printTimes, root, runBeside } from './steps.mjs';

const named = 'The message above names the test.';
const PLAYWRIGHT = '@playwright/test/cli.js';

const isSlow = process.argv[2] === '--slow';
const word = isSlow ? undefined : process.argv[2];

prepare();
const chromium = requireChromium();
const shell = findShell();
const firefox = findFirefox();
findWebKit();
findMesa();
const readers = findReaders();
const gpu = hasSoftwareVulkan() ? { HEATWALK_REQUIRE_GPU: '1' } : {};
// Tests that need large meshes are ignored where the folder of these is not known.
const all = process.env.HEATWALK_MESHES ? ['--', '--include-ignored'] : [];
// What builds and runs the wasm modules is compiled with other features of what it builds on, and has been already.
const most = ['--workspace', '--exclude', 'xtask', '--exclude', 'wasm-test-runner'];
const environment = { CHROMIUM: chromium, CHROMIUM_SHELL: shell, FIREFOX: firefox, HEATWALK_PYTHON: readers };

if (isSlow) {
  buildPackages();
  publishModules();
  publishPackageModules();
  await testPage({ HEATWALK_SLOW: '1' });
} else if (word) {
  const only = ['test', ...most, '--lib', '--bins', '--tests', word, ...all];
  cargo(`Running the Rust tests with "${word}" in their name`, only, named, gpu);
  cargo('Running those on wasm32', ['xtask', 'test-wasm', word], named);
  const list = [`${root}node_modules/${PLAYWRIGHT}`, 'test', '--list', '--pass-with-no-tests', '--grep', word];
  if (output(process.execPath, list, environment)?.includes('Total: 0 tests')) {
    console.log(`\nNo test of the page has "${word}" in its name.`);
  } else {
    buildModules();
    await testPage({}, ['--grep', word]);
  }
} else {
  lintWhileCompiling();
  checkFormat();
  checkSpelling();
  await lintPage(buildModules);
  cargo(
    'Compiling and linting Rust',
    ['test', ...most, '--all-targets', '--no-run'],
    'The message above names the place.',
  );
  // One core has nothing to do at times: some programs of tests have one that takes longest, others count what is allocated.
  const examples = 'Building the documentation of Rust and running its examples';
  const documented = { RUSTDOC: join(root, 'tools', 'rustdoc.mjs') };
  const hasDocumentation = runBeside(examples, 'cargo', ['test', ...most, '--doc'], named, documented);
  cargo('Running the Rust tests', ['test', ...most, '--lib', '--bins', '--tests', ...all], named, gpu);
  await hasDocumentation();
  await testPackage(most);
  packCrates();
  cargo('Running the tests of the build steps', ['test', '--package', 'xtask'], named);
  cargo("Running the solver's tests on wasm32", ['xtask', 'test-wasm'], named);
  await testPage();
}
printTimes();

async function testPage(more = {}, chosen = []) {
  bundle(TESTED_PAGE);
  bundleSingle(TESTED_FILE);
  const variables = { ...environment, HEATWALK_PACKAGE: await packPackage(isSlow), ...more };
  npmProgram('Running the page in Chromium, Firefox and WebKit', PLAYWRIGHT, ['test', ...chosen], named, variables);
}
