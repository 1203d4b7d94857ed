/** Boundary loops, components and parts of a surface, by the triangles beside each triangle. */
import type { OpenedMesh } from '../protocol';
import { partsOfFaces } from '../state/parts';
import { type Vector, distance, vectorAt } from '../state/vector';
import { entry } from '../state/entry';

/** A surface as it is drawn, and the triangles beside each: `Queries.neighbors`. */
export interface Outlined extends Pick<OpenedMesh, 'parts' | 'active' | 'inputVertices'> {
  surface: Pick<OpenedMesh['surface'], 'positions' | 'triangles'>;
  neighbors: Uint32Array;
}

/** An edge of a triangle, from the corner of this number to the next one. */
interface Side {
  face: number;
  edge: number;
}

/** The vertex on a boundary that is nearest to a place; null where there is no boundary. */
export function boundaryNear(mesh: Outlined, place: Vector): number | null {
  let best: number | null = null;
  let nearest = Infinity;
  for (const { face, edge } of boundarySides(mesh)) {
    const away = distance(positionOf(mesh, face, edge), place);
    if (away >= nearest) continue;
    nearest = away;
    best = vertexOf(mesh, face, edge);
  }
  return best;
}

/** The vertices of the boundary loop through a vertex of the input, in order; empty where none leads through it. */
export function boundaryThrough(mesh: Outlined, vertex: number): number[] {
  for (const side of boundarySides(mesh)) {
    if (vertexOf(mesh, side.face, side.edge) === vertex) return loopFrom(mesh, side);
  }
  return [];
}

/** The vertices of the component of a vertex of the input; empty where no triangle has it. */
export function componentOf(mesh: Outlined, vertex: number): number[] {
  const { triangles } = mesh.surface;
  const corner = triangles.findIndex((drawn) => mesh.inputVertices[drawn] === vertex);
  return corner < 0 ? [] : flood(mesh, Math.floor(corner / 3), new Uint8Array(triangles.length / 3));
}

/** The part that a triangle belongs to; null where one is active, or triangles of the file were removed. */
export function partOf(mesh: Outlined, face: number): number | null {
  return mesh.active.length > 1 ? (partsOfFaces(mesh)?.at(face) ?? null) : null;
}

/** The vertices of a part; empty where it is not known. */
export function verticesOfPart(mesh: Outlined, part: number): number[] {
  const partOfFace = partsOfFaces(mesh);
  if (!partOfFace) return [];
  const seen = Uint8Array.from(partOfFace, (other) => (other === part ? 0 : 1));
  const found: number[] = [];
  for (let face = seen.indexOf(0); face >= 0; face = seen.indexOf(0, face + 1)) found.push(...flood(mesh, face, seen));
  return [...new Set(found)];
}

function* boundarySides({ neighbors }: Outlined): Generator<Side> {
  for (let i = 0; i < neighbors.length; i++) {
    const face = Math.floor(i / 3);
    if (neighbors[i] === face) yield { face, edge: i % 3 };
  }
}

/** From the end of each side around that vertex to the next side on the boundary. */
function loopFrom(mesh: Outlined, start: Side): number[] {
  const found: number[] = [];
  const seen = new Set<number>();
  let side = start;
  let corner = start.edge;
  for (;;) {
    const key = 3 * side.face + side.edge;
    if (seen.has(key)) return found;
    seen.add(key);
    found.push(vertexOf(mesh, side.face, corner));
    const far = otherEnd(side.edge, corner);
    const next = around(mesh, side, far);
    if (!next) return found;
    [side, corner] = [next.side, next.corner];
  }
}

/** The next side on the boundary around a corner of a triangle, and that corner there; null where there is none. */
function around(mesh: Outlined, { face, edge }: Side, corner: number): { side: Side; corner: number } | null {
  let at = { face, edge, corner };
  // Around a vertex there are no more triangles than there are.
  for (let steps = mesh.neighbors.length / 3; steps > 0; steps--) {
    // Of the two sides at a corner, the other one: they are numbered as the corner is, and as the one before.
    const other = at.edge === at.corner ? (at.corner + 2) % 3 : at.corner;
    const next = entry(mesh.neighbors, 3 * at.face + other);
    if (next === at.face) return { side: { face: at.face, edge: other }, corner: at.corner };
    at = across(mesh, { face: at.face, edge: other }, at.corner, next);
  }
  return null;
}

/** The same side and corner as the next triangle numbers them: by where they are, since triangles may be turned over. */
function across(mesh: Outlined, { face, edge }: Side, corner: number, next: number): Side & { corner: number } {
  const here = positionOf(mesh, face, corner);
  const there = positionOf(mesh, face, otherEnd(edge, corner));
  let best = { face: next, edge: 0, corner: 0 };
  let nearest = Infinity;
  for (const [k, end, side] of SIDES) {
    const off = distance(positionOf(mesh, next, k), here) + distance(positionOf(mesh, next, end), there);
    if (off >= nearest) continue;
    nearest = off;
    best = { face: next, edge: side, corner: k };
  }
  return best;
}

/** Each corner with each other one, and the side between them. */
const SIDES = [0, 1, 2].flatMap((k) => [[k, (k + 1) % 3, k] as const, [(k + 1) % 3, k, k] as const]);

function otherEnd(edge: number, corner: number): number {
  return corner === edge ? (edge + 1) % 3 : edge;
}

/** Vertices of the triangles that are joined to one and not `seen` yet; of several vertices of the input at one place, one. */
function flood(mesh: Outlined, face: number, seen: Uint8Array): number[] {
  const found = new Map<string, number>();
  const waiting = [face];
  seen[face] = 1;
  for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
    for (let k = 0; k < 3; k++) {
      const place = positionOf(mesh, next, k).join();
      if (!found.has(place)) found.set(place, vertexOf(mesh, next, k));
      const other = entry(mesh.neighbors, 3 * next + k);
      if (seen[other] === 1) continue;
      seen[other] = 1;
      waiting.push(other);
    }
  }
  return [...found.values()];
}

function vertexOf({ surface, inputVertices }: Outlined, face: number, corner: number): number {
  return entry(inputVertices, entry(surface.triangles, 3 * face + corner));
}

function positionOf({ surface }: Outlined, face: number, corner: number): Vector {
  return vectorAt(surface.positions, entry(surface.triangles, 3 * face + corner));
}
