// npm run bench -- --inside: distances inside of tetrahedra, against closed forms and against libigl's heat method, in alternation;
// and a million tetrahedra on the page.

import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { attempt, LIBIGL, pythonWith } from '../peers.mjs';
import { bundle, publishModules } from '../bundle.mjs';
import { prepare } from '../needs.mjs';
import { cargo, fail, root } from '../steps.mjs';
import { description } from './checkout.mjs';
import { median } from './ratios.mjs';
import { table } from './report.mjs';

const ROUNDS = 3;
const FOLDER = join(root, 'target', 'bench', 'inside');

export async function inside({ quick }) {
  prepare();
  publishModules();
  bundle();
  cargo(
    'Building the example',
    ['build', '--release', '-p', 'heatwalk-volume', '--example', 'inside'],
    'See the messages above.',
  );
  const python = pythonWith(LIBIGL);
  mkdirSync(FOLDER, { recursive: true });
  const rounds = Array.from({ length: quick ? 1 : ROUNDS }, (_, round) => {
    console.log(`\n— Round ${round + 1}`);
    const ours = own();
    for (const row of ours) row.igl = attempt(python, [join(import.meta.dirname, 'inside.py'), row.file]);
    return ours;
  });
  const rows = rounds[0].map((first, index) =>
    summary(
      rounds.map((round) => round[index]),
      first,
    ),
  );
  const heads = [
    'mesh',
    'tetrahedra',
    'source',
    'march, error (%)',
    'heat, error (%)',
    'libigl, scaled, error (%)',
    'march (ms)',
    'heat, precompute / solve (ms)',
    'libigl (ms)',
    'heat / libigl',
  ];
  const text = [description(root), '', ...table(heads, rows), '', ...(await million()), ''].join('\n');
  writeFileSync(join(root, 'target', 'bench', 'inside.md'), text);
  console.log(`\n${text}\nWritten to target/bench/inside.md.`);
}

/** A million tetrahedra on the page, from the bytes of a file, by both methods. */
async function million() {
  const { Page } = await import('./page.mjs');
  const page = await Page.open();
  try {
    const rows = [];
    for (const method of ['march', 'heat']) {
      const answer = await page.inside(join(FOLDER, 'million.msh'), method === 'heat');
      if (answer.failed) {
        rows.push([method, answer.failed, '', '', '', '', '']);
        continue;
      }
      const { tetrahedra, open, precompute, solve, memory } = answer;
      const seconds = [open, precompute, solve, open + precompute + solve].map((ms) => (ms / 1000).toFixed(2));
      rows.push([method, String(tetrahedra), ...seconds, (memory / 2 ** 30).toFixed(2)]);
    }
    return table(
      ['page', 'tetrahedra', 'open (s)', 'precompute (s)', 'first field (s)', 'together (s)', 'memory (GiB)'],
      rows,
    );
  } finally {
    await page.close();
  }
}

/** The rows that the example prints, with the files that it writes. */
function own() {
  const program = join(root, 'target', 'release', 'examples', 'inside');
  const { status, stdout, stderr } = spawnSync(program, ['--write', FOLDER], { encoding: 'utf8' });
  if (status !== 0) fail(`The example failed: ${stderr}`);
  const written = new Set(readdirSync(FOLDER));
  return stdout
    .trim()
    .split('\n')
    .slice(2)
    .map((line) => {
      const [mesh, tetrahedra, source, march, heat, marched, heated] = line
        .slice(1, -1)
        .split('|')
        .map((cell) => cell.trim());
      const name = `${mesh} ${tetrahedra} ${source}.txt`;
      if (!written.has(name)) fail(`The example has not written ${name}.`);
      const [precompute, solve] = heated.split('/').map(Number);
      return {
        mesh,
        tetrahedra,
        source,
        march,
        heat,
        marched: Number(marched),
        precompute,
        solve,
        file: join(FOLDER, name),
      };
    });
}

/** Milliseconds of precompute and of a solve. */
function times([precompute, solve]) {
  return `${precompute.toFixed(0)} / ${solve.toFixed(2)}`;
}

/** The medians of the rounds of one mesh and source. Errors are the same in all. */
function summary(rounds, { mesh, tetrahedra, source, march, heat, igl }) {
  const failed = rounds.find((round) => round.igl.failed);
  if (failed) return [mesh, tetrahedra, source, march, heat, failed.igl.failed, '', '', '', ''];
  const middle = (pick) => median(rounds.map(pick));
  const ours = [middle(({ precompute }) => precompute), middle(({ solve }) => solve)];
  const theirs = [middle((round) => round.igl.precompute), middle((round) => round.igl.solve)];
  return [
    mesh,
    tetrahedra,
    source,
    march,
    heat,
    `${igl.mean.toFixed(2)} / ${igl.max.toFixed(1)}`,
    middle(({ marched }) => marched).toFixed(2),
    times(ours),
    times(theirs),
    `${(ours[0] / theirs[0]).toFixed(2)} / ${(ours[1] / theirs[1]).toFixed(2)}`,
  ];
}
