/**
 * How errors fall with the edges. Each triangle split in four at the middles of its edges leaves the surface as it is, and with it the
 * exact distance, so that the length of the edges is all that changes.
 */
import { headOf, type LengthUnit, type ModelLength, told } from '../length';
import type { FieldError, OpenedMesh, Source } from '../protocol';
import { markdownTable } from './markdown';
import { entry } from './entry';
import { between, type Vector, vectorAt } from './vector';

/** Exact distances take more than their share of time on larger ones. */
export const MOST_TRIANGLES = 200_000;
const MOST_LEVELS = 3;

/** A surface with its sources, whose vertices and triangles are counted as they stand here. */
export interface Studied {
  positions: Float32Array;
  triangles: Uint32Array;
  sources: readonly Source[];
}

/** What is measured of one surface: `edge` is the mean length. */
export interface Level {
  triangles: number;
  edge: ModelLength;
  heat: FieldError;
  propagation: FieldError;
}

/** How many surfaces there are to measure: that of `triangles` and those that it is split into. */
export function levelsOf(triangles: number): number {
  const levels = Math.floor(Math.log(MOST_TRIANGLES / triangles) / Math.log(4)) + 1;
  return Math.min(MOST_LEVELS, Math.max(0, levels));
}

/** The surface that is drawn, with sources of the scene. Initial distances are in the unit of the file. */
export function studied(
  { surface, inputVertices, drawTransform }: Pick<OpenedMesh, 'surface' | 'inputVertices' | 'drawTransform'>,
  sources: readonly Source[],
): Studied {
  const { positions, triangles } = surface;
  const drawn = new Map(Array.from(inputVertices, (vertex, index) => [vertex, index] as const));
  const placed = sources.flatMap((source): Source[] => {
    const offset = drawTransform.scale * (source.offset ?? 0);
    if (!('vertex' in source)) return [{ ...source, offset }];
    const vertex = drawn.get(source.vertex);
    return vertex === undefined ? [] : [{ vertex, offset }];
  });
  return { positions, triangles, sources: placed };
}

/** Triangle f becomes those from 4 f on: one at each of its corners, and the one in the middle. */
export function split({ positions, triangles, sources }: Studied): Studied {
  const places = Array.from(positions);
  const middles = new Map<number, number>();
  const vertices = positions.length / 3;
  const middle = (a: number, b: number): number => {
    const key = Math.min(a, b) * vertices + Math.max(a, b);
    const known = middles.get(key);
    if (known !== undefined) return known;
    const made = places.length / 3;
    places.push(...between(vectorAt(positions, a), vectorAt(positions, b), 0.5));
    middles.set(key, made);
    return made;
  };
  const smaller = new Uint32Array(4 * triangles.length);
  for (let face = 0; 3 * face < triangles.length; face++) {
    const [a, b, c] = vectorAt(triangles, face);
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    smaller.set([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca], 12 * face);
  }
  return { positions: Float32Array.from(places), triangles: smaller, sources: sources.map(within) };
}

/** A source inside of a triangle, in one of the four that come of it. */
function within(source: Source): Source {
  if (!('face' in source)) return source;
  const { face, weights } = source;
  const [u, v, w] = weights;
  const corner = weights.findIndex((weight) => weight > 0.5);
  if (corner < 0) {
    // Rounded, what is on its side may be beyond it.
    const middle: Vector = [Math.max(0, u + v - w), Math.max(0, v + w - u), Math.max(0, w + u - v)];
    return { ...source, face: 4 * face + 3, weights: middle };
  }
  const inside: Vector = [2 * u, 2 * v, 2 * w];
  inside[corner] = 2 * entry(weights, corner) - 1;
  return { ...source, face: 4 * face + corner, weights: inside };
}

/**
 * The power of the edge length that an error falls with: the slope of the line of least squares between logarithms. Null where fewer than two
 * surfaces have an error.
 */
export function slopeOf(levels: readonly Level[], errorOf: (level: Level) => number): number | null {
  const points = levels
    .filter((level) => errorOf(level) > 0)
    .map((level) => ({ edge: Math.log(level.edge), error: Math.log(errorOf(level)) }));
  if (points.length < 2) return null;
  const x = points.reduce((sum, { edge }) => sum + edge, 0) / points.length;
  const y = points.reduce((sum, { error }) => sum + error, 0) / points.length;
  const spread = points.reduce((sum, { edge }) => sum + (edge - x) ** 2, 0);
  return points.reduce((sum, { edge, error }) => sum + (edge - x) * (error - y), 0) / spread;
}

const ERRORS: readonly (readonly [string, (level: Level) => number])[] = [
  ['Heat, mean (%)', ({ heat }) => heat.mean],
  ['Heat, maximum (%)', ({ heat }) => heat.max],
  ['Propagation, mean (%)', ({ propagation }) => propagation.mean],
  ['Propagation, maximum (%)', ({ propagation }) => propagation.max],
];

/** A line a surface, and one of slopes. */
export function markdownOf(levels: readonly Level[], unit: LengthUnit): string {
  const rows = levels.map((level) => [
    String(level.triangles),
    told(level.edge, unit).toPrecision(4),
    ...ERRORS.map(([, errorOf]) => (100 * errorOf(level)).toPrecision(3)),
  ]);
  const slopes = ERRORS.map(([, errorOf]) => slopeOf(levels, errorOf)?.toFixed(2) ?? '–');
  return markdownTable(
    ['Triangles', headOf(['Mean edge'], unit), ...ERRORS.map(([name]) => name)],
    [...rows, ['Slope', '', ...slopes]],
  );
}
