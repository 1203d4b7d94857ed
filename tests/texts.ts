/** The texts of the page, found in its sources. */
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { parseSync } from 'rolldown/experimental';
import { PATTERNS, RAMP_NAMES, STYLES, SURROUNDINGS } from '../web/state/styles';
import { SETTINGS } from '../web/ui/help/settings';

/** Of the syntax tree; what other nodes have is looked through. */
interface Node {
  type: string;
  start: number;
  [key: string]: unknown;
}

/** What a file says: texts inside `t`, `counted` and `some`, and others that have the look of one. */
export interface Said {
  texts: string[];
  bare: string[];
}

export function saidBy(source: string): Said {
  const said: Said = { texts: [], bare: [] };
  visit(parseSync('a.ts', source).program as unknown as Node, said);
  return said;
}

/** Names that are shown translated wherever they come from. */
export const NAMES: readonly string[] = [
  ...STYLES.map(({ name }) => name),
  ...SURROUNDINGS,
  ...PATTERNS,
  ...RAMP_NAMES,
  'single color',
  "the file's materials",
  ...Object.values(SETTINGS).flatMap((settings) => Object.keys(settings)),
];

/** What is not of the page that people see: modules, documents, the interfaces for programs, and lines of programs. */
const OTHERS =
  /^(wasm|texts|docs|offline|embed\.ts|solver\/worker|ui\/(control|embedding)|ui\/scripting\.ts|state\/rust\.ts|state\/report\.ts|state\/table1\.ts|state\/convergence\.ts|state\/styles\.ts)/;

/** The sources of the page whose texts are translated, by their paths in `web`. */
export async function sources(): Promise<[string, string][]> {
  const root = new URL('../web/', import.meta.url).pathname;
  const paths = (await readdir(root, { recursive: true })).filter((path) => path.endsWith('.ts') && !OTHERS.test(path));
  return Promise.all(paths.map(async (path) => [path, await readFile(join(root, path), 'utf8')] as [string, string]));
}

function isNode(value: unknown): value is Node {
  return typeof value === 'object' && value !== null && 'type' in value && typeof value.type === 'string';
}

function wordsOf(node: Node): string | null {
  if (node.type === 'Literal' && typeof node['value'] === 'string') return node['value'];
  if (node.type !== 'TemplateLiteral') return null;
  const quasis = node['quasis'] as { value: { cooked: string } }[];
  return quasis.map(({ value }) => value.cooked).reduce((before, part, index) => `${before}{${index - 1}}${part}`);
}

/** Whether it has words with a space between them, or one that begins with a capital. */
function looksLikeText(words: string): boolean {
  const own = words.replaceAll(/\{\d\}/g, '');
  return (
    (/[a-z]{2}/i.test(own) && /[a-z]{2} [a-z]/i.test(words.replaceAll(/\{\d\}/g, 'value'))) ||
    /^[A-Z][a-z]+$/.test(words)
  );
}

function visit(node: Node, said: Said): void {
  // Types say nothing, and modules are found by their paths.
  if (node.type === 'ImportDeclaration' || node.type === 'ImportExpression') return;
  if (node.type.startsWith('TS') && !isNode(node['expression'])) return;
  const words = wordsOf(node);
  if (words !== null && looksLikeText(words)) said.bare.push(words);
  for (const child of translated(node, said)) visit(child, said);
}

/** The children of a node, of one that translates only those that it does not. */
function translated(node: Node, said: Said): Node[] {
  const children = Object.values(node).flat().filter(isNode);
  const callee = node['callee'] ?? node['tag'];
  const name = isNode(callee) ? callee['name'] : undefined;
  if (node.type === 'TaggedTemplateExpression' && name === 't') {
    const quasi = node['quasi'] as Node;
    said.texts.push(wordsOf(quasi) ?? '');
    return (quasi['expressions'] as Node[]).filter(isNode);
  }
  if (node.type !== 'CallExpression' || !['t', 'counted', 'some'].includes(String(name))) return children;
  const given = node['arguments'] as Node[];
  const taken = name === 't' ? given.slice(0, 1) : given.slice(1, 3);
  said.texts.push(...taken.map(wordsOf).filter((text) => text !== null));
  return children.filter((child) => wordsOf(child) === null || !taken.includes(child));
}
