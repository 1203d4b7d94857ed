/** Vectors of three numbers, alone and in arrays that have three numbers for each. */

import { entry } from './entry';

export type Vector = [number, number, number];

export function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/** A vector `factor` times as long. */
export function scaled([x, y, z]: Vector, factor: number): Vector {
  return [factor * x, factor * y, factor * z];
}

/** The point that is `times` a step from another one. */
export function moved(from: Vector, step: Vector, times: number): Vector {
  return [from[0] + times * step[0], from[1] + times * step[1], from[2] + times * step[2]];
}

/** Between two points: `share` 1 is all the way from `a` to `b`. */
export function between(a: Vector, b: Vector, share: number): Vector {
  return moved(a, minus(b, a), share);
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function distance(a: Vector, b: Vector): number {
  return Math.hypot(...minus(a, b));
}

/** Of length 1; a vector without length stays. */
export function normalized(vector: Vector): Vector {
  const length = Math.hypot(...vector) || 1;
  return [vector[0] / length, vector[1] / length, vector[2] / length];
}

/** The vector of an index in an array of them, #V × 3. */
export function vectorAt(array: ArrayLike<number>, index: number): Vector {
  return [entry(array, 3 * index), entry(array, 3 * index + 1), entry(array, 3 * index + 2)];
}

/** All vectors of an array. */
export function vectorsIn(array: ArrayLike<number>): Vector[] {
  return Array.from({ length: array.length / 3 }, (_, index) => vectorAt(array, index));
}

export type Triangle = readonly [Vector, Vector, Vector];

/** Where the corners of a triangle are: `positions` #V × 3, `triangles` #F × 3. */
export function cornersOf(positions: ArrayLike<number>, triangles: ArrayLike<number>, face: number): Triangle {
  const [a, b, c] = vectorAt(triangles, face);
  return [vectorAt(positions, a), vectorAt(positions, b), vectorAt(positions, c)];
}

/** Barycentric: the mean of the corners by weights. */
export function weighted([a, b, c]: Triangle, [u, v, w]: Vector): Vector {
  return [u * a[0] + v * b[0] + w * c[0], u * a[1] + v * b[1] + w * c[1], u * a[2] + v * b[2] + w * c[2]];
}

export function areaOfTriangle([a, b, c]: Triangle): number {
  return Math.hypot(...cross(minus(b, a), minus(c, a))) / 2;
}
