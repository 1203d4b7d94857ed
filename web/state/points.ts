/** Places on a mesh as text in a link: an index, with weights where it is that of a face or a tetrahedron. */
import type { MeshPoint, Source } from '../protocol';
import { indexOf, MOST_POINTS, onceEach, withOffset } from './sources';
import { amount, type Codec, COUNT, listOf, number, parseAmount } from './text';

/** The digits of a link are rounded, so that weights may miss a sum of 1 by a little. */
const WEIGHTS_SUM = 0.01;
/** By rounding alone they miss it by no more. */
const ROUNDING = 1e-12;

export const POINT: Codec<MeshPoint> = {
  encode: (point) => {
    const index = String(indexOf(point));
    return 'vertex' in point ? index : `${index}:${shares(point.weights).join('/')}`;
  },
  parse: (text) => {
    const [place = '', own, ...more] = text.split(':');
    const index = COUNT.parse(place);
    if (index === undefined || more.length > 0) return undefined;
    return own === undefined ? { vertex: index } : weighted(index, own);
  },
};

/** Rounded so that they sum to 1: the largest takes what the others miss. Whoever reads them writes the same again. */
function shares(weights: readonly number[]): string[] {
  const largest = weights.indexOf(Math.max(...weights));
  const rest = weights.reduce((sum, weight, i) => (i === largest ? sum : sum + Number(number(weight))), 0);
  return weights.map((weight, i) => number(i === largest ? 1 - rest : weight));
}

/** A face has three weights, a tetrahedron four. */
function weighted(index: number, text: string): MeshPoint | undefined {
  if (!/^[\d.]+(\/[\d.]+){2,3}$/.test(text)) return undefined;
  const weights = text.split('/').map(Number);
  const sum = weights.reduce((all, weight) => all + weight, 0);
  const miss = Math.abs(sum - 1);
  if (!(miss < WEIGHTS_SUM)) return undefined;
  const [a = 0, b = 0, c = 0, d] = weights.map((weight) => (miss < ROUNDING ? weight : weight / sum));
  return d === undefined ? { face: index, weights: [a, b, c] } : { tetrahedron: index, weights: [a, b, c, d] };
}

/** A place, and after `@` the initial distance there. */
const SOURCE: Codec<Source> = {
  encode: (source) => POINT.encode(source) + (source.offset ? `@${amount(source.offset)}` : ''),
  parse: (text) => {
    const [place = '', start, ...more] = text.split('@');
    const point = POINT.parse(place);
    const offset = start === undefined ? 0 : parseAmount(start);
    return point && offset !== undefined && more.length === 0 ? withOffset(point, offset) : undefined;
  },
};

export const POINTS = listOf(POINT, MOST_POINTS);
const LISTED = listOf(SOURCE, MOST_POINTS);

export const SOURCES: Codec<readonly Source[]> = {
  encode: LISTED.encode,
  parse: (text) => {
    const sources = LISTED.parse(text);
    return sources && onceEach(sources);
  },
};
