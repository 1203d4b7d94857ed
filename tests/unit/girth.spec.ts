import { expect, test } from '@playwright/test';
import { loopsOf, planeOf } from '../../web/session/girth';
import { drawnPlace } from '../../web/session/nearest';
import { GIRTH, LEVEL_GIRTH } from '../../web/state/girth';
import { directionOf, middleOf } from '../../web/state/inside';
import { dot, minus } from '../../web/state/vector';
import type { DrawTransform } from '../../web/protocol';

/** Segments around a square. */
const square = (x: number, side: number) => [
  [x, 0, 0, x + side, 0, 0],
  [x + side, 0, 0, x + side, side, 0],
  [x + side, side, 0, x, side, 0],
  [x, side, 0, x, 0, 0],
];

test('segments become curves, the longest closed one first', () => {
  // The second begins where the first one ends, and is no part of it.
  const small = square(0, 1);
  const open = [
    [0, 0, 0, 0, 0, 50],
    [0, 0, 50, 0, 0, 100],
  ];
  const ends = Float32Array.from([...small, ...open, ...square(5, 3)].flat());
  const loops = loopsOf(ends, 2);
  expect(loops.map(({ closed, length }) => [closed, length])).toEqual([
    [true, 6],
    [true, 2],
    [false, 50],
  ]);
  expect(loops.map(({ points }) => points.length)).toEqual([5, 5, 3]);
  expect(loopsOf(new Float32Array(), 1)).toEqual([]);
});

test('the plane is the same in the axes of the file', () => {
  const transform: DrawTransform = { center: [10, 20, 30], scale: 0.5, up: 'z' };
  const box = [
    [-1, -2, -3],
    [3, 2, 1],
  ] as const;
  const { normal, offset } = planeOf({ ...LEVEL_GIRTH, place: 0.5 }, box as never, transform);
  // Up is Z, and half way to the upper end, drawn at 1, is two units of the file above its center.
  normal.forEach((value, axis) => expect(value).toBeCloseTo([0, 0, 1][axis], 12));
  expect(offset).toBeCloseTo(32, 12);
  const tilted = planeOf({ turn: 30, tilt: 20, place: -0.2 }, box as never, transform);
  // A place on it is drawn on the plane that was asked for.
  const plane = { turn: 30, tilt: 20, place: -0.2 };
  const [x, y, z] = tilted.normal;
  const onIt = drawnPlace([x * tilted.offset, y * tilted.offset, z * tilted.offset], transform);
  expect(dot(minus(onIt, middleOf(plane, box as never)), directionOf(plane))).toBeCloseTo(0, 12);
});

test('a link has the plane in three numbers', () => {
  const plane = { turn: -30, tilt: 12.5, place: 0.25 };
  expect(GIRTH.encode(plane)).toBe('-30,12.5,0.25');
  expect(GIRTH.parse('-30,12.5,0.25')).toEqual(plane);
  expect([GIRTH.encode(null), GIRTH.parse('none')]).toEqual(['none', null]);
  for (const bad of ['', '1,2', '0,0,2', '0,95,0', '0,,0', 'a,b,c', '0,0,0,0'])
    expect(GIRTH.parse(bad)).toBeUndefined();
});
