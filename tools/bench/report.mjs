// The results as Markdown.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../steps.mjs';

const NAMES = {
  plain: 'pp3d heat',
  robust: 'pp3d robust',
  libigl: 'libigl Delaunay',
  cholmod: 'CHOLMOD',
  native: 'native',
  page: 'page',
};
const STAGES = ['build', 'assembling', 'ordering', 'analysing', 'factoring'];
const MISSING = '–';

export function markdown({ machine, date, commit, versions, meshes, drags, painted, firstPicture, bars, skipped }) {
  const versionList = Object.entries(versions).map(([name, version]) => `${name} ${version}`);
  return [
    `${machine.cpu}, ${machine.cores} cores, ${machine.memory} GiB; ${date}; commit ${commit}.`,
    `Versions: ${versionList.join(', ')}. One thread each; medians of rounds in alternation.`,
    ...Object.values(skipped),
    blasWarning(meshes),
    ...section(
      'Times',
      'Precompute / solve in ms; in brackets their ratios to pp3d robust. CHOLMOD: analysing and factoring both matrices /',
      'one substitution with each. A star: the peer ran once.',
      '',
      ...timesTable(meshes),
    ),
    ...section('Stages of native precompute', ...stagesTable(meshes)),
    ...section(
      "faer's Cholesky under the same elimination order",
      'One heat matrix and one right side, factor / solve in ms; in brackets the ratios of this to faer.',
      '',
      ...factorsTable(meshes),
    ),
    ...section('Bars', ...barsTable(bars)),
    ...section(
      'Dragging a source, and painting',
      ...dragsTable([...drags, { ...painted, preset: `${painted.preset}, painted` }]),
    ),
    ...section('Bytes to the first picture, after brotli', ...bytesTable(firstPicture)),
    ...failures(meshes),
    '',
  ]
    .filter((line) => line !== null)
    .join('\n');
}

function section(heading, ...lines) {
  return ['', `### ${heading}`, '', ...lines];
}

/** Writes results and what is told of them, and tells it. */
export function save(name, results, text) {
  const folder = join(root, 'target', 'bench');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, `${name}.json`), JSON.stringify(results, undefined, 2));
  writeFileSync(join(folder, `${name}.md`), text);
  console.log(`\n${text}\nWritten to target/bench/${name}.json and target/bench/${name}.md.`);
}

/** The bytes of each file that the page loads until its first picture, with WebGPU and with WebGL2. */
export function bytesTable({ webgpu, webgl2 }) {
  const files = Object.keys({ ...webgpu.files, ...webgl2.files });
  const rows = files.map((file) => [file, bytes(webgpu.files[file]), bytes(webgl2.files[file])]);
  return table(['file', 'WebGPU', 'WebGL2'], [...rows, ['all', bytes(webgpu.bytes), bytes(webgl2.bytes)]]);
}

function bytes(count) {
  return count === undefined ? MISSING : count.toLocaleString('en');
}

function timesTable(meshes) {
  const names = Object.keys(NAMES);
  const rows = meshes.map(({ name, triangles, rounds, times, isSlow }) => {
    const cells = names.map((who) => {
      const once = isSlow && who !== 'native' && who !== 'page' ? '*' : '';
      return timesCell(times[who], times.robust) + (times[who]?.solve ? once : '');
    });
    return [name, String(triangles), String(rounds), ...cells];
  });
  return table(['mesh', 'triangles', 'rounds', ...Object.values(NAMES)], rows);
}

function timesCell(times, robust) {
  if (!times) return MISSING;
  if (times.failed) return times.failed === 'skipped' ? MISSING : 'failed';
  const precompute = times.precompute ?? times.factors;
  const own = `${digits(precompute)} / ${digits(times.solve)}`;
  if (!robust?.precompute || times === robust) return own;
  return `${own} (${digits(precompute / robust.precompute)} / ${digits(times.solve / robust.solve)})`;
}

function stagesTable(meshes) {
  const header = ['mesh', ...STAGES.map((stage) => stage.replace('_', ' ')), 'factors / CHOLMOD', 'analysed once'];
  const rows = meshes.map(({ name, times: { native, cholmod } }) => [
    name,
    ...STAGES.map((stage) => digits(native[stage])),
    digits(native.factors / cholmod?.factors),
    digits(native.factors / cholmod?.analysed_once),
  ]);
  return table(header, rows);
}

function factorsTable(meshes) {
  const rows = meshes
    .filter(({ factors }) => factors)
    .map(({ name, factors: { factor, solve, ...faer } }) => {
      const peer = (kind) => {
        const [factored, solved] = [faer[`faer_${kind}_factor`], faer[`faer_${kind}_solve`]];
        return `${digits(factored)} / ${digits(solved)} (${digits(factor / factored)} / ${digits(solve / solved)})`;
      };
      return [name, `${digits(factor)} / ${digits(solve)}`, peer('supernodal'), peer('simplicial')];
    });
  return table(['mesh', 'this', 'faer, supernodal', 'faer, simplicial'], rows);
}

/** A line for each compared figure. */
export function barsTable(bars) {
  const rows = bars.map(({ row, what, mesh, reached, bar, aim, unit, verdict }) => {
    const bounds =
      bar === null ? (aim === null ? MISSING : `aim ${aim}`) : aim === bar ? String(bar) : `${bar}, aim ${aim}`;
    return [String(row), what, mesh, bounds, reached === Infinity ? 'failed' : digits(reached) + unit, verdict];
  });
  return table(['row', 'what', 'on', 'bar', 'reached', ''], rows);
}

function dragsTable(drags) {
  const rows = drags.map(({ preset, triangles, fields, frames, moves, usual, longest }) => [
    preset,
    String(triangles),
    ...[fields, frames, moves].map((rate) => rate.toFixed(0)),
    `${usual.toFixed(1)} / ${longest.toFixed(1)}`,
  ]);
  return table(
    ['preset', 'triangles', 'fields/s', 'pictures/s', 'pointer events/s', 'usual / longest answer (ms)'],
    rows,
  );
}

function failures(meshes) {
  const lines = meshes.flatMap(({ name, times }) =>
    Object.entries(times)
      .filter(([, it]) => it.failed && it.failed !== 'skipped')
      .map(([who, { failed }]) => `- ${NAMES[who]} on ${name}: ${failed}`),
  );
  return lines.length > 0 ? ['', '### Failed', '', ...lines] : [];
}

function blasWarning(meshes) {
  const isSlow = meshes.some(({ times }) => times.cholmod?.blas === 'reference BLAS');
  return isSlow ? 'CHOLMOD ran on the reference BLAS, which is slow: apt-get install libopenblas0-serial.' : null;
}

export function table(header, rows) {
  const rule = header.map((_, column) => (column === 0 ? '---' : '---:'));
  return [header, rule, ...rows].map((cells) => `| ${cells.join(' | ')} |`);
}

/** Three of them. */
export function digits(value) {
  if (!Number.isFinite(value)) return MISSING;
  const before = Math.max(1, Math.ceil(Math.log10(Math.abs(value) + Number.MIN_VALUE)));
  return value.toFixed(Math.min(3, Math.max(0, 3 - before)));
}
