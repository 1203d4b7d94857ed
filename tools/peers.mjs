// Programs to compare with: those of Python, in an environment of their own, and anything that prints JSON.

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fail, root, run } from './steps.mjs';

export const POTPOURRI3D = 'potpourri3d==1.4.0';
export const PYGEODESIC = 'pygeodesic==0.1.11';
export const LIBIGL = 'libigl==2.6.3';
export const SCIPY = 'scipy==1.17.1';
export const SCIKIT_SPARSE = 'scikit-sparse==0.4.16';

export const NUMPY = 'numpy==2.4.6';
export const TRIMESH = 'trimesh==5.2.0';
export const EZDXF = 'ezdxf==1.4.5';

const SINGLE_THREADED = Object.fromEntries(
  ['OMP', 'OPENBLAS', 'MKL', 'BLIS', 'RAYON'].map((library) => [`${library}_NUM_THREADS`, '1']),
);

/** A Python that has these packages. */
export function pythonWith(...packages) {
  const environment = join(root, 'target', 'bench', 'python');
  const program = join(environment, 'bin', 'python');
  if (!existsSync(program)) {
    run('Making a Python environment', 'python3', ['-m', 'venv', environment], 'Install Python 3 with venv.');
  }
  run(
    `Installing ${packages.join(', ')}`,
    program,
    ['-m', 'pip', 'install', '--quiet', ...packages],
    'Is the Python package index reachable?',
  );
  return program;
}

/** A Python with readers of the files that the page saves; empty where the tests with them are skipped. */
export function findReaders() {
  const remedy = 'Install Python 3 with venv.';
  if (spawnSync('python3', ['-c', 'import ensurepip, venv'], { stdio: 'ignore' }).status === 0) {
    return pythonWith(NUMPY, TRIMESH, EZDXF);
  }
  console.log(`\nThe tests with trimesh and ezdxf are skipped: there is no Python with venv. ${remedy}`);
  return '';
}

/** The Python to test the package of this project with. */
export function requirePython(...packages) {
  const check = 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 11))';
  if (spawnSync('python3', ['-c', check], { stdio: 'ignore' }).status === 0) return pythonWith(...packages);
  return fail('Python 3.11 or newer with venv is needed, for the tests of the Python package. Install it.');
}

/** Whether a package that builds on libraries of the system could be installed. */
export function installs(python, name) {
  return spawnSync(python, ['-m', 'pip', 'install', '--quiet', name], { stdio: 'ignore' }).status === 0;
}

/** What a program prints, single-threaded; where it fails, `{ failed: reason }`. */
export function attempt(command, args) {
  const { status, signal, error, stdout, stderr } = spawnSync(command, args, {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    env: { ...process.env, ...SINGLE_THREADED },
  });
  if (status === 0) return JSON.parse(stdout);
  const reason = signal ? `ended by ${signal}` : (stderr?.trim().split('\n').at(-1) ?? error?.message);
  return { failed: reason || `exit status ${status}` };
}

/** What a program prints, single-threaded; null where it fails and `mayFail`. */
export function json(command, args, { mayFail = false } = {}) {
  const answer = attempt(command, args);
  if (!answer.failed) return answer;
  if (!mayFail) fail(`${command} failed: ${answer.failed}`);
  return null;
}
