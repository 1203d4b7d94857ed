/** Exact distances within the triangles of a coarse surface, which is drawn finer; loaded with the first of these. */
import { ofModel } from '../../length';
import type { DistanceField, FinerPlaces, TrianglePlaces } from '../../protocol';
import type * as wasm from '../../wasm/solver/heatwalk_worker';

/** The most that these may take of an answer, and of a move of the pointer. */
const MOST_MS = 200;
const QUICK_MS = 15;
/** Places that are asked for at once at first; each time twice as many. */
const FIRST = 16;

/** Finds the distances of a field at places, where they are known; while the pointer drags (`quick`), where that takes little time. */
export type Between = (field: DistanceField, surface: wasm.Solver | null, quick: boolean) => DistanceField['finer'];

export function distancesAt({ middles, corners, ofCorners }: FinerPlaces): Between {
  let took = 0;
  return ({ distance, byCorner, exactBelow, maxDistance }, surface, quick) => {
    if (!surface || exactBelow < Infinity || (quick && took > QUICK_MS)) return undefined;
    if (took > MOST_MS) {
      // Another field may be found sooner.
      took /= 2;
      return undefined;
    }
    const begun = performance.now();
    const found = asked(surface, byCorner ? corners : middles, begun + MOST_MS);
    took = performance.now() - begun;
    if (!found) return undefined;
    const largest = found.reduce((most, value) => (value < Infinity ? Math.max(most, value) : most), maxDistance);
    const values = byCorner
      ? Float32Array.from(ofCorners, (place) => found[place] ?? Infinity)
      : joined(distance, found);
    return { distance: values, maxDistance: ofModel(largest) };
  };
}

function joined(first: Float32Array, second: Float64Array): Float32Array {
  const all = new Float32Array(first.length + second.length);
  all.set(first);
  all.set(second, first.length);
  return all;
}

/** Distances at places; none where they are not known, and when there is no more time. */
function asked(surface: wasm.Solver, { triangles, weights }: TrianglePlaces, end: number): Float64Array | undefined {
  const all = new Float64Array(triangles.length);
  for (let from = 0, count = FIRST; from < all.length; from += count, count *= 2) {
    const to = from + count;
    const found = surface.exact_distances_in(triangles.subarray(from, to), weights.subarray(3 * from, 3 * to));
    if (!found || performance.now() > end) return undefined;
    all.set(found, from);
  }
  return all;
}
