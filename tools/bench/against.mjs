// npm run bench -- --against COMMIT: every public figure of this checkout and of another commit, in alternation.

import { resolve } from 'node:path';
import { prepare } from '../needs.mjs';
import { fail, root } from '../steps.mjs';
import { Checkout, checkout } from './checkout.mjs';
import { meshes as chosenMeshes } from './meshes.mjs';
import { judge, LIMIT, median } from './ratios.mjs';
import { digits, save, table } from './report.mjs';
import { fixed, timed } from './rows.mjs';

/** Pairs that every row has, and those beyond which nothing is learned. */
const LEAST = 6;
const MOST = 400;
/** Errors that differ by a smaller share differ by the order of sums. */
const ROUNDING = 1e-3;
const LIMIT_PERCENT = Math.round(100 * (LIMIT - 1));

/**
 * `only`: a word in the names of the groups wanted; `files`: meshes to measure besides the usual ones; `budget`: seconds
 * after which a group that has its least pairs ends undecided.
 */
export async function against(commit, { only, files, budget, quick }) {
  prepare();
  const isWanted = ({ name }) => name.includes(only);
  const sides = { before: new Checkout(checkout(commit)), after: new Checkout(root) };
  console.log('\n— Writing the meshes');
  const program = sides.after.programs.example('bench_mesh');
  const meshes = await chosenMeshes({ files: [], subdivisions: 0, quick, only: '', program });
  const paths = files.map((file) => resolve(file));
  if (files.length > 0) {
    meshes.push(...(await chosenMeshes({ files: paths, subdivisions: 0, quick, only: '', program })));
  }
  const all = [timed(meshes, paths), fixed(meshes)];
  const [inTime, once] = all.map((groups) => groups.filter(isWanted));
  if (inTime.length + once.length === 0) {
    const names = all.flat().map(({ name }) => name);
    fail(`No group has "${only}" in its name. There are: ${names.join('; ')}.`);
  }
  if ([...inTime, ...once].some(({ onPage }) => onPage)) for (const side of Object.values(sides)) await side.openPage();

  const times = [];
  for (const group of inTime) times.push(...(await alternate(group, sides, budget)));
  const figures = [];
  for (const group of once) figures.push(...(await compare(group, sides)));
  for (const side of Object.values(sides)) await side.close();
  report({ before: sides.before.name, after: sides.after.name, times, figures });
}

/** Pairs of both sides, the first one by turns, until every row is decided. */
async function alternate({ name, measure }, sides, budget) {
  console.log(`\n— ${name}`);
  const pairs = [];
  const start = performance.now();
  const isOver = () => performance.now() - start > 1000 * budget;
  let rows = [];
  while (pairs.length < LEAST || (pairs.length < MOST && !isOver() && rows.some(({ isCertain }) => !isCertain))) {
    const pair = {};
    const order = pairs.length % 2 === 0 ? ['before', 'after'] : ['after', 'before'];
    for (const side of order) pair[side] = await measure(sides[side]);
    pairs.push(pair);
    rows = judged(name, pairs);
  }
  for (const row of rows) console.log(`${row.name}: ${digits(row.ratio)} (${row.verdict}, ${row.pairs} pairs)`);
  return rows;
}

/** The rows of which both sides have a number in each pair. */
function judged(group, pairs) {
  const named = Object.keys(pairs[0].after);
  const kept = named.filter((row) => pairs.every(({ before, after }) => before[row] > 0 && after[row] > 0));
  return kept.map((row) => {
    const [before, after] = ['before', 'after'].map((side) => pairs.map((pair) => pair[side][row]));
    const judgement = judge(pairs.map((pair) => pair.after[row] / pair.before[row]));
    return Object.assign(judgement, {
      name: `${group}: ${row}`,
      pairs: pairs.length,
      before: median(before),
      after: median(after),
    });
  });
}

async function compare({ name, measure, isError = false }, sides) {
  console.log(`\n— ${name}`);
  const { before, after } = { before: await measure(sides.before), after: await measure(sides.after) };
  return Object.keys({ ...before, ...after }).map((row) => ({
    name: `${name}: ${row}`,
    before: before[row],
    after: after[row],
    isWorse: !(after[row] <= before[row] * (isError ? 1 + ROUNDING : 1)),
  }));
}

function report(results) {
  const { before, after, times, figures } = results;
  const slower = times.filter(({ ratio }) => ratio > LIMIT);
  const worse = figures.filter(({ isWorse }) => isWorse);
  const text = [
    `${after} against ${before}. Times in ms, memory and sizes in bytes, errors in %. A ratio is the median of the ratios`,
    'after / before of pairs, measured one right after the other; in 95 of 100 cases the interval holds the true one.',
    `A row is the same or slower where the interval lies on one side of ${LIMIT}; where it does not, "maybe".`,
    '',
    ...table(
      ['row', 'before', 'after', 'ratio', 'interval', 'pairs', ''],
      times.map((row) => [
        row.name,
        digits(row.before),
        digits(row.after),
        row.ratio.toFixed(3),
        row.interval.map((bound) => bound.toFixed(3)).join('–'),
        String(row.pairs),
        row.verdict,
      ]),
    ),
    '',
    ...table(
      ['row', 'before', 'after', ''],
      figures.map((row) => [row.name, String(row.before), String(row.after), row.isWorse ? 'worse' : 'as good']),
    ),
    '',
    ...(slower.length > 0
      ? [
          `Slower by more than ${LIMIT_PERCENT} %:`,
          ...slower.map(({ name, ratio, verdict }) => `- ${name}: ${ratio.toFixed(3)}, ${verdict}`),
        ]
      : [`No row slower by more than ${LIMIT_PERCENT} %.`]),
    ...(worse.length > 0
      ? ['Less accurate or larger:', ...worse.map((row) => `- ${row.name}: ${row.before} to ${row.after}`)]
      : ['No row less accurate, none larger.']),
    '',
  ].join('\n');
  save('against', results, text);
}
