// npm run release: all that is published, built from a clean checkout and tried as it would be, in release/ with checksums. It
// publishes nothing.

import { createHash } from 'node:crypto';
import {
  copyFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { buildSite, bundleSingle, publishModules, publishPackageModules, TESTED_FILE, TESTED_PAGE } from './bundle.mjs';
import { packCrates, tryCrates } from './crates.mjs';
import { findFirefox, findShell, prepare, requireChromium } from './needs.mjs';
import { packPackage } from './npm.mjs';
import { buildPackages } from './python.mjs';
import { cargo, fail, npmProgram, output, printTimes, root, run } from './steps.mjs';

const named = 'The message above names the cause.';
const folder = join(root, 'release');
const target = process.env.CARGO_TARGET_DIR ?? join(root, 'target');
const SUMS = join(folder, 'SHA256SUMS');
const COMMIT = join(folder, 'COMMIT');

const changed = output('git', ['status', '--porcelain']);
if (changed !== '')
  fail('What is released is what is committed. Commit or set aside what `git status` lists, and start again.');

// Files that are packed have the time of the commit, and panics name no folder of this machine.
process.env.SOURCE_DATE_EPOCH = output('git', ['log', '-1', '--format=%ct']);
const cargoHome = process.env.CARGO_HOME ?? join(process.env.HOME ?? '', '.cargo');
const remapped = [`--remap-path-prefix=${root}=`, `--remap-path-prefix=${cargoHome}=`];

prepare();
const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
const commit = output('git', ['rev-parse', 'HEAD']);
/** Of the same commit. */
const before = readIfThere(COMMIT).trim() === commit ? readIfThere(SUMS) : '';
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });

const crates = packCrates();
tryCrates(crates);
const program = buildProgram();
const python = buildPackages();
publishModules();
publishPackageModules();
buildSite();
bundleSingle();
const packed = await packPackage(true);
testPage();

[...crates, ...python, packed].forEach((file) => copyFileSync(file, join(folder, basename(file))));
copyFileSync(join(root, 'dist-single', 'heatwalk.html'), join(folder, `heatwalk-${version}.html`));
pack(`heatwalk-${version}-site`, join(root, 'dist'), readdirSync(join(root, 'dist')));
const platform = output('rustc', ['-vV']).match(/host: (.*)/)[1];
pack(
  `heatwalk-${version}-${platform}`,
  root,
  [basename(program), 'LICENSE-APACHE', 'LICENSE-MIT', 'CHANGELOG.md'],
  program,
);
writeSums();
printTimes();

/** The program, tried on a triangle whose distances are known. */
function buildProgram() {
  const flags = [process.env.CARGO_ENCODED_RUSTFLAGS, ...remapped].filter(Boolean).join('\u001f');
  const built = ['build', '--release', '--package', 'heatwalk-cli', '--target-dir', join(target, 'program')];
  cargo('Building the program', built, named, { CARGO_ENCODED_RUSTFLAGS: flags });
  const file = join(target, 'program', 'release', process.platform === 'win32' ? 'heatwalk.exe' : 'heatwalk');
  const mesh = join(tmpdir(), `heatwalk-${process.pid}.off`);
  writeFileSync(mesh, 'OFF\n3 1 0\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n');
  const answer = output(file, ['distance', mesh, '--source', '1', '--output', '-']);
  rmSync(mesh);
  if (Number(answer?.split(',').at(-1)) !== 5) {
    fail(`The program answers a triangle of sides 3, 4 and 5 by "${answer}".`);
  }
  return file;
}

/** The site, the page in one file and the npm package in browsers. */
function testPage() {
  for (const [made, tested] of [
    ['dist', TESTED_PAGE],
    ['dist-single', TESTED_FILE],
  ]) {
    rmSync(tested, { recursive: true, force: true });
    cpSync(join(root, made), tested, { recursive: true });
  }
  const variables = {
    CHROMIUM: requireChromium(),
    CHROMIUM_SHELL: findShell(),
    FIREFOX: findFirefox(),
    HEATWALK_PACKAGE: packed,
  };
  const chosen = ['test', 'browser/firstvisit', 'browser/offline', 'browser/single', 'tests/npm'];
  npmProgram('Trying site, page and npm package in Chromium', '@playwright/test/cli.js', chosen, named, variables);
}

/** An archive whose bytes depend on those of its files alone. */
function pack(name, from, files, beside) {
  const staged = join(target, 'release', name);
  rmSync(staged, { recursive: true, force: true });
  mkdirSync(staged, { recursive: true });
  for (const file of files)
    cpSync(beside?.endsWith(file) ? beside : join(from, file), join(staged, file), { recursive: true });
  const tarball = join(folder, `${name}.tar`);
  const order = [
    '--sort=name',
    '--owner=0',
    '--group=0',
    '--numeric-owner',
    '--mode=go=rX,u+rw',
    `--mtime=@${process.env.SOURCE_DATE_EPOCH}`,
  ];
  run(
    `Packing ${name}`,
    'tar',
    [...order, '--create', '--file', tarball, '--directory', join(target, 'release'), name],
    named,
  );
  run('Making it smaller', 'gzip', ['--no-name', '--best', '--force', tarball], named);
}

function readIfThere(file) {
  return existsSync(file) ? readFileSync(file, 'utf8') : '';
}

/** Checksums of all files, and of what was released of this commit before, what differs. */
function writeSums() {
  const sum = (file) =>
    createHash('sha256')
      .update(readFileSync(join(folder, file)))
      .digest('hex');
  const files = readdirSync(folder).toSorted();
  const lines = files.map((file) => `${sum(file)}  ${file}`);
  writeFileSync(SUMS, `${lines.join('\n')}\n`);
  writeFileSync(COMMIT, `${commit}\n`);
  console.log(`\nrelease/, of ${commit}:`);
  for (const [index, file] of files.entries()) {
    const same = !before ? '' : before.includes(lines[index]) ? 'the same as before' : 'not the same as before';
    console.log(`${statSync(join(folder, file)).size.toLocaleString('en').padStart(12)}  ${file}  ${same}`.trimEnd());
  }
}
