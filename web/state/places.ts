/** Where surface points lie on the drawn mesh, and what holds there. */
import type { DistanceField, DrawPose, OpenedMesh, MeshPoint } from '../protocol';
import { type ModelLength, ofModel } from '../length';
import { areaOfTriangle, cornersOf, distance, moved, normalized, type Vector, vectorAt } from './vector';
import { entry } from './entry';

/** Least and greatest corner of a box. */
export type Box = readonly [Vector, Vector];

/** Position and normal as they are drawn: see `DrawTransform`. */
export interface Place {
  position: Vector;
  normal: Vector;
}

/** Values of a field. */
type Values = Pick<DistanceField, 'distance' | 'byCorner' | 'inner'>;

/** What stands inside stands upright. */
const UPWARD: Vector = [0, 1, 0];

export class Places {
  readonly #mesh: OpenedMesh;
  /** Of the drawn vertices, in the pose that is shown. */
  #pose: DrawPose;
  /** Of each input vertex one drawn vertex, −1 where none is drawn. */
  readonly #drawnOf: Int32Array;
  /** Diagonal of the bounding box, in the unit of the file. */
  readonly diameter: ModelLength;
  /** The same as it is drawn. */
  readonly drawnDiameter: number;
  /** The bounding box as it is drawn. */
  readonly box: Box;

  constructor(mesh: OpenedMesh) {
    this.#mesh = mesh;
    this.#pose = mesh.surface;
    this.#drawnOf = new Int32Array(mesh.report.inputVertices).fill(-1);
    mesh.inputVertices.forEach((vertex, drawn) => {
      this.#drawnOf[vertex] = drawn;
    });
    this.box = boxAround(mesh.surface.positions);
    this.drawnDiameter = distance(...this.box);
    this.diameter = ofModel(this.drawnDiameter / mesh.drawTransform.scale);
  }

  /** Another pose is shown. Sizes stay those of the pose in the file. */
  pose(pose: DrawPose): void {
    this.#pose = pose;
  }

