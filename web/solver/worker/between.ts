/** Exact distances within the triangles of a coarse surface, which is drawn finer; loaded with the first of these. */
import { ofModel } from '../../length';
import type { DistanceField, TrianglePlaces } from '../../protocol';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { stopwatch } from './clock';

/** The most that these may take of a move of the pointer. */
const QUICK_MS = 15;

/** Finds the distances of a field at places, where they are known; while the pointer drags (`quick`), where that takes little time. */
export type Between = (field: DistanceField, surface: wasm.Solver | null, quick: boolean) => DistanceField['finer'];

export function distancesAt({ triangles, weights }: TrianglePlaces): Between {
  let took = 0;
  return ({ distance, byCorner, exactBelow, maxDistance }, surface, quick) => {
    if (byCorner || exactBelow < Infinity || (quick && took > QUICK_MS)) return undefined;
    const clock = stopwatch();
    const found = surface?.exact_distances_in(triangles, weights);
    took = clock();
    if (!found) return undefined;
    const largest = found.reduce((most, value) => (value < Infinity ? Math.max(most, value) : most), maxDistance);
    const values = new Float32Array(distance.length + found.length);
    values.set(distance);
    values.set(found, distance.length);
    return { distance: values, maxDistance: ofModel(largest) };
  };
}
