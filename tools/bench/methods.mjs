// npm run bench -- --methods: the methods that factor nothing, against potpourri3d's robust heat method: errors, and times
// from positions, in alternation.

import { join } from 'node:path';
import { attempt, POTPOURRI3D, pythonWith } from '../peers.mjs';
import { bundle, publishModules } from '../bundle.mjs';
import { prepare } from '../needs.mjs';
import { root } from '../steps.mjs';
import { description } from './checkout.mjs';
import { folder, meshes as chosenMeshes } from './meshes.mjs';
import { Programs } from './programs.mjs';
import { judge, median } from './ratios.mjs';
import { digits, save, table } from './report.mjs';

/** The least that give an interval. */
const PAIRS = 6;
/** Sources of a median solve. */
const SOURCES = 10;
/** Windows kept of each half-edge; the first is the default. */
const KEPT = [1, 2, 4, 8];
const METHODS = ['propagation', 'auto', 'exact'];
const ROBUST = 'pp3d robust';
/** The preset that is shown before a file is dropped. */
const BEFORE_A_FILE = 'teapot';

/** Meshes as in `chosenMeshes`. Those on which a peer takes minutes have one pair, and neither errors nor exact distances. */
export async function methods({ files, subdivisions, quick, only }) {
  prepare();
  publishModules();
  bundle();
  const { Page } = await import('./page.mjs');
  const page = await Page.open();
  const programs = new Programs(root);
  programs.build();
  const python = pythonWith(POTPOURRI3D);
  console.log('\n— Writing the meshes');
  const program = programs.example('bench_mesh');
  const all = await chosenMeshes({ files, subdivisions, quick, only, program });
  const meshes = all.filter(({ who }) => who.includes('robust'));
  for (const mesh of meshes) {
    console.log(`\n— ${mesh.name}, ${mesh.triangles} triangles`);
    mesh.rows = await alternate({ programs, page }, python, mesh, quick || mesh.isSlow ? 1 : PAIRS);
    if (!mesh.isSlow) mesh.errors = errors(programs, python, mesh);
    const { memory } = await page.worker(mesh.file, [0], KEPT[0]);
    mesh.page = { memory, drag: await page.drag(BEFORE_A_FILE, mesh.file) };
  }
  await page.close();
  report(meshes);
}

/** The ratios of each row to the peer, of pairs measured one right after the other; which is first alternates. */
async function alternate(own, python, mesh, count) {
  const { sources } = own.programs.another(mesh.file, 'propagation', SOURCES);
  const pairs = [];
  while (pairs.length < count) {
    const pair = {};
    const ours = async () => (pair.own = await times(own, mesh, sources));
    const peer = () =>
      (pair.peer = attempt(python, [script('bench/peers.py'), 'robust', mesh.file, ...sources.map(String)]));
    for (const measure of pairs.length % 2 === 0 ? [ours, peer] : [peer, ours]) await measure();
    if (pair.peer.failed) return { failed: pair.peer.failed };
    pairs.push(pair);
  }
  return Object.keys(pairs[0].own).map((name) => {
    const ours = pairs.map((pair) => pair.own[name]);
    const peer = pairs.map(({ peer: { precompute, solve } }) =>
      name.startsWith('first') ? precompute + solve : solve,
    );
    const { ratio, interval } = judge(ours.map((time, pair) => time / peer[pair]));
    return { name, own: median(ours), peer: median(peer), ratio, interval };
  });
}

/** Milliseconds from positions to the first whole field by each method, and of another source by propagation. */
async function times({ programs, page }, { file, isSlow }, sources) {
  const wanted = METHODS.filter((method) => method !== 'exact' || !isSlow);
  return {
    ...Object.fromEntries(wanted.map((method) => [`first field, ${method}`, programs.first(file, method)])),
    'another source, propagation': programs.another(file, 'propagation', SOURCES).solve,
    ...(await timesOnPage(page, file, sources)),
  };
}

/** The same by propagation in the page's worker; from a file's bytes as well. */
async function timesOnPage(page, file, sources) {
  const { read, precompute, first, solve, failed } = await page.worker(file, sources, KEPT[0]);
  if (failed) throw new Error(failed);
  return {
    'first field, page': precompute + first,
    'first field from bytes, page': read + precompute + first,
    'another source, page': solve,
  };
}

/** Mean and maximum error in per cent against exact distances from vertex 0, by name. */
function errors(programs, python, { file }) {
  const exact = join(folder, 'exact.csv');
  programs.distance(file, 0, '--exact', '--output', exact);
  const propagation = (kept) => programs.error(file, 0, '--method', 'propagation', '--windows', String(kept));
  return {
    ...Object.fromEntries(KEPT.map((kept) => [`K = ${kept}`, propagation(kept)])),
    auto: programs.error(file, 0, '--method', 'auto'),
    heat: programs.error(file, 0, '--method', 'heat'),
    [ROBUST]: attempt(python, [script('accuracy_peers.py'), 'robust', file, '0', exact]),
  };
}

function script(path) {
  return join(root, 'tools', ...path.split('/'));
}

function report(meshes) {
  const results = {
    date: new Date().toISOString().slice(0, 16),
    commit: description(root),
    meshes: meshes.map(({ file: _file, who: _who, ...mesh }) => mesh),
  };
  const text = [
    `${results.date}; commit ${results.commit}; ${POTPOURRI3D}. One thread each. A ratio is the median of those of the pairs; in`,
    '95 of 100 cases the interval holds the true one. Times in ms: the peer precomputes and solves for the first field, and',
    'solves for another source.',
    '',
    ...timesTable(meshes),
    '',
    'Error relative to exact distances from vertex 0, mean % / maximum %.',
    '',
    ...errorsTable(meshes.filter(({ errors: measured }) => measured)),
    '',
    "On the page: MiB of the worker's memory after the first field, and fields a second while a source is dragged.",
    '',
    ...table(['mesh', 'memory', 'fields a second'], meshes.map(pageRow)),
    '',
  ].join('\n');
  save('methods', results, text);
}

function timesTable(meshes) {
  return table(['mesh', 'triangles', 'what', 'this', ROBUST, 'ratio', 'interval'], meshes.flatMap(timesRows));
}

function timesRows({ name, triangles, rows }) {
  if (rows.failed) return [[name, String(triangles), rows.failed, '–', '–', '–', '–']];
  return rows.map(({ name: what, own, peer, ratio, interval }) => {
    const bounds = interval[1] < Infinity ? interval.map((bound) => bound.toFixed(3)).join('–') : '–';
    return [name, String(triangles), what, digits(own), digits(peer), ratio.toFixed(3), bounds];
  });
}

function pageRow({ name, page: { memory, drag } }) {
  return [name, (memory / 2 ** 20).toFixed(0), drag.fields.toFixed(0)];
}

function errorsTable(meshes) {
  const names = Object.keys(meshes[0]?.errors ?? {});
  const cells = ({ name, errors: measured }) => [name, ...names.map((method) => errorCell(measured[method]))];
  return table(['mesh', ...names], meshes.map(cells));
}

function errorCell({ mean, max, failed }) {
  return failed ? 'failed' : [mean, max].map((error) => (error === 0 ? '0' : error.toPrecision(2))).join(' / ');
}