  /** The corners of a place inside, vertices of the input, and their weights; null where it is none. */
  #inner(point: MeshPoint): { corners: readonly number[]; weights: readonly number[] } | null {
    const { interior } = this.#mesh;
    if (!interior || 'face' in point) return null;
    if ('vertex' in point) {
      const isThere = 3 * point.vertex + 2 < interior.positions.length;
      return isThere ? { corners: [point.vertex], weights: [1] } : null;
    }
    const corners = interior.tetrahedra.subarray(4 * point.tetrahedron, 4 * point.tetrahedron + 4);
    return corners.length === 4 ? { corners: [...corners], weights: point.weights } : null;
  }

  /** The three drawn corners and their weights; null when the surface has no such place. */
  #corners(point: MeshPoint): { corners: Vector; weights: Vector } | null {
    if ('tetrahedron' in point) return null;
    if ('vertex' in point) {
      const drawn = this.#drawnOf[point.vertex] ?? -1;
      return drawn < 0 ? null : { corners: [drawn, drawn, drawn], weights: [1, 0, 0] };
    }
    const { triangles } = this.#mesh.surface;
    if (3 * point.face + 2 >= triangles.length) return null;
    return { corners: vectorAt(triangles, point.face), weights: point.weights };
  }

  /** Drawn vertices in the pose that is shown. */
  get drawn(): DrawPose {
    return this.#pose;
  }

  /** `#D × 3`, where they are. */
  get positions(): Float32Array {
    return this.#pose.positions;
  }

  has(point: MeshPoint): boolean {
    return this.#corners(point) !== null || this.#inner(point) !== null;
  }

  at(point: MeshPoint): Place | null {
    const found = this.#corners(point);
    if (!found) {
      const inner = this.#inner(point);
      const places = this.#mesh.interior?.positions;
      return inner && places ? { position: blend(places, inner.corners, inner.weights), normal: UPWARD } : null;
    }
    const { positions, normals } = this.#pose;
    return {
      position: blend(positions, found.corners, found.weights),
      normal: normalized(blend(normals, found.corners, found.weights)),
    };
  }

  /** Linear over the triangle; Infinity as soon as one corner is out of reach; NaN where the mesh has no such place. */
  valueAt(point: MeshPoint, { distance: values, byCorner, inner }: Values): ModelLength {
    const within = inner && this.#inner(point);
    if (within) return interpolated(inner, within.corners, within.weights);
    const found = this.#corners(point);
    if (!found) return ofModel(Number.NaN);
    if (byCorner && 'vertex' in point) return this.#leastAt(point.vertex, values);
    const { weights } = found;
    const first = 'face' in point ? 3 * point.face : 0;
    const corners: readonly number[] = byCorner ? [first, first + 1, first + 2] : found.corners;
    return interpolated(values, corners, weights);
  }

  /** Whether `valueAt` is between those of corners. */
  isBetween(point: MeshPoint): boolean {
    return !('vertex' in point) && !point.weights.includes(1);
  }

  /** The least value of the corners at a vertex, which walls part. */
  #leastAt(vertex: number, values: Float32Array): ModelLength {
    const { surface, inputVertices } = this.#mesh;
    let least = Infinity;
    surface.triangles.forEach((drawn, corner) => {
      if (inputVertices[drawn] === vertex) least = Math.min(least, entry(values, corner));
    });
    return ofModel(least);
  }

  /** Of the corners of the point's triangle the nearest one in weights, as an index of the input. */
  nearestVertex(point: MeshPoint): number {
    if ('vertex' in point) return point.vertex;
    const { surface, inputVertices } = this.#mesh;
    const heaviest = point.weights.indexOf(Math.max(...point.weights));
    if ('tetrahedron' in point) return this.#inner(point)?.corners[heaviest] ?? 0;
    return entry(inputVertices, entry(surface.triangles, 3 * point.face + heaviest));
  }

  /** The vertex that lies farthest in a direction, of those that are not `left` out. */
  extreme([x, y, z]: Vector, left?: Uint8Array): MeshPoint {
    const { surface, inputVertices } = this.#mesh;
    const at = (index: number) => entry(surface.positions, index);
    const along = (vertex: number) =>
      left?.[vertex] ? Number.NEGATIVE_INFINITY : x * at(3 * vertex) + y * at(3 * vertex + 1) + z * at(3 * vertex + 2);
    const drawn = indexOfMax(inputVertices.length, along);
    return { vertex: entry(inputVertices, drawn) };
  }

  /** `#D`: a third of the areas of the triangles around each drawn vertex. */
  vertexAreas(): Float64Array {
    const { positions, triangles } = this.#mesh.surface;
    const areas = new Float64Array(positions.length / 3);
    for (let face = 0; 3 * face < triangles.length; face++) {
      const area = areaOfTriangle(cornersOf(positions, triangles, face)) / 3;
      for (const corner of vectorAt(triangles, face)) areas[corner] = (areas[corner] ?? 0) + area;
    }
    return areas;
  }

  /** The vertex with the largest finite value. */
  farthest({ distance: values, byCorner }: Values): MeshPoint {
    const best = indexOfMax(values.length, (index) => {
      const value = entry(values, index);
      return Number.isFinite(value) ? value : Number.NEGATIVE_INFINITY;
    });
    const { surface, inputVertices } = this.#mesh;
    return { vertex: entry(inputVertices, byCorner ? entry(surface.triangles, best) : best) };
  }
}

function indexOfMax(count: number, value: (index: number) => number): number {
  let best = 0;
  let most = Number.NEGATIVE_INFINITY;
  for (let i = 0; i < count; i++) {
    const candidate = value(i);
    if (candidate > most) {
      most = candidate;
      best = i;
    }
  }
  return best;
}

/** A corner out of reach counts only where it has a weight. */
function interpolated(values: Float32Array, corners: readonly number[], weights: readonly number[]): ModelLength {
  const value = corners.reduce((sum, corner, i) => {
    const weight = entry(weights, i);
    return weight === 0 ? sum : sum + weight * entry(values, corner);
  }, 0);
  return ofModel(value);
}

function blend(values: Float32Array, corners: readonly number[], weights: readonly number[]): Vector {
  const origin: Vector = [0, 0, 0];
  return corners.reduce((sum, corner, i) => moved(sum, vectorAt(values, corner), entry(weights, i)), origin);
}

/** Least and greatest corner of the box around points. */
export function boxAround(positions: Float32Array): Box {
  const [x, y, z] = [rangeOf(positions, 0), rangeOf(positions, 1), rangeOf(positions, 2)];
  return [
    [x.least, y.least, z.least],
    [x.most, y.most, z.most],
  ];
}

function rangeOf(positions: Float32Array, axis: number): { least: number; most: number } {
  let [least, most] = [Infinity, -Infinity];
  for (let i = axis; i < positions.length; i += 3) {
    const value = entry(positions, i);
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return { least, most };
}
