// The crates that crates.io would get: those that may be published, each with what it builds on.

import { copyFileSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { cargo, output, root, run } from './steps.mjs';

const target = process.env.CARGO_TARGET_DIR ?? join(root, 'target');

/** Packs the crates; gives the files. */
export function packCrates() {
  const { packages } = JSON.parse(output('cargo', ['metadata', '--no-deps', '--format-version', '1']));
  const crates = packages.filter(({ publish }) => publish === null);
  const chosen = crates.flatMap(({ name }) => ['--package', name]);
  const remedy =
    'What is published builds on published crates only, each with its version. The message above names the crate.';
  // Compiling them one by one, as cargo would, takes as long as all of them take for each.
  cargo('Packing the crates', ['package', ...chosen, '--no-verify', '--allow-dirty', '--quiet'], remedy);
  return crates.map(({ name, version }) => join(target, 'package', `${name}-${version}.crate`));
}

/** Compiles the crates from what was packed of them alone, and runs the example of the solver's. */
export function tryCrates(files) {
  const folder = join(target, 'crates');
  const named = 'The message above names the crate.';
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const names = files.map((file) => basename(file, '.crate'));
  for (const file of files)
    run(`Unpacking ${basename(file)}`, 'tar', ['--extract', '--file', file, '--directory', folder], named);
  // As if they had been published: by their versions, from their folders; with a program of somebody who uses them.
  const example = join(folder, 'example');
  mkdirSync(join(example, 'src'), { recursive: true });
  copyFileSync(join(root, 'crate', 'solver', 'examples', 'distance.rs'), join(example, 'src', 'main.rs'));
  const manifest = ['[package]', 'name = "example"', 'edition = "2024"', '[dependencies]', 'heatwalk = "*"'];
  write(join(example, 'Cargo.toml'), manifest);
  const patched = names.map((name) => `${name.replace(/-[^-]*$/, '')} = { path = "${name}" }`);
  const members = JSON.stringify([...names, 'example']);
  write(join(folder, 'Cargo.toml'), [
    '[workspace]',
    'resolver = "3"',
    `members = ${members}`,
    '[patch.crates-io]',
    ...patched,
  ]);
  copyFileSync(join(root, 'Cargo.lock'), join(folder, 'Cargo.lock'));
  const alone = ['--manifest-path', join(folder, 'Cargo.toml'), '--target-dir', join(target, 'crates-built')];
  cargo('Compiling the packed crates', ['build', '--workspace', ...alone], named);
  cargo('Running an example with them', ['run', '--package', 'example', ...alone], named);
}

function write(file, lines) {
  writeFileSync(file, `${lines.join('\n')}\n`);
}
