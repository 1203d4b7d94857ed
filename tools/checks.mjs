// What looks at the code without running it. Warnings are errors.

import { join } from 'node:path';
import { requireTypos } from './needs.mjs';
import { cargo, npmProgram, root, run, runBeside } from './steps.mjs';

const named = 'The message above names the place.';
const cut = 'One of the arrows above has to go: what both sides need belongs below both.';
/** These are empty but on wasm32. */
const UNDOCUMENTED = ['worker', 'reader', 'maker', 'interior', 'npm'].flatMap((name) => [
  '--exclude',
  `heatwalk-${name}`,
]);

/** Format, lints, types and cycles of Rust and TypeScript; `modules` builds those of wasm, with which the types of bindings come. */
export async function lint(modules) {
  checkFormat();
  cargo('Linting Rust', ['clippy', '--workspace', '--all-targets', '--', '-Dwarnings'], named);
  await lintPage(modules);
}

/** What is left to check: code for wasm32 alone, documentation, spelling. */
export function lintTheRest() {
  cargo('Linting Rust for wasm32', ['xtask', 'clippy-wasm'], named);
  const flags = { RUSTDOCFLAGS: '-Dwarnings' };
  cargo('Building the documentation of Rust', ['doc', '--workspace', '--no-deps', ...UNDOCUMENTED], named, flags);
  checkSpelling();
}

/**
 * Has all Rust of this workspace linted from now on where it is compiled, natively and for wasm32. Lints apart check all crates that
 * it builds on once more, which would take a tenth of the time of all tests.
 */
export function lintWhileCompiling() {
  process.env.RUSTC_WORKSPACE_WRAPPER = join(root, 'tools', 'lint.sh');
  // As `cargo clippy` hands arguments over.
  process.env.CLIPPY_ARGS = '-Dwarnings__CLIPPY_HACKERY__';
}

export function checkFormat() {
  cargo('Checking the format of Rust', ['fmt', '--all', '--check'], 'Run: cargo fmt --all');
}

/** Types, lints, format and cycles of TypeScript, and cycles of Rust. */
export async function lintPage(modules) {
  const prettier = [join(root, 'node_modules', 'prettier', 'bin', 'prettier.cjs'), '--check', '--cache', '.'];
  const remedy = 'Run: npx prettier --write .';
  const isFormatted = runBeside('Checking the format of the rest', process.execPath, prettier, remedy);
  cargo('Looking for cycles of Rust modules', ['xtask', 'cycles'], cut);
  modules();
  npmProgram('Checking types', 'typescript/bin/tsc', ['--build'], named);
  npmProgram(
    'Linting TypeScript',
    'oxlint/bin/oxlint',
    ['--deny-warnings', 'web', 'tests', 'tools', 'crate/npm'],
    named,
  );
  run("Looking for cycles of the page's files and folders", process.execPath, [join(root, 'tools', 'cycles.mjs')], cut);
  await isFormatted();
}

export function checkSpelling() {
  run('Checking the spelling', requireTypos(), [], 'Correct it; a word of the field goes into _typos.toml.');
}
