/** What scripts and the page around the frame give, looked through before anything is done: it may be anything. */
import type { EmbeddedFile, Openable, Options, Place, Source } from '../../embed';
import { ADDRESS_KEYS } from '../../state/link';
import type { MeshPoint } from '../../protocol';
import { LEAST_CLOSED, type Tape } from '../../state/tapes';

const MOST_SOURCES = 100_000;

export type Fields = Readonly<Record<string, unknown>>;

const WAYS = ['preset', 'url', 'files', 'link'];

export function openable(given: Fields): Openable {
  const [way, ...more] = WAYS.filter((each) => given[each] !== undefined);
  if (way === undefined || more.length > 0) throw new Error(`open takes one of ${WAYS.join(', ')}.`);
  const options = given['options'] === undefined ? {} : { options: optionsOf(given['options']) };
  if (way === 'files') return { files: filesOf(given['files']), ...options };
  const named = given[way];
  if (typeof named !== 'string') throw new Error(`${way} is ${shown(named)}; a text is needed.`);
  if (way === 'link') {
    if ('options' in options) throw new Error('A link brings its options with it: leave out one of link and options.');
    return { link: named };
  }
  return way === 'url' ? { url: named, ...options } : { preset: named, ...options };
}

function filesOf(given: unknown): EmbeddedFile[] {
  if (!Array.isArray(given) || given.length === 0) throw new Error('files is a list of one file at least.');
  return given.map((file: unknown, index) => {
    if (file instanceof File) return { name: file.name, content: file };
    if (!isObject(file)) throw new Error(`files[${index}] is ${shown(file)}; a File or { name, content } is needed.`);
    const { name, content } = file;
    if (typeof name !== 'string' || name === '')
      throw new Error(`files[${index}].name is ${shown(name)}; a text is needed.`);
    if (!(content instanceof Blob) && !(content instanceof ArrayBuffer))
      throw new Error(`files[${index}].content is ${shown(content)}; a Blob, File or ArrayBuffer is needed.`);
    return { name, content };
  });
}

export function optionsOf(given: unknown): Options {
  if (!isObject(given)) throw new Error(`options is ${shown(given)}; an object of keys of the link is needed.`);
  return Object.fromEntries(
    Object.entries(given).map(([key, value]) => {
      if (ADDRESS_KEYS.includes(key)) throw new Error(`${key} is no option: ${ofLinks(key)}`);
      if (typeof value !== 'string' && (typeof value !== 'number' || !Number.isFinite(value)))
        throw new Error(`The option ${key} is ${shown(value)}; a text or a number is needed.`);
      return [key, value];
    }),
  );
}

/** What a key is that only links have, and what to do instead. */
function ofLinks(key: string): string {
  if (key === 'v') return 'it is the version of a link; leave it out.';
  if (key !== 'kiosk' && key !== 'open')
    return 'in a link it says which mesh is shown; give open one of preset, url, files, link.';
  const purpose = key === 'kiosk' ? 'hides the panel' : 'names the workspace of the panel';
  return `in a link it ${purpose}, when the page is loaded; write it into the address of the page.`;
}

export function sourcesOf(given: unknown): Source[] {
  if (!Array.isArray(given)) throw new Error(`sources is ${shown(given)}; a list is needed.`);
  if (given.length > MOST_SOURCES) throw new Error(`There are ${given.length} sources; ${MOST_SOURCES} may be given.`);
  return given.map((source: unknown, index) => {
    const name = `sources[${index}]`;
    const place = placeOf(source, name);
    const { offset = 0 } = source as Fields;
    if (typeof offset !== 'number' || !(offset >= 0 && offset < Infinity))
      throw new Error(`${name}.offset is ${shown(offset)}; a distance from 0 is needed.`);
    return offset > 0 ? { ...place, offset } : place;
  });
}

export function walkerOf(given: unknown): Place | null {
  return given === null ? null : placeOf(given, 'walker');
}

export function tapesOf(given: unknown): Tape[] {
  if (!Array.isArray(given)) throw new Error(`tapes is ${shown(given)}; a list is needed.`);
  return given.map((tape: unknown, index) => {
    const name = `tapes[${index}]`;
    if (!isObject(tape)) throw new Error(`${name} is ${shown(tape)}; { points, closed } is needed.`);
    const { points, closed = false } = tape;
    if (typeof closed !== 'boolean') throw new Error(`${name}.closed is ${shown(closed)}; true or false is needed.`);
    const least = closed ? LEAST_CLOSED : 1;
    if (!Array.isArray(points) || points.length < least)
      throw new Error(`${name}.points is ${shown(points)}; a list of ${least} or more places is needed.`);
    return { points: points.map((point: unknown, i) => placeOf(point, `${name}.points[${i}]`)) as MeshPoint[], closed };
  });
}

/** The sum of weights is 1 up to rounding in single precision, in which a host may have them. */
const WEIGHTS_SUM = 1e-5;

export function placeOf(given: unknown, name: string): Source {
  if (isObject(given)) {
    const { vertex, face, tetrahedron, weights } = given;
    const kinds = [vertex, face, tetrahedron].filter((index) => index !== undefined);
    if (kinds.length === 1 && isIndex(kinds[0])) {
      if (isIndex(vertex)) return { vertex };
      const count = isIndex(face) ? 3 : 4;
      if (!areWeights(weights, count))
        throw new Error(`${name}.weights is ${shown(weights)}; ${count} numbers from 0 that sum to 1 are needed.`);
      return { ...(isIndex(face) ? { face } : { tetrahedron }), weights } as unknown as Source;
    }
  }
  throw new Error(`${name} is ${shown(given)}; { vertex }, { face, weights } or { tetrahedron, weights } is needed.`);
}

function areWeights(given: unknown, count: number): given is number[] {
  if (!Array.isArray(given) || given.length !== count) return false;
  const isEach = given.every((weight: unknown) => typeof weight === 'number' && weight >= 0);
  const sum = given.reduce((all: number, weight: number) => all + weight, 0);
  return isEach && Math.abs(sum - 1) <= WEIGHTS_SUM;
}

function isIndex(given: unknown): given is number {
  return typeof given === 'number' && Number.isInteger(given) && given >= 0 && given < 2 ** 32;
}

export function isObject(given: unknown): given is Fields {
  return typeof given === 'object' && given !== null && !Array.isArray(given);
}

const TOLD_LETTERS = 60;

/** What was given, in few letters. */
export function shown(given: unknown): string {
  if (given === undefined) return 'missing';
  if (typeof given === 'number' || typeof given === 'bigint') return String(given);
  const text = typeof given === 'object' ? JSON.stringify(given) : `“${String(given)}”`;
  return text.length > TOLD_LETTERS ? `${text.slice(0, TOLD_LETTERS)}…` : text;
}
