// npm run bench [-- --quick] [--only WORD] [--mesh FILE ... [--subdivide N]]: the native program, the page's worker and the
// peers on the same meshes and from the same sources, in alternation, against the bars; with --methods the methods that
// factor nothing against potpourri3d alone; with --inside tetrahedra against libigl; with --models models of several parts,
// textured and compressed ones; with --against COMMIT [--budget SECONDS] this checkout against another commit.
// docs/benchmarks.md tells what each number means.

import { existsSync } from 'node:fs';
import { cpus, totalmem } from 'node:os';
import { parseArgs } from 'node:util';
import { against } from './bench/against.mjs';
import { bars, growthOf } from './bench/bars.mjs';
import { description } from './bench/checkout.mjs';
import { meshes as chosenMeshes } from './bench/meshes.mjs';
import { inside } from './bench/inside.mjs';
import { models } from './bench/models.mjs';
import { methods } from './bench/methods.mjs';
import { Peers } from './bench/peers.mjs';
import { Programs } from './bench/programs.mjs';
import { markdown, save } from './bench/report.mjs';
import { bundle, publishModules } from './bundle.mjs';
import { prepare } from './needs.mjs';
import { fail, root } from './steps.mjs';

const ROUNDS = 5;
/** On meshes where a round takes a minute. */
const FEW_ROUNDS = 3;
const SOURCES = 10;
const PEERS = ['plain', 'robust', 'libigl', 'cholmod'];
const DRAGGED = ['bunny', 'dragon'];
const PAINTED = 'dragon';
const ANIMATED = 'robot';

const { values } = parseArgs({
  options: {
    mesh: { type: 'string', multiple: true, default: [] },
    subdivide: { type: 'string', default: '0' },
    only: { type: 'string', default: '' },
    quick: { type: 'boolean', default: false },
    methods: { type: 'boolean', default: false },
    inside: { type: 'boolean', default: false },
    models: { type: 'boolean', default: false },
    against: { type: 'string' },
    budget: { type: 'string', default: '60' },
  },
});
const missing = values.mesh.find((file) => !existsSync(file));
if (missing) fail(`There is no file ${missing}.`);
if (!(Number(values.budget) > 0)) fail('--budget takes a number of seconds.');
if (!/^[0-4]$/.test(values.subdivide)) fail('--subdivide takes a number from 0 to 4.');

if (values.against !== undefined) {
  const { only, mesh: files, quick } = values;
  await against(values.against, { only, files, quick, budget: Number(values.budget) });
  process.exit();
}

if (values.methods) {
  const { only, mesh: files, quick } = values;
  await methods({ files, subdivisions: Number(values.subdivide), quick, only });
  process.exit();
}

if (values.inside) {
  await inside({ quick: values.quick });
  process.exit();
}

if (values.models) {
  const { only, mesh: files } = values;
  await models({ files, only });
  process.exit();
}

prepare();
publishModules();
const programs = new Programs(root);
programs.build();
bundle();
const peers = new Peers();
const { Page } = await import('./bench/page.mjs');
const page = await Page.open();
console.log('\n— Writing the meshes');
const meshes = await chosenMeshes({
  files: values.mesh,
  subdivisions: Number(values.subdivide),
  quick: values.quick,
  only: values.only,
  program: programs.example('bench_mesh'),
});
for (const mesh of meshes) await measure(mesh);
console.log('\n— Dragging a source');
const drags = [];
for (const preset of DRAGGED) drags.push(await page.drag(preset));
console.log('\n— Painting');
const painted = await page.paint(PAINTED);
console.log('\n— Playing an animation');
const live = await page.live(ANIMATED);
const firstPicture = { webgpu: await page.firstPicture(), webgl2: await page.firstPicture(false) };
report();
await page.close();

/** Adds the medians to the mesh: `times` of everyone, and what `queries` take. */
async function measure(mesh) {
  console.log(`\n— ${mesh.name}, ${mesh.triangles} triangles`);
  const all = Object.fromEntries(mesh.who.map((who) => [who, []]));
  const asked = [];
  mesh.rounds = values.quick ? 1 : mesh.isSlow ? FEW_ROUNDS : ROUNDS;
  for (let round = 0; round < mesh.rounds; round++) {
    const { sources, ...own } = programs.native(mesh.file, SOURCES);
    all.native.push(own);
    if (all.page) all.page.push(await page.worker(mesh.file, sources));
    for (const peer of PEERS.filter((who) => all[who] && (round === 0 || !mesh.isSlow))) {
      all[peer].push(peers.run(peer, mesh.file, sources));
    }
    if (mesh.queries) asked.push(programs.queries(mesh.file));
  }
  mesh.times = Object.fromEntries(Object.entries(all).map(([who, runs]) => [who, middle(runs)]));
  if (mesh.queries) mesh.queries = middle(asked);
  if (mesh.who.includes('cholmod') && !mesh.isSlow) mesh.factors = programs.factors(mesh.file).heat;
}

/** The median of each number of these equal structures; the first that failed, if any. */
function middle(runs) {
  const [first] = runs;
  const failed = runs.find((run) => run?.failed);
  if (failed) return failed;
  if (typeof first === 'number') return runs.toSorted((a, b) => a - b)[runs.length >> 1];
  if (first === null || typeof first !== 'object') return first;
  return Object.fromEntries(Object.keys(first).map((key) => [key, middle(runs.map((run) => run[key]))]));
}

function report() {
  const [{ model: cpu }] = cpus();
  const results = {
    machine: { cpu: cpu.trim(), cores: cpus().length, memory: Math.round(totalmem() / 2 ** 30) },
    date: new Date().toISOString().slice(0, 16),
    commit: description(root),
    versions: { node: process.version, chromium: page.version, ...peers.versions },
    meshes: meshes.map(({ file: _file, who: _who, ...mesh }) => mesh),
    growth: growthOf(meshes),
    drags,
    painted,
    live,
    firstPicture,
    skipped: peers.skipped,
  };
  results.bars = bars(results);
  const text = markdown(results);
  save('results', results, text);
}
