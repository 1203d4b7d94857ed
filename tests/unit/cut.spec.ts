import { expect, test } from '@playwright/test';
import type { MeshPoint } from '../../web/protocol';
import type { Vector } from '../../web/state/vector';
import { straightCut } from '../../web/ui/charts/cut';
import { grid, sphere } from '../fixtures';

interface Triangles {
  positions: Vector[];
  triangles: readonly (readonly number[])[];
}

/** A mesh as it is drawn, with what lies beside each triangle; `normal`: at a place. */
function drawn({ positions, triangles }: Triangles, normal: (place: Vector) => Vector) {
  const sides = new Map<string, number>();
  triangles.forEach((corners, face) =>
    corners.forEach((from, k) => sides.set(`${from} ${corners[(k + 1) % 3]}`, face)),
  );
  const neighbors = triangles.flatMap((corners, face) =>
    corners.map((from, k) => sides.get(`${corners[(k + 1) % 3]} ${from}`) ?? face),
  );
  const numbers = Float32Array.from(positions.flat());
  const at = (point: MeshPoint) => {
    const [corners, weights] =
      'face' in point ? [triangles[point.face], point.weights] : 'vertex' in point ? [[point.vertex], [1]] : [[], []];
    const position = [0, 1, 2].map((axis) =>
      corners.reduce((sum, vertex, k) => sum + weights[k] * numbers[3 * vertex + axis], 0),
    ) as Vector;
    return { position, normal: normal(position) };
  };
  const mesh = {
    surface: { triangles: Uint32Array.from(triangles.flat()) },
    neighbors: Uint32Array.from(neighbors),
  };
  return { mesh, places: { at, positions: numbers } };
}

const N = 12;
const SHEET = drawn(grid(N) as Triangles, () => [0, 0, 1]);
const vertex = (i: number, j: number) => ({ vertex: i + (N + 1) * j });

test('in the plane a straight cut is the straight line, along edges and through triangles', () => {
  const { mesh, places } = SHEET;
  const inside: MeshPoint = { face: 100, weights: [0.2, 0.3, 0.5] };
  for (const [from, to] of [
    [vertex(1, 1), vertex(9, 1)],
    [vertex(1, 1), vertex(9, 9)],
    [vertex(9, 1), vertex(1, 9)],
    [vertex(2, 3), vertex(11, 8)],
    [inside, vertex(11, 2)],
    [vertex(0, 0), inside],
    [inside, { face: 100, weights: [0.6, 0.3, 0.1] as Vector }],
  ] as const) {
    const cut = straightCut(mesh, places, from, to);
    const [a, b] = [places.at(from).position, places.at(to).position];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    // Single precision of positions.
    expect(cut?.arcs.at(-1)).toBeCloseTo(length, 6);
    expect(cut?.points).toHaveLength(cut?.arcs.length ?? 0);
    cut?.points.forEach((point, i) => {
      const { position } = places.at(point);
      expect(Math.hypot(position[0] - a[0], position[1] - a[1])).toBeCloseTo(cut.arcs[i], 6);
    });
  }
});

test('around a ball a straight cut is the great circle, the shorter way', () => {
  const { positions, triangles } = sphere(40);
  const { mesh, places } = drawn({ positions, triangles } as Triangles, (place) => place);
  const ends = [100, 900].map((index) => positions[index] as Vector);
  const angle = Math.acos(ends[0].reduce((sum, x, axis) => sum + x * ends[1][axis], 0));
  const cut = straightCut(mesh, places, { vertex: 100 }, { vertex: 900 });
  // Chords are shorter than arcs by a share of the square of the angle of an edge, which is 0.08.
  expect(cut?.arcs.at(-1)).toBeGreaterThan(0.997 * angle);
  expect(cut?.arcs.at(-1)).toBeLessThan(angle);
});

test('there is no straight cut over a gap, and none from a place to itself', () => {
  const { positions, triangles } = grid(N);
  // Without the triangles of a column.
  const parted = triangles.filter((corners) => !corners.some((corner) => corner % (N + 1) === 6));
  const { mesh, places } = drawn({ positions, triangles: parted } as Triangles, () => [0, 0, 1]);
  expect(straightCut(mesh, places, vertex(2, 5), vertex(10, 5))).toBeNull();
  expect(straightCut(mesh, places, vertex(2, 5), vertex(4, 5))).not.toBeNull();
  expect(straightCut(SHEET.mesh, SHEET.places, vertex(2, 5), vertex(2, 5))).toBeNull();
});
