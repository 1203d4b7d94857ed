/** What distance is measured from: single places, and sets of places that are one entry of the list of sources. */
import type { MeshPoint, Source } from '../protocol';

/**
 * What a set is. `line`: along edges through `corners`, vertices of the input; `stroke`: a curve drawn by hand; both back to their
 * beginning where they are `closed`. `boundary`: the boundary loop through a vertex; `component`: the connected component of a vertex;
 * `part`: of the file, by its index. `list`: given as numbers, by the file's name.
 */
export type SetShape =
  | { readonly kind: 'line'; readonly corners: readonly number[]; readonly closed: boolean }
  | { readonly kind: 'stroke'; readonly closed: boolean }
  | { readonly kind: 'boundary'; readonly vertex: number }
  | { readonly kind: 'component'; readonly vertex: number }
  | { readonly kind: 'part'; readonly part: number }
  | { readonly kind: 'list'; readonly name: string };

/** Many sources together. */
export interface SourceSet {
  readonly shape: SetShape;
  /**
   * Its places, in order where there is one. What `shape` leaves open, as of strokes and lists; else found on the mesh when it is
   * opened, and empty before.
   */
  readonly points: readonly Source[];
  /** Initial distance of all of them, beside their own; in the unit of the file. */
  readonly offset: number;
}

/** A vertex that a line along edges was led through. */
export interface Corner {
  readonly set: SourceSet;
  /** Its number among the corners. */
  readonly place: number;
  readonly vertex: number;
}

/** What a scene has whose sources are still to be chosen, and not none: those of a file that no link says anything of. */
export const UNCHOSEN: readonly Source[] = [];

/** Sources of a scene at most, those of all its sets together: more is no list of sources but a field. */
export const MOST_POINTS = 100_000;
/** Sets of a scene at most. */
export const MOST_SETS = 1000;

interface Both {
  sources: readonly Source[];
  sets: readonly SourceSet[];
}

const JOINED = new WeakMap<readonly SourceSet[], { sources: readonly Source[]; all: readonly Source[] }>();

/** All sources of a scene, one by one: the same array for the same scene, which tells answers apart. */
export function allSources({ sources, sets }: Both): readonly Source[] {
  if (sets.length === 0) return sources;
  const known = JOINED.get(sets);
  if (known?.sources === sources) return known.all;
  const all = [...sources];
  for (const { points, offset } of sets) {
    for (const point of points) all.push(offset > 0 ? withOffset(point, offset + (point.offset ?? 0)) : point);
  }
  JOINED.set(sets, { sources, all });
  return all;
}

/** A source at a place. An initial distance of 0 is not written, so that equal sources are equal objects. */
export function withOffset(point: MeshPoint, offset: number): Source {
  const place = placeOf(point);
  return offset > 0 ? { ...place, offset } : place;
}

export function isSamePlace(one: MeshPoint, other: MeshPoint): boolean {
  return keyOf(one) === keyOf(other);
}

/** A place that is there more than once is one source, where it comes first, with the least of its initial distances. */
export function onceEach(sources: readonly Source[]): readonly Source[] {
  const once: Source[] = [];
  const places = new Map<string, number>();
  for (const source of sources) {
    const key = keyOf(source);
    const place = places.get(key) ?? once.length;
    places.set(key, place);
    const before = once[place];
    if (!before || (source.offset ?? 0) < (before.offset ?? 0)) once[place] = source;
  }
  return once;
}

/** The same of equal places of a mesh. */
function keyOf(point: MeshPoint): string {
  return [indexOf(point), ...('weights' in point ? point.weights : [])].join();
}

/** Without what else there may be. */
function placeOf(point: MeshPoint): MeshPoint {
  if ('vertex' in point) return { vertex: point.vertex };
  if ('face' in point) return { face: point.face, weights: point.weights };
  return { tetrahedron: point.tetrahedron, weights: point.weights };
}

/** The number of the vertex, face or tetrahedron of a place. */
export function indexOf(point: MeshPoint): number {
  if ('vertex' in point) return point.vertex;
  return 'face' in point ? point.face : point.tetrahedron;
}

/** How many places a set has; of one whose places a mesh has still to tell, how many are given. */
export function placesOf({ shape, points }: SourceSet): number {
  return Math.max(points.length, shape.kind === 'line' ? shape.corners.length : 1);
}

/** Whether places of a set are joined one to the next. */
export function isCurve({ shape, points }: SourceSet): boolean {
  return points.length > 1 && (shape.kind === 'line' || shape.kind === 'stroke' || shape.kind === 'boundary');
}

/** Whether a curve comes back to its beginning. */
export function isClosed({ shape }: SourceSet): boolean {
  return shape.kind === 'boundary' || ('closed' in shape && shape.closed);
}
