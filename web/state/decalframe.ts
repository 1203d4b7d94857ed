/** How an image stands on the surface at its place. */
import { cross, dot, minus, moved, normalized, scaled, type Vector } from './vector';

/** Where the surface is nearer to level than this sine, upright is away from the front. */
const LEVEL = 0.05;
const UP: Vector = [0, 1, 0];

/** The right and the upper side of an image that is not turned, as they are drawn; `normal` is that of the surface there. */
export function uprightAt(normal: Vector): { right: Vector; up: Vector } {
  const across = cross(UP, normal);
  const isLevel = Math.hypot(...across) < LEVEL;
  const right = normalized(isLevel ? cross([0, 0, normal[1] > 0 ? -1 : 1], normal) : across);
  return { right, up: cross(normal, right) };
}

/** The right side of an image that is turned by so many degrees. */
export function rightAt(normal: Vector, angle: number): Vector {
  const { right, up } = uprightAt(normal);
  const turned = (angle * Math.PI) / 180;
  return moved(scaled(right, Math.cos(turned)), up, Math.sin(turned));
}

/** The angle by which an image is turned whose right side is in a direction; from −180 to 180. */
export function angleOf(normal: Vector, direction: Vector): number {
  const { right, up } = uprightAt(normal);
  const along = minus(direction, scaled(normal, dot(direction, normal)));
  return (Math.atan2(dot(along, up), dot(along, right)) * 180) / Math.PI;
}
