#!/usr/bin/env node
// What cargo runs for the compiler where crates of this workspace are linted while they are compiled (RUSTC_WORKSPACE_WRAPPER): with
// the compiler and its arguments. Clippy compiles too, but leaves all optimization to LLVM. Natively that makes no difference; modules
// of wasm take a quarter longer, so that these are linted first, and then compiled as they always are.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';

const [compiler, ...given] = process.argv.slice(2);
const beside = join(dirname(compiler), 'clippy-driver');
const driver = existsSync(beside) ? beside : 'clippy-driver';
/** Cargo also asks what the compiler is, and what it can do. */
const compiles = given.includes('--crate-name') && !given.includes('-');

if (!compiles) run(compiler, given);
else if (given.includes('wasm32-unknown-unknown')) {
  const folder = mkdtempSync(join(tmpdir(), 'lint-'));
  const status = end(driver, [compiler, ...checking(given, folder)]);
  rmSync(folder, { recursive: true });
  if (status !== 0) process.exit(status);
  run(compiler, given);
} else run(driver, [compiler, ...given]);

/** Arguments that compile nothing, and tell cargo of no file that is not there yet. */
function checking(args, folder) {
  const INCREMENTAL = 'incremental=';
  const isIncremental = (each, index) =>
    each.startsWith(INCREMENTAL) || (each === '-C' && args[index + 1]?.startsWith(INCREMENTAL));
  return args
    .map((each, index) => (args[index - 1] === '--out-dir' ? folder : each))
    .map((each) => (each.startsWith('--emit=') ? '--emit=metadata' : each))
    .map((each) => (each.startsWith('--json=') ? each.replace(/artifacts,|,artifacts/, '') : each))
    .filter((each, index) => !isIncremental(each, index));
}

function run(program, args) {
  process.exit(end(program, args));
}

function end(program, args) {
  return spawnSync(program, args, { stdio: 'inherit' }).status ?? 1;
}
