// What every command is made of: named steps that say what they do and fail with one plain sentence.

import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('..', import.meta.url));

const OLDEST_NODE = 20;
const OLDEST_RUST = [1, 95];
const TYPOS = '1.52.0';

/** Ends the program with a sentence for a person. */
export function fail(sentence) {
  console.error(`\n${sentence}`);
  process.exit(1);
}

/** Says what is done, then runs it; `remedy` is said if it fails. */
export function run(saying, command, args, remedy, env = {}) {
  console.log(`\n— ${saying}`);
  const { status, error } = spawnSync(command, args, {
    cwd: root,
    stdio: 'inherit',
    env: { ...process.env, ...env },
  });
  if (error || status !== 0) fail(`${saying}: failed. ${remedy}`);
}

/** A program installed by npm. */
export function npmProgram(saying, name, args, remedy, env) {
  run(saying, process.execPath, [join(root, 'node_modules', ...name.split('/')), ...args], remedy, env);
}

export function cargo(saying, args, remedy, env) {
  run(saying, 'cargo', args, remedy, env);
}

function output(command, args) {
  const { status, stdout } = spawnSync(command, args, { cwd: root, encoding: 'utf8' });
  return status === 0 ? stdout.trim() : undefined;
}

function requireNode() {
  if (Number(process.versions.node.split('.')[0]) < OLDEST_NODE) {
    fail(`Node ${OLDEST_NODE} or newer is needed; this is ${process.version}. Install it from https://nodejs.org.`);
  }
}

function requireRust() {
  const version = output('rustc', ['--version'])?.match(/(\d+)\.(\d+)/);
  if (!version || !output('cargo', ['--version'])) {
    fail('Rust is needed. Install it from https://rustup.rs, open a new shell and start again.');
  }
  const [major, minor] = [Number(version[1]), Number(version[2])];
  if (major < OLDEST_RUST[0] || (major === OLDEST_RUST[0] && minor < OLDEST_RUST[1])) {
    fail(`Rust ${OLDEST_RUST.join('.')} or newer is needed; this is ${version[0]}. Run: rustup update stable`);
  }
}

/** npm's packages, installed again only when the lock file has changed since. */
function requirePackages() {
  const installed = join(root, 'node_modules', '.package-lock.json');
  const lock = join(root, 'package-lock.json');
  if (existsSync(installed) && statSync(installed).mtimeMs >= statSync(lock).mtimeMs) return;
  run('Installing npm packages', 'npm', ['ci', '--no-audit', '--no-fund'], 'Is the npm registry reachable?');
}

/** What is needed before anything can be built. */
export function prepare() {
  requireNode();
  requireRust();
  requirePackages();
}

/** The wasm modules with their bindings, in web/wasm. */
export function buildModules() {
  cargo(
    'Building the wasm modules (minutes the first time, seconds after)',
    ['xtask', 'wasm'],
    'The message above names the cause.',
  );
}

/** The path of the spell-checker: pip brings the program itself, cargo compiles it. */
export function requireTypos() {
  const folder = join(root, 'target', 'typos');
  const program = join(folder, 'bin', 'typos');
  const found = () => output(program, ['--version'])?.endsWith(TYPOS);
  if (found()) return program;
  const pip = ['-m', 'pip', 'install', '--quiet', '--upgrade', '--target', folder, `typos==${TYPOS}`];
  console.log('\n— Installing the spell-checker typos');
  if (output('python3', pip) !== undefined && found()) return program;
  const compile = ['install', 'typos-cli', '--version', TYPOS, '--root', folder, '--force'];
  cargo('Compiling the spell-checker typos (minutes, once)', compile, 'Is the crate registry reachable?');
  return program;
}

/** Installs packages where there is apt-get. */
function installDebian(saying, packages, remedy) {
  if (!output('which', ['apt-get'])) return;
  const [command, ...prefix] = process.getuid?.() === 0 ? ['apt-get'] : ['sudo', '--non-interactive', 'apt-get'];
  run('Updating the package lists', command, [...prefix, 'update', '--quiet'], remedy);
  const install = ['install', '--yes', '--quiet', '--no-install-recommends', ...packages];
  run(saying, command, [...prefix, ...install], remedy, { DEBIAN_FRONTEND: 'noninteractive' });
}

function chromium() {
  const names = ['chromium', 'chromium-browser', 'google-chrome'];
  return process.env.CHROMIUM || names.map((name) => output('which', [name])).find(Boolean);
}

/** The path of a Chromium for the browser tests, installed by apt-get where there is none. */
export function requireChromium() {
  const remedy = 'Install Chromium and name it in the environment variable CHROMIUM.';
  if (!chromium()) installDebian('Installing Chromium for the browser tests', ['chromium'], remedy);
  return chromium() ?? fail(`No Chromium was found. ${remedy}`);
}

/** Whether the native image tests have a software Vulkan driver, installed by apt-get where there is none. */
export function hasSoftwareVulkan() {
  const drivers = '/usr/share/vulkan/icd.d';
  const found = () => existsSync(drivers) && readdirSync(drivers).some((name) => name.startsWith('lvp_icd'));
  const remedy = 'Install the Debian package mesa-vulkan-drivers.';
  if (!found())
    installDebian('Installing a software Vulkan driver for the image tests', ['mesa-vulkan-drivers'], remedy);
  if (!found()) console.log(`\nThe native image tests are skipped without a software Vulkan driver. ${remedy}`);
  return found();
}
