/** The place of a surface that is nearest to a point of space. */
import type { DrawMesh, DrawTransform, MeshPoint } from '../protocol';
import { cornersOf, dot, minus, type Triangle, type Vector, vectorAt, weighted } from '../state/vector';
import { entry } from '../state/entry';

/** Triangles of a leaf of the hierarchy, see `bake::hierarchy::LEAF`. */
const LEAF = 8;
/** A corner whose weight misses 1 by less than the digits of single precision is meant itself. */
const AT_CORNER = 1 - 1e-5;

export interface Nearest {
  point: MeshPoint;
  /** How far away it is, as it is drawn. */
  away: number;
}

/** Of a surface as it is drawn; the point as well. `inputVertices`: of its drawn vertices. */
export function nearestPlace(surface: DrawMesh, inputVertices: Uint32Array, point: Vector): Nearest {
  const { positions, triangles, order, boxes } = surface;
  const inner = Math.floor(boxes.length / 12);
  let best = { square: Infinity, face: 0, weights: [1, 0, 0] as Vector };
  const waiting: (readonly [node: number, square: number])[] = [[0, 0]];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const [node, square] = next;
    if (square >= best.square) continue;
    if (node >= inner) {
      const first = LEAF * (node - inner);
      for (const face of order.subarray(first, first + LEAF)) {
        const corners = cornersOf(positions, triangles, face);
        const weights = nearestWeights(point, corners);
        const away = squareBetween(point, weighted(corners, weights));
        if (away < best.square) best = { square: away, face, weights };
      }
    } else {
      const children = [2 * node + 1, 2 * node + 2].map((child) => [child, squareTo(boxes, child, point)] as const);
      // What is nearer is looked at first, so last in.
      waiting.push(...children.toSorted((one, other) => other[1] - one[1]));
    }
  }
  const { face, weights, square } = best;
  const corner = weights.findIndex((weight) => weight > AT_CORNER);
  const at: MeshPoint =
    corner < 0 ? { face, weights } : { vertex: entry(inputVertices, entry(triangles, 3 * face + corner)) };
  return { point: at, away: Math.sqrt(square) };
}

/** From the unit and the axes of the file to what is drawn; see `DrawTransform`. */
export function drawnPlace([x, y, z]: Vector, { center, scale, up }: DrawTransform): Vector {
  const [a, b, c] = [scale * (x - center[0]), scale * (y - center[1]), scale * (z - center[2])];
  switch (up) {
    case 'y':
      return [a, b, c];
    case 'z':
      return [a, c, -b];
    case 'x':
      return [-b, a, c];
    case '-y':
      return [a, -b, -c];
    case '-z':
      return [a, -c, b];
    case '-x':
      return [b, -a, c];
  }
}

/** The other way round. */
export function filePlace([x, y, z]: Vector, { center, scale, up }: DrawTransform): Vector {
  const turned = (): Vector => {
    switch (up) {
      case 'y':
        return [x, y, z];
      case 'z':
        return [x, -z, y];
      case 'x':
        return [y, -x, z];
      case '-y':
        return [x, -y, -z];
      case '-z':
        return [x, z, -y];
      case '-x':
        return [-y, x, z];
    }
  };
  const [a, b, c] = turned();
  return [a / scale + center[0], b / scale + center[1], c / scale + center[2]];
}

/**
 * Weights of the point of a triangle that is nearest to another one, by the region of the plane that it is seen from: Ericson,
 * "Real-Time Collision Detection", 2005, section 5.1.5.
 */
function nearestWeights(p: Vector, [a, b, c]: Triangle): Vector {
  const [ab, ac] = [minus(b, a), minus(c, a)];
  const [ap, bp, cp] = [minus(p, a), minus(p, b), minus(p, c)];
  const [d1, d2] = [dot(ab, ap), dot(ac, ap)];
  if (d1 <= 0 && d2 <= 0) return [1, 0, 0];
  const [d3, d4] = [dot(ab, bp), dot(ac, bp)];
  if (d3 >= 0 && d4 <= d3) return [0, 1, 0];
  const [d5, d6] = [dot(ab, cp), dot(ac, cp)];
  if (d6 >= 0 && d5 <= d6) return [0, 0, 1];
  const [va, vb, vc] = [d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2];
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return along(d1, d1 - d3, (share) => [1 - share, share, 0]);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return along(d2, d2 - d6, (share) => [1 - share, 0, share]);
  const [toC, toB] = [d4 - d3, d5 - d6];
  if (va <= 0 && toC >= 0 && toB >= 0) return along(toC, toC + toB, (share) => [0, 1 - share, share]);
  const all = va + vb + vc;
  return [va / all, vb / all, vc / all];
}

/** On an edge; an edge without length has one point. */
function along(part: number, whole: number, weights: (share: number) => Vector): Vector {
  return weights(whole > 0 ? part / whole : 0);
}

function beyond(at: number, least: number, most: number): number {
  return Math.max(least - at, 0, at - most) ** 2;
}

/** Of the distance to a box. */
function squareTo(boxes: Float32Array, node: number, point: Vector): number {
  const [low, high] = [vectorAt(boxes, 2 * node), vectorAt(boxes, 2 * node + 1)];
  const [x, y, z] = point;
  return beyond(x, low[0], high[0]) + beyond(y, low[1], high[1]) + beyond(z, low[2], high[2]);
}

function squareBetween(a: Vector, b: Vector): number {
  const away = minus(a, b);
  return dot(away, away);
}
