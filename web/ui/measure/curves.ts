/** Legs of tapes as polylines. */
import type { Leg, MeshPoint, SurfaceLeg } from '../../protocol';
import type { Places } from '../../state/places';
import { between, distance, type Vector, vectorAt, vectorsIn } from '../../state/vector';
import { entry } from '../../state/entry';

/** A leg as it is drawn. */
export function polylineOf(leg: Leg, places: Places): Vector[] {
  if ('triangles' in leg) return positionsOf(pointsOf(leg), places);
  return vectorsIn(leg.points);
}

/** The places that a leg leads through. */
export function pointsOf({ triangles, weights }: SurfaceLeg): MeshPoint[] {
  return Array.from(triangles, (face, i): MeshPoint => ({ face, weights: vectorAt(weights, i) }));
}

/** Where places are drawn. */
export function positionsOf(points: readonly MeshPoint[], places: Places): Vector[] {
  return points.map((point) => places.at(point)?.position).filter((position) => position !== undefined);
}

/** How far each point of a polyline is from its first, along it. */
export function arcsOf(polyline: readonly Vector[]): number[] {
  let arc = 0;
  return polyline.map((point, index) => (arc += distance(polyline[index - 1] ?? point, point)));
}

/** The point half way along a polyline; null for none. */
export function middleOf(polyline: readonly Vector[]): Vector | null {
  const arcs = arcsOf(polyline);
  const half = (arcs.at(-1) ?? 0) / 2;
  const next = arcs.findIndex((arc) => arc >= half && arc > 0);
  if (next < 1) return polyline[0] ?? null;
  const [before, after] = [entry(arcs, next - 1), entry(arcs, next)];
  return between(entry(polyline, next - 1), entry(polyline, next), (half - before) / (after - before));
}
