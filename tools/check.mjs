// npm run check: format, lint, types, documentation, cycles and spelling, of Rust (native and wasm32) and of TypeScript.
// Warnings are errors.

import { join } from 'node:path';
import { cargo, npmProgram, prepare, requireTypos, root, run } from './steps.mjs';

const named = 'The message above names the place.';
const cut = 'One of the arrows above has to go: what both sides need belongs below both.';

prepare();
cargo('Checking the format of Rust', ['fmt', '--all', '--check'], 'Run: cargo fmt --all');
cargo('Linting Rust', ['clippy', '--workspace', '--all-targets', '--', '-Dwarnings'], named);
cargo('Linting Rust for wasm32', ['xtask', 'clippy-wasm'], named);
// These are empty but on wasm32.
const documented = [
  'doc',
  '--workspace',
  '--no-deps',
  ...['heatwalk-worker', 'heatwalk-reader', 'heatwalk-maker', 'heatwalk-interior', 'heatwalk-webgl'].flatMap((name) => [
    '--exclude',
    name,
  ]),
];
cargo('Building the documentation of Rust', documented, named, { RUSTDOCFLAGS: '-Dwarnings' });
cargo('Looking for cycles of Rust modules', ['xtask', 'cycles'], cut);
// The types of the bindings come with the modules.
cargo('Building the wasm modules', ['xtask', 'wasm'], named);
npmProgram('Checking types', 'typescript/bin/tsc', ['--build'], named);
npmProgram('Linting TypeScript', 'oxlint/bin/oxlint', ['--deny-warnings', 'web', 'tests', 'tools'], named);
run("Looking for cycles of the page's files and folders", process.execPath, [join(root, 'tools', 'cycles.mjs')], cut);
run('Checking the spelling', requireTypos(), [], 'Correct it; a word of the field goes into _typos.toml.');
npmProgram(
  'Checking the format of the rest',
  'prettier/bin/prettier.cjs',
  ['--check', '.'],
  'Run: npx prettier --write .',
);
