// npm run check: format, lint and types, of Rust (native and wasm32) and of TypeScript. Warnings are errors.

import { cargo, npmProgram, prepare } from './steps.mjs';

const named = 'The message above names the place.';

prepare();
cargo('Checking the format of Rust', ['fmt', '--all', '--check'], 'Run: cargo fmt --all');
cargo('Linting Rust', ['clippy', '--workspace', '--all-targets', '--', '-Dwarnings'], named);
cargo('Linting Rust for wasm32', ['xtask', 'clippy-wasm'], named);
// The types of the bindings come with the modules.
cargo('Building the wasm modules', ['xtask', 'wasm'], named);
npmProgram('Checking types', 'typescript/bin/tsc', ['--build'], named);
npmProgram('Linting TypeScript', 'oxlint/bin/oxlint', ['--deny-warnings', 'web', 'tests', 'tools'], named);
npmProgram(
  'Checking the format of the rest',
  'prettier/bin/prettier.cjs',
  ['--check', '.'],
  'Run: npx prettier --write .',
);
