/** The surface cut straight from one place to another. */
import type { MeshPoint, OpenedMesh } from '../../protocol';
import type { Places } from '../../state/places';
import { between, cornersOf, cross, distance, dot, minus, moved, type Vector, vectorAt } from '../../state/vector';
import { arcsOf } from '../measure/curves';
import { entry } from '../../state/entry';

export interface Cut {
  /** From the first place to the second. */
  points: readonly MeshPoint[];
  /** Of each point from the first, along the cut, as it is drawn. */
  arcs: readonly number[];
}

/** A surface as it is drawn, and the triangles beside each: `Queries.neighbors`. */
export interface CutSurface {
  surface: Pick<OpenedMesh['surface'], 'triangles'>;
  neighbors: Uint32Array;
}

type PlacesOn = Pick<Places, 'at' | 'positions'>;

/** Where the plane crosses the side of a triangle from a corner to the next one. */
interface Crossing {
  face: number;
  side: number;
  point: MeshPoint;
  position: Vector;
}

/**
 * Follows the plane through two places and the mean of the normals there, from triangle to triangle; the shorter way where both lead there.
 * Null where neither does: at boundaries, between components, and where the places coincide.
 */
export function straightCut(mesh: CutSurface, places: PlacesOn, from: MeshPoint, to: MeshPoint): Cut | null {
  const [start, end] = [places.at(from), places.at(to)];
  if (!start || !end) return null;
  const along = minus(end.position, start.position);
  const across = cross(along, moved(start.normal, end.normal, 1));
  if (!(Math.hypot(...across) > 0)) return null;
  const height = (position: Vector) => dot(across, minus(position, start.position));
  const goals = new Set(facesAt(mesh, places, to));
  let best: Cut | null = null;
  for (const face of facesAt(mesh, places, from)) {
    for (const exit of crossingsOf(mesh, places, face, height)) {
      const crossings = walk(mesh, places, height, face, exit, goals);
      if (!crossings) continue;
      const points = [from, ...crossings.map(({ point }) => point), to];
      const arcs = arcsOf([start.position, ...crossings.map(({ position }) => position), end.position]);
      if (!best || lengthOf(arcs) < lengthOf(best.arcs)) best = { points, arcs };
    }
  }
  return best;
}

function lengthOf(arcs: readonly number[]): number {
  return arcs.at(-1) ?? 0;
}

/** From triangle to triangle through `exit`, until one that is a goal; null where the surface ends before, and back at the beginning. */
function walk(
  mesh: CutSurface,
  places: PlacesOn,
  height: (position: Vector) => number,
  start: number,
  exit: Crossing,
  goals: ReadonlySet<number>,
): Crossing[] | null {
  const crossings: Crossing[] = [];
  let last = exit;
  while (!goals.has(last.face)) {
    crossings.push(last);
    const face = entry(mesh.neighbors, 3 * last.face + last.side);
    if (face === last.face || face === start) return null;
    if (goals.has(face)) return crossings;
    const [one, other] = crossingsOf(mesh, places, face, height);
    if (!one || !other) return null;
    last = isEntry(mesh, one, other, last) ? other : one;
  }
  return crossings;
}

/** Whether the cut comes in by `one` of both crossings, and not by the `other`, where it has left the triangle before. */
function isEntry({ neighbors }: CutSurface, one: Crossing, other: Crossing, before: Crossing): boolean {
  const leads = ({ face, side }: Crossing) => neighbors[3 * face + side] === before.face;
  if (leads(one) !== leads(other)) return leads(one);
  return distance(one.position, before.position) <= distance(other.position, before.position);
}

/** Where the plane leads through a triangle: two crossings, or none. */
function crossingsOf(
  { surface: { triangles } }: CutSurface,
  { positions }: PlacesOn,
  face: number,
  height: (position: Vector) => number,
): Crossing[] {
  const corners = cornersOf(positions, triangles, face);
  return corners.flatMap((from, side) => {
    const next = (side + 1) % 3;
    const to = entry(corners, next);
    const [h0, h1] = [height(from), height(to)];
    if (h0 < 0 === h1 < 0) return [];
    const share = h0 / (h0 - h1);
    const weights: Vector = [0, 0, 0];
    [weights[side], weights[next]] = [1 - share, share];
    const position = between(from, to, share);
    return [{ face, side, point: { face, weights }, position }];
  });
}

/** The triangles at a place, of a vertex those all around. */
function facesAt({ surface: { triangles } }: CutSurface, places: PlacesOn, point: MeshPoint): number[] {
  if ('face' in point) return [point.face];
  const place = places.at(point)?.position;
  const faces: number[] = [];
  // A vertex on a seam is drawn more than once, at one place.
  triangles.forEach((vertex, corner) => {
    if (place && vectorAt(places.positions, vertex).every((x, axis) => x === place[axis])) {
      faces.push(Math.floor(corner / 3));
    }
  });
  return faces;
}
