/** Legs of tapes as polylines. */
import type { Leg, MeshPoint, SurfaceLeg } from '../../protocol';
import type { Places } from '../../state/places';
import { type Vector, between, distance } from '../../state/vector';

/** A leg as it is drawn. */
export function polylineOf(leg: Leg, places: Places): Vector[] {
  if ('triangles' in leg) return positionsOf(pointsOf(leg), places);
  const { points } = leg;
  return Array.from({ length: points.length / 3 }, (_, i) => [points[3 * i], points[3 * i + 1], points[3 * i + 2]]);
}

/** The places that a leg leads through. */
export function pointsOf({ triangles, weights }: SurfaceLeg): MeshPoint[] {
  return Array.from(triangles, (face, i): MeshPoint => {
    return { face, weights: [weights[3 * i], weights[3 * i + 1], weights[3 * i + 2]] };
  });
}

/** Where places are drawn. */
export function positionsOf(points: readonly MeshPoint[], places: Places): Vector[] {
  return points.map((point) => places.at(point)?.position).filter((position) => position !== undefined);
}

/** How far each point of a polyline is from its first, along it. */
export function arcsOf(polyline: readonly Vector[]): number[] {
  let arc = 0;
  return polyline.map((point, index) => (arc += index > 0 ? distance(polyline[index - 1], point) : 0));
}

/** The point half way along a polyline; null for none. */
export function middleOf(polyline: readonly Vector[]): Vector | null {
  const arcs = arcsOf(polyline);
  const half = (arcs.at(-1) ?? 0) / 2;
  const next = arcs.findIndex((arc) => arc >= half && arc > 0);
  if (next < 1) return polyline[0] ?? null;
  const share = (half - arcs[next - 1]) / (arcs[next] - arcs[next - 1]);
  const [from, to] = [polyline[next - 1], polyline[next]];
  return between(from, to, share);
}
