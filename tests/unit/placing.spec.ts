import { expect, test } from '@playwright/test';
import { apart, type Box } from '../../web/ui/measure/placing';

const box = (x: number, y: number): Box => ({ x, y, width: 60, height: 18 });

function meeting(boxes: readonly Box[]): number {
  const pairs = boxes.flatMap((a, i) => boxes.slice(i + 1).map((b) => [a, b] as const));
  return pairs.filter(
    ([a, b]) => 2 * Math.abs(a.x - b.x) < a.width + b.width && 2 * Math.abs(a.y - b.y) < a.height + b.height,
  ).length;
}

test('labels that have room stay where they are, and others move as little as they need', () => {
  expect(apart([box(0, 0), box(100, 0), box(0, 40)], [])).toEqual([
    [0, 0],
    [0, 0],
    [0, 0],
  ]);
  const [first, second] = apart([box(0, 0), box(10, 4)], []);
  expect(first).toEqual([0, 0]);
  expect(Math.hypot(...second)).toBeGreaterThan(0);
  expect(Math.hypot(...second)).toBeLessThan(45);
});

test('a heap of labels, some on a place that is taken, ends with none on another', () => {
  const boxes = Array.from({ length: 7 }, (_, i) => box(3 * i, 2 * i));
  const taken = [{ x: 0, y: 0, width: 12, height: 12 }];
  expect(meeting(boxes)).toBe(21);
  const moved = apart(boxes, taken).map(([x, y], i) => box(boxes[i].x + x, boxes[i].y + y));
  expect(meeting([...moved, ...taken])).toBe(0);
});
