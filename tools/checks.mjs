// What looks at the code without running it. Warnings are errors.

import { join } from 'node:path';
import { requireTypos } from './needs.mjs';
import { cargo, npmProgram, root, run } from './steps.mjs';

const named = 'The message above names the place.';
const cut = 'One of the arrows above has to go: what both sides need belongs below both.';
/** These are empty but on wasm32. */
const UNDOCUMENTED = ['worker', 'reader', 'maker', 'interior', 'webgl'].flatMap((name) => [
  '--exclude',
  `heatwalk-${name}`,
]);

/** Format, lints, types and cycles of Rust and TypeScript; `modules` builds those of wasm, with which the types of bindings come. */
export function lint(modules) {
  cargo('Checking the format of Rust', ['fmt', '--all', '--check'], 'Run: cargo fmt --all');
  cargo('Linting Rust', ['clippy', '--workspace', '--all-targets', '--', '-Dwarnings'], named);
  cargo('Looking for cycles of Rust modules', ['xtask', 'cycles'], cut);
  modules();
  npmProgram('Checking types', 'typescript/bin/tsc', ['--build'], named);
  npmProgram('Linting TypeScript', 'oxlint/bin/oxlint', ['--deny-warnings', 'web', 'tests', 'tools'], named);
  run("Looking for cycles of the page's files and folders", process.execPath, [join(root, 'tools', 'cycles.mjs')], cut);
  const format = ['--check', '--cache', '.'];
  npmProgram('Checking the format of the rest', 'prettier/bin/prettier.cjs', format, 'Run: npx prettier --write .');
}

/** What is left to check: code for wasm32 alone, documentation, spelling. */
export function lintTheRest() {
  cargo('Linting Rust for wasm32', ['xtask', 'clippy-wasm'], named);
  const flags = { RUSTDOCFLAGS: '-Dwarnings' };
  cargo('Building the documentation of Rust', ['doc', '--workspace', '--no-deps', ...UNDOCUMENTED], named, flags);
  run('Checking the spelling', requireTypos(), [], 'Correct it; a word of the field goes into _typos.toml.');
}
