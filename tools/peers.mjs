// Programs to compare with: those of Python, in an environment of their own, and anything that prints JSON.

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fail, root, run } from './steps.mjs';

export const POTPOURRI3D = 'potpourri3d==1.4.0';
export const PYGEODESIC = 'pygeodesic==0.1.11';

/** A Python that has these packages. */
export function pythonWith(...packages) {
  const environment = join(root, 'target', 'bench', 'python');
  const program = join(environment, 'bin', 'python');
  if (!existsSync(program)) {
    run(
      'Making a Python environment for the peers',
      'python3',
      ['-m', 'venv', environment],
      'Install Python 3 with venv.',
    );
  }
  run(
    `Installing ${packages.join(', ')}`,
    program,
    ['-m', 'pip', 'install', '--quiet', ...packages],
    'Is the Python package index reachable?',
  );
  return program;
}

/** What a program prints, single-threaded; null where it fails and `mayFail`. */
export function json(command, args, { mayFail = false } = {}) {
  const { status, stdout, stderr } = spawnSync(command, args, {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    env: { ...process.env, OMP_NUM_THREADS: '1' },
  });
  if (status === 0) return JSON.parse(stdout);
  if (!mayFail) fail(`${command} failed: ${stderr}`);
  return null;
}
