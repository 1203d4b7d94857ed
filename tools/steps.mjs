// What every command is made of: named steps that say what they do and how long it took, and fail with one plain sentence.

import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, openSync, readFileSync, rmSync } from 'node:fs';
import { constants, setPriority, tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('..', import.meta.url));

/** The steps so far and the seconds that each took. */
const taken = [];

/** Where nothing is compiled a second time, nothing is kept for it, and nobody steps through it: that would take a tenth of the time. */
const once = process.env.CI === 'true' ? { CARGO_INCREMENTAL: '0', CARGO_PROFILE_DEV_DEBUG: '0' } : {};

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
export function attempt(saying, command, args, env = {}) {
  console.log(`\n— ${saying}`);
  const begun = performance.now();
  const { status, error } = spawnSync(command, args, {
    cwd: root,
    stdio: 'inherit',
    env: { ...process.env, ...once, ...env },
  });
  const seconds = (performance.now() - begun) / 1000;
  taken.push([saying, seconds]);
  console.log(`  (${clock(seconds)})`);
  return !error && status === 0;
}

/**
 * Runs something beside the steps that follow, in the time that these leave. What it prints comes when it is waited for, by the
 * function that is given back; if it has failed, `remedy` is said then.
 */
export function runBeside(saying, command, args, remedy, env = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'heatwalk-'));
  const file = join(folder, 'printed');
  const printed = openSync(file, 'w');
  const child = spawn(command, args, {
    cwd: root,
    stdio: ['ignore', printed, printed],
    env: { ...process.env, ...once, ...env },
  });
  if (child.pid !== undefined) setPriority(child.pid, constants.priority.PRIORITY_LOW);
  const ended = new Promise((resolve) => {
    child.on('error', () => resolve(1)).on('exit', resolve);
  });
  return async () => {
    console.log(`\n— ${saying}`);
    const status = await ended;
    process.stdout.write(readFileSync(file));
    rmSync(folder, { recursive: true });
    if (status !== 0) fail(`${saying}: failed. ${remedy}`);
  };
}

/** A program installed by npm. */
export function npmProgram(saying, name, args, remedy, env) {
  run(saying, process.execPath, [join(root, 'node_modules', ...name.split('/')), ...args], remedy, env);
}

export function cargo(saying, args, remedy, env) {
  run(saying, 'cargo', args, remedy, env);
}

/** What a program prints; undefined where it fails. */
export function output(command, args, env = {}) {
  const { status, stdout } = spawnSync(command, args, { cwd: root, encoding: 'utf8', env: { ...process.env, ...env } });
  return status === 0 ? stdout.trim() : undefined;
}

/** Prints how long each step took, and all of them. */
export function printTimes() {
  const total = taken.reduce((sum, [, seconds]) => sum + seconds, 0);
  const lines = [...taken, ['All', total]].map(([saying, seconds]) => `${clock(seconds).padStart(8)}  ${saying}`);
  console.log(`\n${lines.join('\n')}`);
}

function clock(seconds) {
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')} min`;
}
