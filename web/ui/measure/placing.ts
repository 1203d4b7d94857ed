/**
 * Where labels stand that would lie on each other: each as near to its place as those before it leave, beside the model where that
 * has room.
 */
import { entry } from '../../state/entry';

/** CSS pixels, right and down. */
export type Pixel = readonly [number, number];

/** By its middle; CSS pixels. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** What labels keep off. */
export interface Surroundings {
  /** What no label covers. */
  taken: readonly Box[];
  /** What labels stay in; null: anywhere. */
  room: Box | null;
  /** A convex polygon around the model as it is seen; empty where it is not seen as a whole. */
  outline: readonly Pixel[];
}

/** Between two labels. */
const GAP = 2;
/** Directions that are tried at each distance, the upright ones first: labels are wider than high. */
const DIRECTIONS = [
  [0, -1],
  [0, 1],
  [1, 0],
  [-1, 0],
  [1, -1],
  [-1, -1],
  [1, 1],
  [-1, 1],
] as const;
/** Farther away a label would tell nothing of its place: it then lies on another one. */
const RINGS = 4;

/**
 * How far each of some boxes moves so that none meets one before it or what is taken, nor leaves the room or lies on the model if
 * it can be helped; right and down. In their order.
 */
export function apart(boxes: readonly Box[], { taken, room, outline }: Surroundings): Pixel[] {
  const standing = [...taken];
  return boxes.map((box) => {
    const begin = room ? into(box, room) : box;
    const places = shiftsOf(box).map(([x, y]) => movedBy(begin, x, y));
    const free = places.filter((place) => !standing.some((other) => meets(place, other)));
    const within = free.filter((place) => !room || isWithin(place, room));
    const beside = outline.length > 0 ? within.find((place) => !covers(place, outline)) : undefined;
    const place = beside ?? within[0] ?? free[0] ?? begin;
    standing.push(place);
    return [place.x - box.x, place.y - box.y];
  });
}

function shiftsOf({ width, height }: Box): Pixel[] {
  const steps = Array.from({ length: RINGS }, (_, ring) => ring + 1);
  const around = steps.flatMap((ring) =>
    DIRECTIONS.map(([x, y]): Pixel => [(x * ring * (width + GAP)) / 2, (y * ring * (height + GAP)) / 2]),
  );
  return [[0, 0], ...around.toSorted((one, other) => Math.hypot(...one) - Math.hypot(...other))];
}

function movedBy(box: Box, x: number, y: number): Box {
  return { ...box, x: box.x + x, y: box.y + y };
}

/** As little moved as it takes to lie within another. */
function into({ x, y, width, height }: Box, room: Box): Box {
  return {
    x: near(x, room.x, (room.width - width) / 2),
    y: near(y, room.y, (room.height - height) / 2),
    width,
    height,
  };
}

/** No farther than that from the middle. */
function near(value: number, middle: number, most: number): number {
  const [away, reach] = [value - middle, Math.max(0, most)];
  return Math.abs(away) <= reach ? value : middle + Math.sign(away) * reach;
}

function isWithin(box: Box, room: Box): boolean {
  const { x, y } = into(box, room);
  return x === box.x && y === box.y;
}

function meets(a: Box, b: Box): boolean {
  return (
    2 * Math.abs(a.x - b.x) < a.width + b.width + 2 * GAP - 1e-6 &&
    2 * Math.abs(a.y - b.y) < a.height + b.height + 2 * GAP - 1e-6
  );
}

/** Whether a box and a convex polygon, clockwise on the screen, have a place in common: no side of either lies between them. */
function covers({ x, y, width, height }: Box, outline: readonly Pixel[]): boolean {
  const [left, right, top, bottom] = [x - width / 2, x + width / 2, y - height / 2, y + height / 2];
  const xs = outline.map(([across]) => across);
  const ys = outline.map(([, down]) => down);
  if (Math.max(...xs) < left || Math.min(...xs) > right || Math.max(...ys) < top || Math.min(...ys) > bottom)
    return false;
  const corners: Pixel[] = [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ];
  return !outline.some((at, index) => {
    const next = entry(outline, (index + 1) % outline.length);
    return corners.every((corner) => turn(at, next, corner) < 0);
  });
}

/** The convex polygon around points, clockwise on the screen (Andrew's monotone chain). */
export function outlineOf(points: readonly Pixel[]): Pixel[] {
  const sorted = points.toSorted(([x, y], [right, down]) => x - right || y - down);
  const half = (row: readonly Pixel[]) => {
    const chain: Pixel[] = [];
    for (const point of row) {
      while (chain.length > 1 && turn(entry(chain, chain.length - 2), entry(chain, chain.length - 1), point) <= 0)
        chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.toReversed())];
}

/** Above 0 where the way from `a` by `b` to `c` turns clockwise on the screen. */
function turn(a: Pixel, b: Pixel, c: Pixel): number {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
