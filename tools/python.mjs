// The tests of the Python package, and that it can be installed.

import { cpSync, mkdirSync, readdirSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { installs, NUMPY, requirePython, SCIPY } from './peers.mjs';
import { cargo, root, run, runBeside } from './steps.mjs';

const DASK = ['dask==2026.8.0', 'distributed==2026.8.0', 'zarr==3.1.6'];
const MATURIN = 'maturin==1.16.0';
const MYPY = 'mypy==2.4.1';
const NIBABEL = 'nibabel==5.4.2';
const PYTEST = 'pytest==9.2.0';
const RAY = 'ray==2.60.0';
const SCIPY_STUBS = 'scipy-stubs==1.17.1.5';

const named = 'The message above names the test.';
const source = join(root, 'crate', 'python');
const target = process.env.CARGO_TARGET_DIR ?? join(root, 'target');
/** What cargo calls the module, on each system. */
const MODULES = { darwin: 'lib_heatwalk.dylib', win32: '_heatwalk.dll' };

/**
 * Tests the package with a module that is built beside the other tests: with them, `packages`, it has the features of what both
 * are made of, so that nothing but itself is compiled again. What maturin would build of the package alone shares next to nothing.
 */
export async function testPackage(packages) {
  const python = requirePython(NUMPY, SCIPY, SCIPY_STUBS, PYTEST, MYPY, NIBABEL, ...DASK);
  cargo('Building the module of the Python package', ['build', ...packages, '--lib', '--tests'], named);
  const folder = join(target, 'python');
  rmSync(folder, { recursive: true, force: true });
  cpSync(join(source, 'python'), folder, { recursive: true, filter: (path) => !/\.(so|pyd|pyc)$/.test(path) });
  const module = process.platform === 'win32' ? '_heatwalk.pyd' : '_heatwalk.abi3.so';
  cpSync(join(target, 'debug', MODULES[process.platform] ?? 'lib_heatwalk.so'), join(folder, 'heatwalk', module));
  const paths = { PYTHONPATH: folder, MYPYPATH: folder, PYTHONDONTWRITEBYTECODE: '1' };
  const cache = ['--cache-dir', join(target, 'mypy')];
  // Not all functions of Dask have types.
  const untyped = ['dask', 'distributed'].flatMap((name) => ['--untyped-calls-exclude', name]);
  const types = ['-m', 'mypy', '--strict', ...untyped, ...cache, folder];
  // The tests take one core.
  const areTyped = runBeside('Checking the types of the Python package', python, types, named, paths);
  const areTrue = runBeside(
    'Comparing them with the module',
    python,
    ['-m', 'mypy.stubtest', 'heatwalk'],
    named,
    paths,
  );
  const tests = ['-m', 'pytest', '--quiet', '-p', 'no:cacheprovider', join(source, 'tests')];
  run("Running the Python package's tests", python, tests, named, paths);
  await areTyped();
  await areTrue();
}

/** Builds the package as pip does, from this checkout and from what would be published of its sources, and tries both; gives the files. */
export function buildPackages() {
  const tool = requirePython(MATURIN, NUMPY, SCIPY, SCIPY_STUBS, PYTEST, MYPY);
  const made = join(target, 'python-packages');
  rmSync(made, { recursive: true, force: true });
  mkdirSync(made, { recursive: true });
  const maturin = (saying, args) => run(saying, tool, ['-m', 'maturin', ...args, '--out', made], named);
  maturin('Building the wheel of the Python package', [
    'build',
    '--release',
    '--manifest-path',
    join(source, 'Cargo.toml'),
  ]);
  maturin('Packing its sources', ['sdist', '--manifest-path', join(source, 'Cargo.toml')]);
  const files = readdirSync(made).map((name) => join(made, name));
  for (const file of files) {
    const environment = join(made, file.endsWith('.whl') ? 'of-wheel' : 'of-sources');
    const python = join(environment, 'bin', 'python');
    run('Making a Python environment', tool, ['-m', 'venv', environment], named);
    run(
      `Installing ${basename(file)}`,
      python,
      ['-m', 'pip', 'install', '--quiet', file, SCIPY, PYTEST, NIBABEL, ...DASK],
      named,
    );
    if (!installs(python, RAY)) console.log(`\nThe example with Ray is skipped: ${RAY} cannot be installed here.`);
    run('Testing it', python, ['-m', 'pytest', '--quiet', '-p', 'no:cacheprovider', join(source, 'tests')], named);
  }
  return files;
}
