import { expect, test } from '@playwright/test';
import { distributionOf, errorsByDistance } from '../../web/state/distribution';
import { csvOf, fittedAxis, logarithmicAxis, ticksTo } from '../../web/ui/charts/plot';
import { grid } from '../fixtures';

const N = 12;
/** The unit square with a value at each vertex. */
function square(value: (x: number, y: number) => number) {
  const { positions, triangles } = grid(N);
  return {
    positions: Float32Array.from(positions.flat()),
    triangles: Uint32Array.from(triangles.flat()),
    distance: Float32Array.from(positions, ([x, y]) => value(x, y)),
    byCorner: false,
  };
}

test('the area below a value is exact for values that are linear', () => {
  const { edges, below, unreached } = distributionOf(
    square((x, y) => x + y),
    40,
  );
  expect(unreached).toBe(0);
  // Below x + y = t there is half of t squared, and the same from the other corner.
  edges.forEach((t, index) => {
    const expected = t <= 1 ? t ** 2 / 2 : 1 - (2 - t) ** 2 / 2;
    expect(below[index]).toBeCloseTo(expected, 6);
  });
});

test('corner values are told like those of vertices, and what is not reached is left out', () => {
  const plain = square((x) => x);
  const distance = Float32Array.from(plain.triangles, (vertex) => plain.distance[vertex]);
  const byCorner = distributionOf({ ...plain, distance, byCorner: true }, 10);
  expect([...byCorner.below]).toEqual([...distributionOf(plain, 10).below]);
  const half = distributionOf(
    square((x) => (x > 0.5 ? Infinity : x)),
    10,
  );
  // Triangles that touch what is not reached are not.
  expect(half.unreached).toBeCloseTo(0.5, 6);
  expect(half.below.at(-1)).toBe(1);
  expect(half.edges.at(-1)).toBeCloseTo(0.5, 6);
});

test('a field that is 0 everywhere, and one without a source, are told', () => {
  expect([
    ...distributionOf(
      square(() => 0),
      2,
    ).below,
  ]).toEqual([1, 1, 1]);
  const none = distributionOf(
    square(() => Infinity),
    2,
  );
  expect(none.unreached).toBe(1);
  expect([...none.below]).toEqual([0, 0, 0]);
});

test('errors are told by distance, without sources and what is not reached', () => {
  const errors = Float32Array.of(0, 0.5, 0.25, 0.125, 0);
  const distance = Float32Array.of(0, 1, 1, 4, Infinity);
  expect(errorsByDistance(errors, distance, 2)).toEqual({ distance: [1, 3], mean: [0.375, 0.125], most: [0.5, 0.125] });
});

test('ticks are round', () => {
  expect(ticksTo(1)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
  expect(ticksTo(0.07)).toEqual([0, 0.02, 0.04, 0.06]);
  expect(ticksTo(900)).toEqual([0, 200, 400, 600, 800]);
  expect(ticksTo(0)).toEqual([0]);
});

test('a chart as CSV has a line a value', () => {
  const series = [{ name: 'Area (%)', kind: 'bars' as const, x: [0, 1, 2], y: [40, 60] }];
  const csv = csvOf({ title: 'Area', xLabel: 'Distance (m)', yLabel: 'Area (%)', series });
  expect(csv).toBe('"Distance (m)","Area (%)"\r\n0,40\r\n1,60\r\n');
});

test('powers of ten stand at equal steps, and 0 on the lowest', () => {
  const { place, ticks } = logarithmicAxis([1, 3e-9, 0]);
  expect(place(1)).toBe(1);
  expect(place(1e-9)).toBe(0);
  expect(place(0)).toBe(0);
  expect(place(1e-6)).toBeCloseTo(1 / 3, 12);
  expect(ticks.map(({ label }) => String(label))).toEqual(['10⁰', '10⁻²', '10⁻⁴', '10⁻⁶', '10⁻⁸']);
});

test('a fitted axis has what values take, with more steps where these are few', () => {
  const { place, ticks } = fittedAxis([0.011, 0.09]);
  expect(ticks.map(({ label }) => String(label))).toEqual(['0.01', '0.02', '0.05', '0.1']);
  expect(fittedAxis([0.2, 0.4]).ticks.map(({ label }) => String(label))).toEqual(['0.2', '0.3', '0.4']);
  expect(place(0.011)).toBeCloseTo(1 - place(0.09), 12);
  expect(place(0.011)).toBeGreaterThan(0);
  expect(place(Math.sqrt(0.011 * 0.09))).toBeCloseTo(0.5, 12);
  expect(fittedAxis([1e-7, 1e-3]).ticks.map(({ label }) => String(label))).toEqual([
    '10⁻⁷',
    '10⁻⁶',
    '10⁻⁵',
    '10⁻⁴',
    '0.001',
  ]);
  expect(fittedAxis([3]).ticks.map(({ label }) => String(label))).toEqual(['2', '3', '4', '5']);
});
