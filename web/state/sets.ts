/** Sets of sources as text in a link. */
import type { MeshPoint, Source } from '../protocol';
import { indexOf, MOST_POINTS, MOST_SETS, placesOf, type SetShape, type SourceSet, withOffset } from './sources';
import { amount, COUNT, pack, parseAmount, unpack } from './text';

/** Text that is longer is packed, and marked so. */
const MOST_READABLE = 1500;
const PACKED = '~';
/** What a link can hold: browsers take more, mail and messengers do not. */
const MOST_LETTERS = 30_000;
/** Weights are written in steps of this share. */
const STEPS = 10_000;

const WRITTEN = new WeakMap<readonly SourceSet[], string>();

/** Text for a link; empty where there are none, and where they are too many for one. */
export function encodeSets(sets: readonly SourceSet[]): string {
  return fitLink(sets) ? encodeAllSets(sets) : '';
}

/** Whether a link can hold them. */
export function fitLink(sets: readonly SourceSet[]): boolean {
  return encodeAllSets(sets).length <= MOST_LETTERS;
}

/** The same text, however long. */
export function encodeAllSets(sets: readonly SourceSet[]): string {
  let text = WRITTEN.get(sets);
  if (text === undefined) {
    const plain = sets.map(encodeSet).join(',');
    const isShort = plain.length <= MOST_READABLE;
    // A percent sign belongs to a name and is read twice: as part of an address first.
    text = isShort ? plain.replaceAll('%', '%25') : PACKED + pack(new TextEncoder().encode(plain));
    WRITTEN.set(sets, text);
  }
  return text;
}

/** Undefined for text that is none, and for more than a scene may have. Places that only a mesh can tell are empty. */
export function decodeSets(text: string): SourceSet[] | undefined {
  if (text === '') return [];
  try {
    const plain = text.startsWith(PACKED) ? new TextDecoder().decode(unpack(text.slice(PACKED.length))) : text;
    const words = plain.split(',', MOST_SETS + 1);
    if (words.length > MOST_SETS) return undefined;
    const sets: SourceSet[] = [];
    let left = MOST_POINTS;
    for (const word of words) {
      const set = parseSet(word);
      left -= set ? placesOf(set) : Infinity;
      if (!set || left < 0) return undefined;
      sets.push(set);
    }
    return sets;
  } catch {
    return undefined;
  }
}

function encodeSet({ shape, points, offset }: SourceSet): string {
  return `${encodeShape(shape, points)}${offset > 0 ? `@${amount(offset)}` : ''}`;
}

function encodeShape(shape: SetShape, points: readonly Source[]): string {
  switch (shape.kind) {
    case 'line':
      return `${shape.closed ? 'loop' : 'line'}:${shape.corners.join('-')}`;
    case 'stroke':
      return `${shape.closed ? 'curve' : 'stroke'}:${encodePoints(points)}`;
    case 'boundary':
    case 'component':
      return `${shape.kind}:${shape.vertex}`;
    case 'part':
      return `part:${shape.part}`;
    case 'list':
      return `list:${encodeURIComponent(shape.name)}:${encodePoints(points)}`;
  }
}

function parseSet(text: string): SourceSet | undefined {
  const [whole = '', start, ...more] = text.split('@');
  const [kind, ...rest] = whole.split(':');
  const offset = start === undefined ? 0 : parseAmount(start);
  const places = rest.pop();
  if (offset === undefined || more.length > 0 || places === undefined || rest.length !== (kind === 'list' ? 1 : 0))
    return undefined;
  const of = (shape: SetShape, points: readonly Source[] | undefined) => points && { shape, points, offset };
  const index = COUNT.parse(places);
  switch (kind) {
    case 'line':
    case 'loop': {
      const corners = places.split('-', MOST_POINTS + 1).map(COUNT.parse);
      const isLine = corners.every((corner) => corner !== undefined);
      return isLine ? of({ kind: 'line', corners, closed: kind === 'loop' }, []) : undefined;
    }
    case 'stroke':
    case 'curve':
      return of({ kind: 'stroke', closed: kind === 'curve' }, parsePoints(places));
    case 'boundary':
    case 'component':
      return index === undefined ? undefined : of({ kind, vertex: index }, []);
    case 'part':
      return index === undefined ? undefined : of({ kind, part: index }, []);
    case 'list':
      return of({ kind, name: decodeURIComponent(rest.join(':')) }, parsePoints(places));
    default:
      return undefined;
  }
}

/** Each as the step from the index before, then its weights but the last one, then its own initial distance. */
function encodePoints(points: readonly Source[]): string {
  let before = 0;
  return points
    .map((point) => {
      const index = indexOf(point);
      const step = index - before;
      before = index;
      const weights = 'vertex' in point ? '' : shares(point.weights);
      return `${step}${weights}${point.offset ? `*${amount(point.offset)}` : ''}`;
    })
    .join('_');
}

/** Whole steps that together are never more than all, so that what is read is written alike. */
function shares(weights: readonly number[]): string {
  let rest = STEPS;
  const part = (weight: number) => {
    const steps = Math.min(rest, Math.max(0, Math.round(STEPS * weight)));
    rest -= steps;
    return `/${steps}`;
  };
  return weights.slice(0, -1).map(part).join('');
}

function parsePoints(text: string): Source[] | undefined {
  const found: Source[] = [];
  let index = 0;
  for (const word of text.split('_')) {
    const [isPoint, step, steps = '', start] = /^(-?\d{1,9})((?:\/\d{1,5}){0,3})(?:\*(.+))?$/.exec(word) ?? [];
    const offset = start === undefined ? 0 : parseAmount(start);
    if (isPoint === undefined || offset === undefined || found.length === MOST_POINTS) return undefined;
    index += Number(step);
    const point = index < 0 ? undefined : pointOf(index, steps.split('/').slice(1).map(Number));
    if (!point) return undefined;
    found.push(withOffset(point, offset));
  }
  return found;
}

function pointOf(index: number, steps: readonly number[]): MeshPoint | undefined {
  const rest = STEPS - steps.reduce((sum, step) => sum + step, 0);
  if (rest < 0 || steps.length === 1) return undefined;
  const [a = 0, b = 0, c = 0, d = 0] = [...steps, rest].map((step) => step / STEPS);
  if (steps.length === 0) return { vertex: index };
  return steps.length === 2 ? { face: index, weights: [a, b, c] } : { tetrahedron: index, weights: [a, b, c, d] };
}
