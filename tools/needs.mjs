// What has to be on the machine: where it is missing, it is installed by the ordinary package managers, which is said before.

import { existsSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { attempt, cargo, fail, output, root, run } from './steps.mjs';

const OLDEST_NODE = 20;
const OLDEST_RUST = [1, 95];
const TYPOS = '1.52.0';
const DENY = '0.20.2';
const FUZZ = '0.13.2';
const WASM = 'wasm32-unknown-unknown';
const DEBIAN_LINKER = '/usr/bin/rust-lld';

/** All that is ever installed from Debian: for what, and how it is found, whoever has installed it. */
const DEBIAN = {
  wasm: {
    packages: ['rustc-web', 'rust-web-src', 'rust-web-clippy', 'rust-web-llvm'],
    why: 'the solver is compiled to wasm',
    find: () => hasWasm() || hasWasmSource(),
  },
  chromium: {
    packages: ['chromium'],
    why: 'the page is tested in it',
    find: () => browser('CHROMIUM', ['chromium', 'chromium-browser', 'google-chrome']),
  },
  shell: {
    packages: ['chromium-headless-shell'],
    why: 'most tests of the page take less time in a Chromium without windows',
    find: () => browser('CHROMIUM_SHELL', ['chromium-headless-shell', 'chrome-headless-shell']),
  },
  firefox: {
    packages: ['firefox-esr', 'xvfb', 'libegl1', 'libgl1-mesa-dri'],
    why: 'the page is tested in it',
    find: () => hasScreen() && browser('FIREFOX', ['firefox-esr', 'firefox']),
  },
  webkit: {
    packages: ['webkit2gtk-driver', 'xvfb', 'libegl1', 'libgl1-mesa-dri'],
    why: 'the page is tested in WebKit',
    find: () => hasScreen() && existsSync('/usr/bin/WebKitWebDriver'),
  },
  mesa: {
    packages: ['libegl1', 'libgl1-mesa-dri'],
    why: 'the page is drawn by the processor in its tests, in half the time',
    find: hasMesa,
  },
  compiler: {
    packages: ['g++'],
    why: 'libFuzzer is compiled',
    find: () => ['c++', 'g++', 'clang++'].map((name) => output('which', [name])).find(Boolean),
  },
  vulkan: {
    packages: ['mesa-vulkan-drivers'],
    why: 'images are drawn in software for the tests of them',
    find: () => hasSoftwareVulkanDriver('/usr/share/vulkan/icd.d'),
  },
};

/** Where CI is set, whatever is tested has to be there. */
const isRequired = process.env.CI === 'true';

/** What is needed before anything can be built. */
export function prepare() {
  requireNode();
  requireRust();
  requirePackages();
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

/** Rust's standard library for wasm32, from rustup, else its source and a compiler of it from Debian. */
export function requireWasm() {
  if (DEBIAN.wasm.find()) return;
  if (output('which', ['rustup'])) attempt(`Adding ${WASM} to Rust`, 'rustup', ['target', 'add', WASM]);
  if (findOrInstall('wasm')) return;
  // The linker is a link there, whose package is called as the link's target.
  const linker = output('readlink', [DEBIAN_LINKER])?.split('/').at(-1);
  if (linker) install([linker], DEBIAN.wasm.why);
  if (DEBIAN.wasm.find()) return;
  fail(`There is no Rust standard library for ${WASM}. Run: rustup target add ${WASM}. ${remedy('wasm')}`);
}

/** The path of the spell-checker: pip brings the program itself, cargo compiles it. */
export function requireTypos() {
  const pip = (folder) => ['-m', 'pip', 'install', '--quiet', '--upgrade', '--target', folder, `typos==${TYPOS}`];
  return requireTool('typos', 'typos-cli', TYPOS, (folder) => {
    console.log('\n— Installing the spell-checker typos');
    output('python3', pip(folder));
  });
}

/** The path of the program that knows licenses and advisories of crates. */
export function requireDeny() {
  return requireTool('cargo-deny', 'cargo-deny', DENY);
}

/** The path of the program that builds and runs fuzz targets. */
export function requireFuzz() {
  return requireTool('cargo-fuzz', 'cargo-fuzz', FUZZ);
}

/** Looks for a compiler of C++, which libFuzzer needs. */
export function requireCompiler() {
  if (!findOrInstall('compiler')) fail(`There is no compiler of C++. ${remedy('compiler')}`);
}

/** The path of a program of this version in `target`; cargo compiles it where there is none, and none is brought. */
function requireTool(name, crate, version, bring = () => {}) {
  const folder = join(root, 'target', name);
  const program = join(folder, 'bin', name);
  const found = () => output(program, ['--version'])?.endsWith(version);
  if (found()) return program;
  bring(folder);
  if (found()) return program;
  const compile = ['install', crate, '--version', version, '--locked', '--root', folder, '--force'];
  cargo(`Compiling ${name} (minutes, once)`, compile, 'Is the crate registry reachable?');
  return program;
}

/** The path of a Chromium for the tests of the page. */
export function requireChromium() {
  const found = findOrInstall('chromium');
  return (
    found || fail(`No Chromium was found. ${remedy('chromium')} Or name one in the environment variable CHROMIUM.`)
  );
}

/** The path of a Chromium without windows for most of them; empty where they take longer in the other one. */
export function findShell() {
  return findOrInstall('shell') ?? '';
}

/** The path of a Firefox for the tests in it, with a virtual screen to draw on; empty where they are skipped. */
export function findFirefox() {
  return findOrInstall('firefox') || without('The tests in Firefox', 'firefox');
}

/** Looks for a WebKit for the tests in it, with a virtual screen; without one they are skipped. */
export function findWebKit() {
  return findOrInstall('webkit') || without('The tests in WebKit', 'webkit');
}

/** Looks for Mesa's OpenGL, with which the page is drawn in its tests; without it they take longer. */
export function findMesa() {
  return findOrInstall('mesa') || without('The tests of the page as Mesa draws it', 'mesa');
}

/** Whether Mesa's OpenGL is there for browsers. */
export function hasMesa() {
  return existsSync('/usr/share/glvnd/egl_vendor.d/50_mesa.json');
}

/** Whether the native image tests have a software Vulkan driver. */
export function hasSoftwareVulkan() {
  return Boolean(findOrInstall('vulkan') || without('The native image tests', 'vulkan'));
}

function findOrInstall(need) {
  const { find, packages, why } = DEBIAN[need];
  const found = find();
  if (found) return found;
  install(packages, why);
  return find();
}

function hasWasm() {
  return existsSync(output('rustc', ['--print', 'target-libdir', '--target', WASM]) ?? '');
}

function hasWasmSource() {
  const version = output('/usr/bin/rustc', ['--version'])?.split(' ')[1];
  return existsSync(`/usr/src/rustc-${version}/library/std/Cargo.toml`) && existsSync(DEBIAN_LINKER);
}

function browser(variable, names) {
  return process.env[variable] || names.map((name) => output('which', [name])).find(Boolean);
}

function hasScreen() {
  return output('which', ['Xvfb']) !== undefined;
}

function hasSoftwareVulkanDriver(folder) {
  return existsSync(folder) && readdirSync(folder).some((name) => name.startsWith('lvp_icd'));
}

/** Says which tests are skipped for want of packages; where they are required, ends the program. */
function without(tests, need) {
  if (isRequired) fail(`${tests} are required where CI=true. ${remedy(need)}`);
  console.log(`\n${tests} are skipped. ${remedy(need)}`);
  return '';
}

function remedy(need) {
  return `Install Debian's packages: ${DEBIAN[need].packages.join(' ')}.`;
}

/** Installs packages where there is apt-get; where that fails, whoever needs them does without or says so. */
function install(packages, why) {
  if (!output('which', ['apt-get'])) return;
  const [command, ...prefix] = process.getuid?.() === 0 ? ['apt-get'] : ['sudo', '--non-interactive', 'apt-get'];
  const words = ['install', '--yes', '--quiet', '--no-install-recommends', ...packages];
  console.log(
    `\n${packages.join(', ')} will be installed, because ${why}: ${[command, ...prefix, ...words].join(' ')}`,
  );
  attempt('Updating the package lists', command, [...prefix, 'update', '--quiet']);
  attempt('Installing packages', command, [...prefix, ...words], { DEBIAN_FRONTEND: 'noninteractive' });
}
