#!/usr/bin/env node
// What `cargo test --doc` runs for rustdoc: builds the documentation too, and makes an error of each warning. `cargo doc` would check
// all crates anew that are compiled for tests already.

import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { root } from './steps.mjs';

const given = process.argv.slice(2);
/** Only options of tests, which name the folder that these run in, and compilers to run them with. */
const ofTests = (each, index) => each.startsWith('--test') || given[index - 1]?.startsWith('--test-');
const documented = given.filter((each, index) => !ofTests(each, index));

if (documented.length < given.length) rustdoc([...documented, '-Dwarnings', '--out-dir', join(root, 'target', 'doc')]);
rustdoc(given);

/** Ends the program where it fails. */
function rustdoc(args) {
  const { status } = spawnSync('rustdoc', args, { stdio: 'inherit' });
  if (status !== 0) process.exit(status ?? 1);
}
