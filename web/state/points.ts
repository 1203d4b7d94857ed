/** Places on a mesh as text in a link: an index, with weights where it is that of a face or a tetrahedron. */
import type { MeshPoint, Source } from '../protocol';
import { indexOf, MOST_POINTS, onceEach, withOffset } from './sources';
import { amount, type Codec, COUNT, listOf, number, parseAmount } from './text';

/** The digits of a link are rounded, so that weights may miss a sum of 1 by a little. */
const WEIGHTS_SUM = 0.01;

export const POINT: Codec<MeshPoint> = {
  encode: (point) => {
    const index = String(indexOf(point));
    return 'vertex' in point ? index : `${index}:${point.weights.map(number).join('/')}`;
  },
  parse: (text) => {
    const [place = '', shares, ...more] = text.split(':');
    const index = COUNT.parse(place);
    if (index === undefined || more.length > 0) return undefined;
    return shares === undefined ? { vertex: index } : weighted(index, shares);
  },
};

/** A face has three weights, a tetrahedron four. */
function weighted(index: number, shares: string): MeshPoint | undefined {
  if (!/^[\d.]+(\/[\d.]+){2,3}$/.test(shares)) return undefined;
  const weights = shares.split('/').map(Number);
  const sum = weights.reduce((all, weight) => all + weight, 0);
  if (!(Math.abs(sum - 1) < WEIGHTS_SUM)) return undefined;
  const [a = 0, b = 0, c = 0, d] = weights.map((weight) => weight / sum);
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
