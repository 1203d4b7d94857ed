// npm run fuzz [-- TARGET ...] [--seconds N]: builds the targets of crate/fuzz and runs each of them, or those that are named, for
// a minute or so many seconds, from the seeds and from what earlier runs have found (crate/fuzz/corpus). Fails on an input that
// makes a target panic, hang or take more memory than its budget, which it names.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { prepare, requireCompiler, requireFuzz } from './needs.mjs';
import { fail, root, run } from './steps.mjs';

/** Relative to the root, as people read it. */
const FOLDER = 'crate/fuzz';
/** Seconds for one input. The slowest ones take a tenth of one. */
const PATIENCE = 10;
/** For the whole process: the most that a budget is, and what libFuzzer and the corpus take. */
const MEBIBYTES = 2560;
/** Lines that say what went wrong. */
const SAID = 40;
/** No sanitizer: the code has no `unsafe`, and stable Rust has none. */
const PLAIN = ['--fuzz-dir', FOLDER, '--sanitizer', 'none'];

const { values, positionals } = parseArgs({
  options: { seconds: { type: 'string', default: '60' } },
  allowPositionals: true,
});
const seconds = Number(values.seconds);
if (!(Number.isInteger(seconds) && seconds > 0)) fail('--seconds takes a whole number from 1.');
const targets = readdirSync(join(root, FOLDER, 'fuzz_targets')).map((file) => file.replace('.rs', ''));
const unknown = positionals.find((name) => !targets.includes(name));
if (unknown) fail(`There is no target ${unknown}. The targets are: ${targets.toSorted().join(', ')}.`);
const chosen = (positionals.length > 0 ? positionals : targets).toSorted();

prepare();
requireCompiler();
const program = requireFuzz();
run('Compiling the fuzz targets', program, ['build', ...PLAIN], 'The message above names the place.');
console.log('');
const failed = chosen.filter((target) => !findsNothing(target));
if (failed.length > 0) fail(`${failed.join(', ')}: failed. Each message above names the file and how to run it again.`);

/** Runs a target and prints what it came to. */
function findsNothing(target) {
  const found = join(FOLDER, 'corpus', target);
  mkdirSync(join(root, found), { recursive: true });
  const seeds = [join(FOLDER, 'seeds', target)].filter((folder) => existsSync(join(root, folder)));
  const dictionary = join(FOLDER, 'dictionaries', `${target}.dict`);
  const options = [`-max_total_time=${seconds}`, `-timeout=${PATIENCE}`, `-rss_limit_mb=${MEBIBYTES}`];
  if (existsSync(join(root, dictionary))) options.push(`-dict=${dictionary}`);
  const words = ['run', ...PLAIN, target, found, ...seeds, '--', ...options, '-print_final_stats=1'];
  const { status, stderr } = spawnSync(program, words, {
    cwd: root,
    encoding: 'utf8',
    maxBuffer: 2 ** 30,
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  const number = (pattern) => Number([...stderr.matchAll(pattern)].at(-1)?.[1] ?? 0).toLocaleString('en');
  const executions = number(/number_of_executed_units: (\d+)/g);
  const rate = number(/average_exec_per_sec: +(\d+)/g);
  const edges = number(/cov: (\d+)/g);
  const all = number(/\((\d+) inline 8-bit counters\)/g);
  console.log(`${target.padEnd(18)} ${executions} executions, ${rate} a second; ${edges} of ${all} edges`);
  if (status === 0) return true;
  console.error(stderr.split('\n').slice(-SAID).join('\n'));
  return false;
}
