// The public figures of a commit, in groups that are measured together: docs/benchmarks.md and docs/accuracy.md.

import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { fail } from '../steps.mjs';
import { BY_HEAT } from './programs.mjs';

/** Sources of a median solve. */
const SOURCES = 10;
const DRAGGED = ['bunny', 'dragon'];
/** The share of precompute that counts as nothing. */
const FREE = 0.01;
const PICKING = ['--', '--warm-up-time', '1', '--measurement-time', '3', '--sample-size', '10'];

/** Times, in milliseconds, and memory: each group a function from a side to numbers by name. */
export function timed(meshes, files) {
  return [
    ...meshes.flatMap(({ name, file, who, queries, isLarge }) => [
      { name: `${name}, native`, measure: ({ programs }) => native(programs, file) },
      ...(isLarge ? [] : [{ name: `${name}, exact`, measure: ({ programs }) => exact(programs, file) }]),
      { name: `${name}, propagation`, measure: ({ programs }) => propagation(programs, file) },
      ...(queries ? [{ name: `${name}, queries`, measure: ({ programs }) => asked(programs, file) }] : []),
      ...(who.includes('page') ? [{ name: `${name}, page`, onPage: true, measure: (side) => worker(side, file) }] : []),
    ]),
    ...files.map((file) => ({ name: `${basename(file)}, paths`, measure: ({ programs }) => paths(programs, file) })),
    ...DRAGGED.map((preset) => ({ name: `${preset}, drag`, onPage: true, measure: ({ page }) => drag(page, preset) })),
    { name: 'picking', measure: picking },
  ];
}

/** What is the same at every run: errors in per cent, and bytes. */
export function fixed(meshes) {
  return [
    ...meshes
      .filter(({ isSlow }) => !isSlow)
      .map((mesh) => ({
        name: `${mesh.name}, error`,
        isError: true,
        measure: ({ programs }) => errors(programs, mesh),
      })),
    { name: 'closed forms, error', isError: true, measure: closedForms },
    { name: 'bytes', onPage: true, measure: bytes },
  ];
}

function native(programs, file) {
  const { sources: _sources, ...times } = programs.native(file, SOURCES);
  return times;
}

function exact(programs, file) {
  return { solve: programs.distance(file, 0, '--exact').timings_ms.solve };
}

/** Nothing where a commit has no propagation. */
function propagation(programs, file) {
  if (!programs.hasMethods) return {};
  const { solve } = programs.another(file, 'propagation', SOURCES);
  return { first: programs.first(file, 'propagation'), solve };
}

/** Changes that cost nothing are left out: there is nothing to compare. */
function asked(programs, file) {
  const { precompute, solve, source_added_to_20: added, line_of_100: line, ...changes } = programs.queries(file);
  const times = { precompute, solve, 'source added to 20': added, 'line of 100': line };
  for (const [name, change] of Object.entries(changes)) {
    for (const [when, time] of Object.entries(change ?? {})) {
      if (time > FREE * precompute) times[`another ${name}, ${when}`] = time;
    }
  }
  return times;
}

async function worker({ page, programs }, file) {
  const { sources } = programs.native(file, SOURCES);
  const answer = await page.worker(file, sources);
  if (answer.failed) fail(`The worker failed on ${file}: ${answer.failed}`);
  return answer;
}

/** The milliseconds of descent and straightening. */
function paths(programs, file) {
  const [row] = cells(programs.example('paths'), [file]);
  return { 'a path': Number(row.at(-1)) };
}

async function drag(page, preset) {
  const { fields, usual, longest } = await page.drag(preset);
  return { 'a field': 1000 / fields, 'usual answer': usual, 'longest answer': longest };
}

function picking({ tree }) {
  const manifest = ['--manifest-path', join(tree, 'Cargo.toml')];
  const env = { ...process.env, CARGO_TARGET_DIR: join(tree, 'target') };
  const args = ['bench', ...manifest, '--bench', 'picking', ...PICKING];
  const { status, stdout, stderr } = spawnSync('cargo', args, { env, encoding: 'utf8' });
  if (status !== 0) fail(`Picking could not be measured: ${stderr}`);
  const units = { ns: 1e-6, µs: 1e-3, ms: 1, s: 1e3 };
  const results = stdout.matchAll(/^(.*?)\s+time:\s+\[\S+ \S+ (\S+) (\S+) \S+ \S+\]/gm);
  return Object.fromEntries([...results].map(([, name, time, unit]) => [name.trim(), Number(time) * units[unit]]));
}

function errors(programs, { file, vertices }) {
  const figures = {};
  const methods = { heat: BY_HEAT, ...(programs.hasMethods ? { propagation: ['--method', 'propagation'] } : {}) };
  for (const source of [0, Math.floor(vertices / 2)]) {
    for (const [method, options] of Object.entries(methods)) {
      const { mean, max } = programs.error(file, source, ...options);
      figures[`${method}, mean from ${source}`] = mean;
      figures[`${method}, maximum from ${source}`] = max;
    }
  }
  return figures;
}

function closedForms({ programs }) {
  const figures = {};
  for (const [name, source, , mean, maximum] of cells(programs.example('closed_forms'), [])) {
    figures[`${name}, mean from ${source}`] = Number(mean);
    figures[`${name}, maximum from ${source}`] = Number(maximum);
  }
  return figures;
}

/** What the page loads until its first picture, by brotli, and the modules as they are. */
async function bytes({ tree, page }) {
  const { bytes: first } = await page.firstPicture();
  const folder = join(tree, 'dist', 'assets');
  const files = readdirSync(folder).map((name) => ({ name, content: readFileSync(join(folder, name)) }));
  const figures = { 'first picture, brotli': first };
  for (const [kind, pattern] of [
    ['solver.wasm', /worker.*\.wasm$/],
    ['viewer.wasm, WebGPU', /viewer(_webgpu)?_bg.*\.wasm$/],
    ['viewer.wasm, WebGL2', /viewer(_webgl2)?_bg.*\.wasm$/],
    ['all JavaScript', /\.js$/],
    ['all CSS', /\.css$/],
  ]) {
    const chosen = files.filter(({ name }) => pattern.test(name));
    figures[kind] = chosen.reduce((sum, { content }) => sum + content.length, 0);
    figures[`${kind}, brotli`] = chosen.reduce((sum, { content }) => sum + brotliCompressSync(content).length, 0);
  }
  return figures;
}

/** The cells of the Markdown table that a program prints, without its header. */
export function cells(program, args) {
  const { status, stdout, stderr } = spawnSync(program, args, { encoding: 'utf8' });
  if (status !== 0) fail(`${program} failed: ${stderr}`);
  const lines = stdout.trim().split('\n').slice(2);
  return lines.map((line) =>
    line
      .replace(/^\||\|$/g, '')
      .split('|')
      .map((cell) => cell.trim()),
  );
}
