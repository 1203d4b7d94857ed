/** How a field is distributed over the surface, and how far it was off by distance. */

import { entry } from './entry';
import { areaOfTriangle, cornersOf, vectorAt } from './vector';

/** Triangles with a value at each corner. */
export interface Values {
  /** #D × 3. */
  positions: Float32Array;
  /** #F × 3. */
  triangles: Uint32Array;
  /** One a drawn vertex; one a corner where `byCorner`. Infinity where no source reaches. */
  distance: Float32Array;
  byCorner: boolean;
}

export interface Distribution {
  /** Borders of the bins, from 0 to the largest value. */
  edges: Float64Array;
  /** Share of the reached area with a value below each border, 0 to 1. */
  below: Float64Array;
  /** Share of the whole area that no source reaches. */
  unreached: number;
}

/** Exact for values that are linear over each triangle. */
export function distributionOf({ positions, triangles, distance, byCorner }: Values, bins: number): Distribution {
  const whole = largest(distance);
  const edges = Float64Array.from({ length: bins + 1 }, (_, index) => (whole * index) / bins);
  const partly = new Float64Array(bins + 1);
  /** Area that is below an edge and all after it. */
  const wholly = new Float64Array(bins + 2);
  let [reached, unreached] = [0, 0];
  for (let face = 0; 3 * face < triangles.length; face++) {
    const area = areaOfTriangle(cornersOf(positions, triangles, face));
    const [a, b, c] = byCorner ? [3 * face, 3 * face + 1, 3 * face + 2] : vectorAt(triangles, face);
    const [p, q, r] = [entry(distance, a), entry(distance, b), entry(distance, c)];
    const [least, most] = [Math.min(p, q, r), Math.max(p, q, r)];
    if (most === Infinity) {
      unreached += area;
      continue;
    }
    reached += area;
    const middle = Math.max(Math.min(p, q), Math.min(Math.max(p, q), r));
    let index = whole > 0 ? Math.min(bins, Math.max(0, Math.ceil((least / whole) * bins))) : 0;
    for (; index <= bins; index++) {
      const edge = entry(edges, index);
      if (edge >= most) break;
      partly[index] = entry(partly, index) + area * shareBelow(least, middle, most, edge);
    }
    wholly[index] = entry(wholly, index) + area;
  }
  let sum = 0;
  const below = partly.map((area, edge) => {
    sum += entry(wholly, edge);
    return reached > 0 ? (sum + area) / reached : 0;
  });
  // The largest value itself belongs to the last bin; rounding may miss it.
  below[bins] = reached > 0 ? 1 : 0;
  return { edges, below, unreached: reached + unreached > 0 ? unreached / (reached + unreached) : 0 };
}

/** The share of a triangle with corner values in order that is below a value between them. */
function shareBelow(a: number, b: number, c: number, value: number): number {
  if (value <= a) return 0;
  if (value < b) return (value - a) ** 2 / ((b - a) * (c - a));
  return 1 - (c - value) ** 2 / ((c - a) * (c - b));
}

export interface ErrorByDistance {
  /** The middle of each bin that has vertices. */
  distance: number[];
  /** Relative to the exact distance. */
  mean: number[];
  most: number[];
}

/** `errors`, relative ones: one a value of `distance`. */
export function errorsByDistance(errors: Float32Array, distance: Float32Array, bins: number): ErrorByDistance {
  const whole = largest(distance);
  const sums = Array.from({ length: bins }, () => ({ count: 0, sum: 0, most: 0 }));
  errors.forEach((error, index) => {
    const value = entry(distance, index);
    if (!(value > 0 && value < Infinity)) return;
    const bin = entry(sums, Math.min(bins - 1, Math.floor((value / whole) * bins)));
    bin.count += 1;
    bin.sum += error;
    bin.most = Math.max(bin.most, error);
  });
  const filled = sums.flatMap((bin, index) => (bin.count > 0 ? [{ bin, at: ((index + 0.5) / bins) * whole }] : []));
  return {
    distance: filled.map(({ at }) => at),
    mean: filled.map(({ bin }) => bin.sum / bin.count),
    most: filled.map(({ bin }) => bin.most),
  };
}

function largest(values: Float32Array): number {
  return values.reduce((most, value) => (value > most && value < Infinity ? value : most), 0);
}
