/** Where labels stand that would lie on each other: each as near to its place as those before it leave. */

/** CSS pixels. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
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
 * How far each of some boxes, by its middle, moves so that none meets one before it or what is `taken`; right and down. In their
 * order.
 */
export function apart(boxes: readonly Box[], taken: readonly Box[]): [number, number][] {
  const standing = [...taken];
  return boxes.map((box) => {
    const isFree = ([x, y]: [number, number]) => !standing.some((other) => meets(movedBy(box, x, y), other));
    const shift = shiftsOf(box).find(isFree) ?? [0, 0];
    standing.push(movedBy(box, ...shift));
    return shift;
  });
}

function shiftsOf({ width, height }: Box): [number, number][] {
  const steps = Array.from({ length: RINGS }, (_, ring) => ring + 1);
  const around = steps.flatMap((ring) =>
    DIRECTIONS.map(([x, y]): [number, number] => [(x * ring * (width + GAP)) / 2, (y * ring * (height + GAP)) / 2]),
  );
  return [[0, 0], ...around.toSorted((one, other) => Math.hypot(...one) - Math.hypot(...other))];
}

function movedBy(box: Box, x: number, y: number): Box {
  return { ...box, x: box.x + x, y: box.y + y };
}

function meets(a: Box, b: Box): boolean {
  return (
    2 * Math.abs(a.x - b.x) < a.width + b.width + 2 * GAP - 1e-6 &&
    2 * Math.abs(a.y - b.y) < a.height + b.height + 2 * GAP - 1e-6
  );
}
