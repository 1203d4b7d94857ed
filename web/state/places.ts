/** Where surface points lie on the drawn mesh, and what holds there. */
import type { DistanceField, DrawPose, OpenedMesh, SurfacePoint } from '../protocol';

export type Vector = [number, number, number];

/** Position and normal as they are drawn: see `DrawTransform`. */
export interface Place {
  position: Vector;
  normal: Vector;
}

/** Values of a field. */
type Values = Pick<DistanceField, 'distance' | 'byCorner'>;

export class Places {
  readonly #mesh: OpenedMesh;
  /** Of the drawn vertices, in the pose that is shown. */
  #pose: DrawPose;
  /** Of each input vertex one drawn vertex, −1 where none is drawn. */
  readonly #drawnOf: Int32Array;
  /** Diagonal of the bounding box, in the unit of the file. */
  readonly diameter: number;
  /** The same as it is drawn. */
  readonly drawnDiameter: number;

  constructor(mesh: OpenedMesh) {
    this.#mesh = mesh;
    this.#pose = mesh.surface;
    this.#drawnOf = new Int32Array(mesh.report.inputVertices).fill(-1);
    mesh.inputVertices.forEach((vertex, drawn) => {
      this.#drawnOf[vertex] = drawn;
    });
    this.drawnDiameter = boxDiagonal(mesh.surface.positions);
    this.diameter = this.drawnDiameter / mesh.drawTransform.scale;
  }

  /** Another pose is shown. Sizes stay those of the pose in the file. */
  pose(pose: DrawPose): void {
    this.#pose = pose;
  }

  /** The three drawn corners and their weights; null when the mesh has no such place. */
  #corners(point: SurfacePoint): { corners: Vector; weights: Vector } | null {
    if ('vertex' in point) {
      const drawn = this.#drawnOf[point.vertex] ?? -1;
      return drawn < 0 ? null : { corners: [drawn, drawn, drawn], weights: [1, 0, 0] };
    }
    const { triangles } = this.#mesh.surface;
    const first = 3 * point.face;
    if (first + 2 >= triangles.length) return null;
    return { corners: [triangles[first], triangles[first + 1], triangles[first + 2]], weights: point.weights };
  }

  /** `#D × 3`, where drawn vertices are. */
  get positions(): Float32Array {
    return this.#pose.positions;
  }

  has(point: SurfacePoint): boolean {
    return this.#corners(point) !== null;
  }

  at(point: SurfacePoint): Place | null {
    const found = this.#corners(point);
    if (!found) return null;
    const { positions, normals } = this.#pose;
    return {
      position: blend(positions, found.corners, found.weights),
      normal: normalised(blend(normals, found.corners, found.weights)),
    };
  }

  /** Linear over the triangle; Infinity as soon as one corner is out of reach; NaN where the mesh has no such place. */
  valueAt(point: SurfacePoint, { distance: values, byCorner }: Values): number {
    const found = this.#corners(point);
    if (!found) return Number.NaN;
    if (byCorner && 'vertex' in point) return this.#leastAt(point.vertex, values);
    const { weights } = found;
    const first = 'face' in point ? 3 * point.face : 0;
    const corners = byCorner ? [first, first + 1, first + 2] : found.corners;
    return corners.reduce((sum, corner, i) => sum + (weights[i] === 0 ? 0 : weights[i] * values[corner]), 0);
  }

  /** The least value of the corners at a vertex, which walls part. */
  #leastAt(vertex: number, values: Float32Array): number {
    const { surface, inputVertices } = this.#mesh;
    let least = Infinity;
    surface.triangles.forEach((drawn, corner) => {
      if (inputVertices[drawn] === vertex) least = Math.min(least, values[corner]);
    });
    return least;
  }

  /** Of the corners of the point's triangle the nearest one in weights, as an index of the input. */
  nearestVertex(point: SurfacePoint): number {
    if ('vertex' in point) return point.vertex;
    const { surface, inputVertices } = this.#mesh;
    const corner = point.weights.indexOf(Math.max(...point.weights));
    return inputVertices[surface.triangles[3 * point.face + corner]];
  }

  /** The vertex that lies farthest in a direction. */
  extreme([x, y, z]: Vector): SurfacePoint {
    const { surface, inputVertices } = this.#mesh;
    return {
      vertex:
        inputVertices[
          indexOfMax(inputVertices.length, (drawn) => {
            const p = surface.positions;
            return x * p[3 * drawn] + y * p[3 * drawn + 1] + z * p[3 * drawn + 2];
          })
        ],
    };
  }

  /** The vertex with the largest finite value. */
  farthest({ distance: values, byCorner }: Values): SurfacePoint {
    const value = (index: number) => (Number.isFinite(values[index]) ? values[index] : Number.NEGATIVE_INFINITY);
    const best = indexOfMax(values.length, value);
    const { surface, inputVertices } = this.#mesh;
    return { vertex: inputVertices[byCorner ? surface.triangles[best] : best] };
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

function blend(values: Float32Array, corners: Vector, weights: Vector): Vector {
  const out: Vector = [0, 0, 0];
  for (let k = 0; k < 3; k++) {
    for (let i = 0; i < 3; i++) out[k] += weights[i] * values[3 * corners[i] + k];
  }
  return out;
}

function normalised(vector: Vector): Vector {
  const length = Math.hypot(...vector) || 1;
  return [vector[0] / length, vector[1] / length, vector[2] / length];
}

function boxDiagonal(positions: Float32Array): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}
