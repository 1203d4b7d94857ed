/** Vectors of three numbers, alone and in arrays that have three numbers for each. */

export type Vector = [number, number, number];

export function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
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
  return [array[3 * index], array[3 * index + 1], array[3 * index + 2]];
}
