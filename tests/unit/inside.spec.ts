import { expect, test } from '@playwright/test';
import { anglesOf, directionOf, HALVED, innerCutOf, middleOf, reachOf, WHOLE } from '../../web/state/inside';
import type { Box } from '../../web/state/places';
import type { Vector } from '../../web/state/vector';

const BOX: Box = [
  [-1, -0.5, -0.25],
  [1, 0.5, 0.75],
];

const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, along, axis) => sum + along * b[axis], 0);

test('nothing is asked of the solver where nothing of the inside is seen', () => {
  expect(innerCutOf(WHOLE, BOX)).toBeNull();
  expect(innerCutOf({ ...WHOLE, turn: 40, place: 0.3 }, BOX)).toBeNull();
  for (const change of [{ whole: true }, { gap: 0.1 }, { spacing: 0.1 }, { arrows: true }]) {
    expect(innerCutOf({ ...WHOLE, ...change }, BOX)).toMatchObject({ planes: [], ...change });
  }
});

test('a plane goes through the middle of the box, and at its ends touches it', () => {
  for (const [turn, tilt] of [
    [0, 0],
    [90, 0],
    [30, 50],
    [-120, -90],
  ]) {
    const inside = { ...HALVED, turn, tilt };
    const direction = directionOf(inside);
    expect(Math.hypot(...direction)).toBeCloseTo(1, 12);
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((bits): Vector => [
      BOX[bits & 1][0],
      BOX[(bits >> 1) & 1][1],
      BOX[bits >> 2][2],
    ]);
    const along = corners.map((corner) => dot(direction, corner));
    for (const [place, expected] of [
      [-1, Math.min(...along)],
      [0, (Math.min(...along) + Math.max(...along)) / 2],
      [1, Math.max(...along)],
    ]) {
      const [x, y, z, offset] = innerCutOf({ ...inside, place }, BOX)?.planes ?? [];
      expect([x, y, z]).toEqual(direction);
      expect(offset).toBeCloseTo(expected, 12);
      expect(dot(direction, middleOf({ ...inside, place }, BOX))).toBeCloseTo(expected, 12);
    }
    expect(2 * reachOf(direction, BOX)).toBeCloseTo(Math.max(...along) - Math.min(...along), 12);
    expect(anglesOf(direction).tilt).toBe(tilt);
  }
});

test('a wedge opens by its angle, around where it is turned', () => {
  for (const opening of [20, 90, 180]) {
    const inside = { ...WHOLE, cut: 'wedge' as const, turn: 35, tilt: 20, place: 0.2, opening };
    const { planes } = innerCutOf(inside, BOX) ?? { planes: [] };
    expect(planes).toHaveLength(8);
    const [one, other] = [planes.slice(0, 3), planes.slice(4, 7)];
    const angle = (Math.acos(Math.min(1, dot(one, other))) * 180) / Math.PI;
    expect(angle).toBeCloseTo(180 - opening, 5);
    const middle = middleOf(inside, BOX);
    // What is cut away is beyond both.
    const [within, aside] = [0.1, -0.1].map((step) =>
      middle.map((along, axis) => along + step * directionOf(inside)[axis]),
    );
    expect(dot(one, within)).toBeGreaterThan(planes[3]);
    expect(dot(other, within)).toBeGreaterThan(planes[7]);
    expect(dot(one, aside)).toBeLessThan(planes[3]);
    for (const [normal, offset] of [
      [one, planes[3]],
      [other, planes[7]],
    ] as const) {
      expect(dot(normal, middle)).toBeCloseTo(offset, 12);
    }
  }
});
