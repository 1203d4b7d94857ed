// npm run bench -- --models [--only WORD] [--mesh FILE ...]: models of several parts, textured and compressed ones: contacts,
// distance across them, stripes after a drop, decoding.

import { mkdirSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { bundle, publishModules } from '../bundle.mjs';
import { prepare } from '../needs.mjs';
import { cargo, fail, root } from '../steps.mjs';
import { compare } from './bars.mjs';
import { description } from './checkout.mjs';
import { assemblies, compressed, textured } from './made.mjs';
import { median } from './ratios.mjs';
import { barsTable } from './report.mjs';
import { cells } from './rows.mjs';

/** A drop is measured so often, each on a fresh page. */
const DROPS = 5;
/** Triangles of compressed models: of the first, which loads what decodes them, and of the one that is measured. */
const FIRST = 2000;
const DECODED = 200_000;

/** The groups that can be chosen, each a function from the page to compared figures. */
const GROUPS = { contacts, bridges, drop, decoding };

export async function models({ files, only }) {
  const chosen = files.length > 0 ? ['contacts'] : Object.keys(GROUPS).filter((name) => name.includes(only));
  if (chosen.length === 0)
    fail(`--only: no group has "${only}" in its name; there are ${Object.keys(GROUPS).join(', ')}.`);
  prepare();
  publishModules();
  bundle();
  const { Page } = await import('./page.mjs');
  const page = await Page.open();
  const rows = [];
  try {
    for (const name of chosen) {
      console.log(`\n— Measuring: ${name}`);
      rows.push(...(await GROUPS[name](page, files)));
    }
  } finally {
    await page.close();
  }
  const text = [description(root), '', ...barsTable(rows), ''].join('\n');
  const target = join(root, 'target', 'bench');
  mkdirSync(target, { recursive: true });
  writeFileSync(join(target, 'models.md'), text);
  console.log(`\n${text}\nWritten to target/bench/models.md.`);
}

/** Milliseconds of looking for contacts, natively by one thread and in the worker. */
async function contacts(page, files) {
  const opening = example('heatwalk-model', 'opening');
  const given = files.map((file) => ({ name: basename(file), bar: null, file: resolve(file) }));
  const rows = [];
  for (const { name, bar, file } of given.length > 0 ? given : assemblies()) {
    const [row] = cells(opening, [file]);
    const native = Number(row.at(-1));
    const { joins } = await page.model(file);
    const unit = { unit: ' ms' };
    rows.push(
      compare(13, `contacts, native (${row[2]} triangles, ${row[6]} contacts)`, name, native, bar, bar, unit),
      compare(14, 'contacts, first in a worker / native', name, joins[0] / native, 2.5, 2.5),
      compare(14, 'contacts, worker / native', name, median(joins.slice(1)) / native, 2.5, 2.5),
    );
  }
  return rows;
}

/** How many times as long distance takes on ten pieces with bridges as on the whole. */
function bridges() {
  const rows = cells(example('heatwalk', 'contacts'), []).filter(([, pieces]) => Number(pieces) > 1);
  return rows.flatMap(([surface, , , , , , , ...times]) =>
    times.map((time, index) => {
      const ratio = Number(/\(([\d.]+)\)/.exec(time)[1]);
      return compare(15, `${['exact', 'propagation'][index]}, ten pieces / whole`, surface, ratio, 1.5, 1.5);
    }),
  );
}

/** Seconds from dropping a textured file to the frame with its stripes. */
async function drop(page) {
  const file = textured();
  const times = [];
  for (let run = 0; run < DROPS; run++) times.push((await page.drop(file)).seconds);
  return [compare(16, 'stripes after a drop, median', basename(file), median(times), 1, 1, { unit: ' s' })];
}

/** What the page loads for a compressed file, and how fast the worker reads one, decoding and all. */
async function decoding(page) {
  const { bytes: usual } = await page.drop(textured());
  const [first, measured] = [await compressed(FIRST), await compressed(DECODED)];
  const rows = [];
  for (const [index, { name, triangles, file }] of measured.entries()) {
    const { bytes } = await page.drop(first[index].file);
    const { reads } = await page.model(file);
    const rate = (ms) => triangles / ms / 1e3;
    const speed = { more: true, unit: ' million/s' };
    rows.push(
      compare(17, 'bytes for a first file, after brotli', name, bytes / 1e3, null, null, { unit: ' kB' }),
      compare(17, 'of these, more than for one that is not compressed', name, (bytes - usual) / 1e3, 250, 250, {
        unit: ' kB',
      }),
      compare(18, 'triangles a second, first file', name, rate(reads[0]), 2, 2, speed),
      compare(18, 'triangles a second, next files', name, rate(median(reads.slice(1))), 2, 2, speed),
    );
  }
  return rows;
}

function example(crate, name) {
  cargo(
    `Building the example ${name}`,
    ['build', '--release', '-p', crate, '--example', name],
    'See the messages above.',
  );
  return join(root, 'target', 'release', 'examples', name);
}
