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
  if (!attempt(saying, command, args, env)) fail(`${saying}: failed. ${remedy}`);
}

/** Says what is done, then runs it; whether that succeeded. */
function attempt(saying, command, args, env) {
  console.log(`\n— ${saying}`);
  const { status, error } = spawnSync(command, args, {
    cwd: root,
    stdio: 'inherit',
    env: { ...process.env, ...env },
  });
  return !error && status === 0;
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

/** Installs packages where there is apt-get. Where that `mayFail`, whoever needs them does without. */
function installDebian(saying, packages, remedy, { mayFail = false } = {}) {
  if (!output('which', ['apt-get'])) return;
  const [command, ...prefix] = process.getuid?.() === 0 ? ['apt-get'] : ['sudo', '--non-interactive', 'apt-get'];
  const step = (what, args, env = {}) => {
    if (!attempt(what, command, [...prefix, ...args], env) && !mayFail) fail(`${what}: failed. ${remedy}`);
  };
  step('Updating the package lists', ['update', '--quiet']);
  const install = ['install', '--yes', '--quiet', '--no-install-recommends', ...packages];
  step(saying, install, { DEBIAN_FRONTEND: 'noninteractive' });
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

function firefox() {
  const names = ['firefox-esr', 'firefox'];
  return process.env.FIREFOX || names.map((name) => output('which', [name])).find(Boolean);
}

/**
 * The path of a Firefox for the tests in it, with a virtual screen to draw on, installed by apt-get where there is none; empty
 * where they are skipped.
 */
export function findFirefox() {
  const isThere = () => firefox() && output('which', ['Xvfb']);
  const remedy = 'Install Firefox and Xvfb (Debian: firefox-esr xvfb libegl1 libgl1-mesa-dri).';
  const packages = ['firefox-esr', 'xvfb', 'libegl1', 'libgl1-mesa-dri'];
  if (!isThere()) installDebian('Installing Firefox for the browser tests', packages, remedy, { mayFail: true });
  if (isThere()) return firefox();
  console.log(`\nThe tests in Firefox are skipped: there is none, or no virtual screen. ${remedy}`);
  return '';
}

function hasWebKit() {
  return existsSync('/usr/bin/WebKitWebDriver') && output('which', ['Xvfb']) !== undefined;
}

/** Installs a WebKit for the tests in it by apt-get where there is none; without one they are skipped. */
export function findWebKit() {
  const remedy = 'Install the Debian packages webkit2gtk-driver and xvfb.';
  const packages = ['webkit2gtk-driver', 'xvfb', 'libegl1', 'libgl1-mesa-dri'];
  if (!hasWebKit()) installDebian('Installing WebKit for the browser tests', packages, remedy, { mayFail: true });
  if (!hasWebKit()) console.log(`\nThe tests in WebKit are skipped: there is none, or no virtual screen. ${remedy}`);
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
