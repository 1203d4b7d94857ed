// npm run accuracy -- [--presets] [--mesh FILE ...]: error of distances by heat and by propagation at default settings, and of
// geometry-central's robust heat method (potpourri3d), against exact distances; and the time of exact distances against
// pygeodesic's. Two sources a mesh, the first vertex and the middle one. Meshes must be welded: the peers do not weld.

import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { json, POTPOURRI3D, pythonWith, PYGEODESIC } from './peers.mjs';
import { prepare } from './needs.mjs';
import { cargo, fail, root } from './steps.mjs';

/** The shapes of the presets that are one surface. */
const PRESETS = [
  'horse',
  'animal',
  'triceratops',
  'skull',
  'maze',
  'high_genus',
  'ring',
  'hemisphere',
  'terrain',
  'torus',
];
/** Windows kept of each half-edge; the first is the default. */
const KEPT = [1, 2, 4, 8];

const { values } = parseArgs({
  options: { mesh: { type: 'string', multiple: true, default: [] }, presets: { type: 'boolean', default: false } },
});
const meshes = values.mesh.map((mesh) => resolve(mesh));
if (meshes.length === 0 && !values.presets)
  fail('Give welded meshes: npm run accuracy -- [--presets] [--mesh FILE ...]');
const missing = meshes.find((mesh) => !existsSync(mesh));
if (missing) fail(`There is no file ${missing}.`);
const folder = join(root, 'target', 'bench');
mkdirSync(folder, { recursive: true });
prepare();
cargo('Building the program', ['build', '--release', '--package', 'heatwalk-cli'], 'See above.');
if (values.presets) {
  const writer = ['run', '--release', '--package', 'heatwalk', '--example', 'bench_mesh', '--'];
  for (const name of PRESETS) {
    const file = join(folder, `${name}.ply`);
    cargo(`Writing ${name}`, [...writer, `preset:${name}`, file], 'See above.');
    meshes.push(file);
  }
}
const python = pythonWith(POTPOURRI3D, PYGEODESIC);
const program = join(root, 'target', 'release', 'heatwalk');
const script = join(root, 'tools', 'accuracy_peers.py');

const rows = [];
for (const mesh of meshes) {
  const { vertices } = json(program, ['info', mesh, '--json']);
  for (const source of [0, Math.floor(vertices / 2)]) rows.push(measure(mesh, source));
}
print();
writeFileSync(join(folder, 'accuracy.json'), JSON.stringify(rows, undefined, 2));

function measure(mesh, source) {
  const exactFile = join(folder, 'exact.csv');
  const from = ['distance', mesh, '--source', String(source), '--json'];
  const own = json(program, [...from, '--method', 'heat', '--compare']);
  const exact = json(program, [...from, '--exact', '--output', exactFile]);
  const propagation = KEPT.map((windows) => {
    const errors = json(program, [...from, '--method', 'propagation', '--windows', String(windows), '--compare']);
    return { mean: errors.mean_error_percent, max: errors.max_error_percent };
  });
  const robust = json(python, [script, 'robust', mesh, String(source), exactFile]);
  // It ends with a fault on meshes that are not manifold.
  const peer = json(python, [script, 'exact', mesh, String(source), exactFile], { mayFail: true });
  return {
    mesh: basename(mesh),
    source,
    mean: own.mean_error_percent,
    max: own.max_error_percent,
    timeFactor: own.time_factor,
    propagation,
    robust,
    exactMs: exact.timings_ms.solve,
    peerMs: peer?.ms,
    difference: peer?.max_difference,
  };
}

function geometricMean(numbers) {
  return Math.exp(numbers.reduce((sum, number) => sum + Math.log(number), 0) / numbers.length);
}

function print() {
  console.log('\nRelative error against exact distances, mean % / maximum %, and ratios to the peer\n');
  console.log('| mesh | source | m | Heatwalk | geometry-central robust | ratio |');
  console.log('|---|---:|---:|---|---|---|');
  for (const { mesh, source, mean, max, timeFactor, robust } of rows) {
    const ratio = `${(mean / robust.mean).toFixed(2)} / ${(max / robust.max).toFixed(2)}`;
    const [own, peer] = [
      [mean, max],
      [robust.mean, robust.max],
    ].map((errors) => `${errors[0].toFixed(2)} / ${errors[1].toFixed(1)}`);
    console.log(`| ${mesh} | ${source} | ${timeFactor.toFixed(2)} | ${own} | ${peer} | ${ratio} |`);
  }
  const means = geometricMean(rows.map(({ mean, robust }) => mean / robust.mean));
  const maxima = geometricMean(rows.map(({ max, robust }) => max / robust.max));
  console.log(`\nGeometric mean of the ratios: ${means.toFixed(3)} / ${maxima.toFixed(3)}`);
  printPropagation();

  console.log('\nExact distances, ms, and the largest relative difference\n');
  console.log('| mesh | source | Heatwalk | pygeodesic | ratio | difference |');
  console.log('|---|---:|---:|---:|---:|---:|');
  for (const { mesh, source, exactMs, peerMs, difference } of rows) {
    const peer =
      peerMs === undefined
        ? ['–', '–', '–']
        : [peerMs.toFixed(1), (exactMs / peerMs).toFixed(3), difference.toExponential(1)];
    console.log(`| ${mesh} | ${source} | ${exactMs.toFixed(1)} | ${peer.join(' | ')} |`);
  }
}

function printPropagation() {
  console.log('\nThe same for propagation with so many windows\n');
  console.log(`| mesh | source | ${KEPT.map((windows) => `K = ${windows}`).join(' | ')} | ratio, K = ${KEPT[0]} |`);
  console.log(`|---|---:|${'---|'.repeat(KEPT.length + 1)}`);
  for (const { mesh, source, propagation, robust } of rows) {
    const errors = propagation.map(({ mean, max }) => `${mean.toPrecision(2)} / ${max.toPrecision(2)}`);
    const [{ mean, max }] = propagation;
    const ratio = `${(mean / robust.mean).toFixed(3)} / ${(max / robust.max).toFixed(3)}`;
    console.log(`| ${mesh} | ${source} | ${errors.join(' | ')} | ${ratio} |`);
  }
  const ratios = KEPT.map((_, place) =>
    ['mean', 'max'].map((of) => geometricMean(rows.map((row) => row.propagation[place][of] / row.robust[of]))),
  );
  console.log('\nGeometric means of the ratios:');
  ratios.forEach(([mean, max], place) => {
    console.log(`K = ${KEPT[place]}: ${mean.toPrecision(2)} / ${max.toPrecision(2)}`);
  });
}
