// node tools/cycles.mjs [FOLDER]: fails where files or folders of the page import each other in a cycle. On every level, the
// files of a folder and the folders in it are the nodes: an import from `a/x.ts` to `b/y.ts` is an arrow from `a` to `b`.
// Imports of types count, and so do `import()` and `new URL(..., import.meta.url)`.

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, sep } from 'node:path';
import { parseSync } from 'vite';
import { fail, root } from './steps.mjs';

/** Imports that the report names for each arrow. */
const SHOWN = 4;

const folder = process.argv[2] ?? join(root, 'web');
const files = readdirSync(folder, { recursive: true })
  .filter((file) => file.endsWith('.ts') && !file.endsWith('.d.ts'))
  .map((file) => file.split(sep).join('/'));
const found = levels(files.flatMap(imports)).flatMap(cycles);
for (const cycle of found) console.error(described(cycle));
if (found.length > 0) fail(`Files or folders import each other in cycles: ${found.length}`);
console.log(`${files.length} files, no cycle.`);

/** What a file imports of the others, as `{ from, to, line }`. */
function imports(from) {
  const text = readFileSync(join(folder, from), 'utf8');
  const { program } = parseSync(from, text);
  const arrows = [];
  visit(program, ({ value, start }) => {
    if (!value.startsWith('.')) return;
    const path = join(dirname(from), value.replace(/\?.*$/, '')).split(sep).join('/');
    const to = [path, `${path}.ts`, `${path}/index.ts`].find((file) => files.includes(file));
    if (to) arrows.push({ from, to, line: text.slice(0, start).split('\n').length });
  });
  return arrows;
}

/** Calls `see` with the literal of every module that the code names. */
function visit(node, see) {
  if (node === null || typeof node !== 'object') return;
  if (node.source?.type === 'Literal') see(node.source);
  const [first, second] = node.arguments ?? [];
  if (node.type === 'NewExpression' && first?.type === 'Literal' && second?.object?.type === 'MetaProperty') see(first);
  for (const child of Object.values(node)) visit(child, see);
}

/** By folder: from which file or folder in it to which other, and the imports that say so. */
function levels(arrows) {
  const byParent = new Map();
  for (const arrow of arrows) {
    const [from, to] = [arrow.from.split('/'), arrow.to.split('/')];
    const depth = from.findIndex((name, at) => name !== to[at]);
    if (depth < 0) continue;
    const parent = from.slice(0, depth).join('/');
    if (!byParent.has(parent)) byParent.set(parent, new Map());
    const level = byParent.get(parent);
    if (!level.has(from[depth])) level.set(from[depth], new Map());
    const next = level.get(from[depth]);
    next.set(to[depth], [...(next.get(to[depth]) ?? []), arrow]);
  }
  return [...byParent];
}

/** Cycles, such that no other is left once each has lost the arrow of the fewest imports. */
function cycles([parent, level]) {
  const all = [];
  for (let nodes = shortest(level); nodes; nodes = shortest(level)) {
    const steps = nodes.map((from, index) => {
      const to = nodes[(index + 1) % nodes.length];
      return { from, to, arrows: level.get(from).get(to) };
    });
    const [weakest] = steps.toSorted((a, b) => a.arrows.length - b.arrows.length);
    level.get(weakest.from).delete(weakest.to);
    all.push({ parent, steps });
  }
  return all;
}

function shortest(level) {
  const ways = [...level.keys()].map((start) => around(level, start)).filter(Boolean);
  return ways.toSorted((a, b) => a.length - b.length)[0];
}

/** The nodes of a shortest cycle through `start`, by breadth first. */
function around(level, start) {
  const ways = [[start]];
  const seen = new Set();
  for (const way of ways) {
    for (const next of level.get(way.at(-1))?.keys() ?? []) {
      if (next === start) return way;
      if (!seen.has(next)) ways.push([...way, next]);
      seen.add(next);
    }
  }
  return undefined;
}

function described({ parent, steps }) {
  const place = ({ from, to, line }) => `        ${join(shown, from)}:${line} imports ${join(shown, to)}`;
  const shown = relative(process.cwd(), folder);
  const lines = steps.flatMap(({ from, to, arrows }) => [
    `    ${from} → ${to}:`,
    ...arrows.slice(0, SHOWN).map(place),
    ...(arrows.length > SHOWN ? [`        and ${arrows.length - SHOWN} more`] : []),
  ]);
  const nodes = steps.map(({ from }) => from);
  return [`${join(shown, parent)}: ${[...nodes, nodes[0]].join(' → ')}`, ...lines, ''].join('\n');
}
