/** Colors of the distance from curves; linear RGB. */
import { between, type Vector } from './vector';

/** Beside a curve, and farthest from it, on either side. */
const INSIDE: readonly [Vector, Vector] = [
  [0.3, 0.52, 0.86],
  [0.015, 0.11, 0.55],
];
const OUTSIDE: readonly [Vector, Vector] = [
  [0.9, 0.72, 0.5],
  [0.8, 0.2, 0.015],
];
const OPACITY = 0.92;

/** Of a place at a share, 0 to 1, of the largest distance; linear RGBA. */
export function colourOfSide(isInside: boolean, share: number): number[] {
  const [near, far] = isInside ? INSIDE : OUTSIDE;
  // Near the curve it changes most.
  return [...between(near, far, Math.sqrt(Math.min(1, share))), OPACITY];
}
