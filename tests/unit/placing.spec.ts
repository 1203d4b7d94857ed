import { expect, test } from '@playwright/test';
import { apart, type Box, outlineOf, type Surroundings } from '../../web/ui/measure/placing';
import { extremesOf } from '../../web/ui/measure/standing';

const NOTHING: Surroundings = { taken: [], room: null, outline: [] };

const box = (x: number, y: number): Box => ({ x, y, width: 60, height: 18 });

function meeting(boxes: readonly Box[]): number {
  const pairs = boxes.flatMap((a, i) => boxes.slice(i + 1).map((b) => [a, b] as const));
  return pairs.filter(
    ([a, b]) => 2 * Math.abs(a.x - b.x) < a.width + b.width && 2 * Math.abs(a.y - b.y) < a.height + b.height,
  ).length;
}

test('labels that have room stay where they are, and others move as little as they need', () => {
  expect(apart([box(0, 0), box(100, 0), box(0, 40)], NOTHING)).toEqual([
    [0, 0],
    [0, 0],
    [0, 0],
  ]);
  const [first, second] = apart([box(0, 0), box(10, 4)], NOTHING);
  expect(first).toEqual([0, 0]);
  expect(Math.hypot(...second)).toBeGreaterThan(0);
  expect(Math.hypot(...second)).toBeLessThan(45);
});

test('a heap of labels, some on a place that is taken, ends with none on another', () => {
  const boxes = Array.from({ length: 7 }, (_, i) => box(3 * i, 2 * i));
  const taken = [{ x: 0, y: 0, width: 12, height: 12 }];
  expect(meeting(boxes)).toBe(21);
  const moved = apart(boxes, { ...NOTHING, taken }).map(([x, y], i) => box(boxes[i].x + x, boxes[i].y + y));
  expect(meeting([...moved, ...taken])).toBe(0);
});

test('a label stands beside the model where that is near, and on it where it is not; it stays in the window', () => {
  const round = Array.from({ length: 40 }, (_, k): [number, number] => [
    200 * Math.cos((k * Math.PI) / 20),
    200 * Math.sin((k * Math.PI) / 20),
  ]);
  const outline = outlineOf([...round, [10, 20], [0, 0]]);
  expect(outline).toHaveLength(40);
  const [middle, outside] = apart([box(0, 0), box(235, 0)], { ...NOTHING, outline });
  expect([middle, outside]).toEqual([
    [0, 0],
    [0, 0],
  ]);
  const [edge] = apart([box(190, 0)], { ...NOTHING, outline });
  expect(Math.hypot(190 + edge[0], edge[1])).toBeGreaterThan(200);
  expect(Math.hypot(...edge)).toBeLessThan(130);

  const room = { x: 0, y: 0, width: 440, height: 300 };
  const [right, below] = apart([box(215, 0), box(0, 149)], { ...NOTHING, room });
  expect(right).toEqual([-25, 0]);
  expect(below).toEqual([0, -8]);
});

test('the outline of a sphere is found but for a hundredth', () => {
  const places = Array.from({ length: 20_000 }, (_, k) => {
    const [y, angle] = [1 - (2 * k + 1) / 20_000, 2.4 * k];
    return [Math.sqrt(1 - y * y) * Math.cos(angle), y, Math.sqrt(1 - y * y) * Math.sin(angle)];
  });
  const extremes = extremesOf(Float32Array.from(places.flat()));
  const outline = outlineOf(extremes.map(([x, y]) => [x, y]));
  const area = outline.reduce((sum, [x, y], i) => {
    const [right, down] = outline[(i + 1) % outline.length];
    return sum + (x * down - right * y) / 2;
  }, 0);
  expect(area).toBeGreaterThan(0.9 * Math.PI);
  expect(area).toBeLessThanOrEqual(Math.PI);
});
