import { expect, test } from '@playwright/test';
import { MODEL, ofModel } from '../../web/length';
import {
  type Level,
  levelsOf,
  markdownOf,
  MOST_TRIANGLES,
  slopeOf,
  split,
  type Studied,
  studied,
} from '../../web/state/convergence';

type Triangles = Pick<Studied, 'positions' | 'triangles'>;
const TETRAHEDRON: Triangles = {
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1),
  triangles: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
};
type Triple = [number, number, number];

/** Where a place in a triangle is. */
function at({ positions, triangles }: Triangles, face: number, weights: ArrayLike<number>): Triple {
  const axis = (along: number) =>
    [0, 1, 2].reduce((sum, k) => sum + weights[k] * positions[3 * triangles[3 * face + k] + along], 0);
  return [axis(0), axis(1), axis(2)];
}

function area(mesh: Triangles): number {
  let sum = 0;
  for (let face = 0; face < mesh.triangles.length / 3; face++) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      at(
        mesh,
        face,
        [0, 1, 2].map((i) => Number(i === k)),
      ),
    );
    const [u, v] = [b, c].map((end) => end.map((x, axis) => x - a[axis]));
    sum += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return sum;
}

test('each triangle becomes four, an edge gets one vertex, and the surface and its sources stay', () => {
  const weights: Triple[] = [
    [0.7, 0.2, 0.1],
    [0.1, 0.8, 0.1],
    [0.25, 0.15, 0.6],
    [0.4, 0.3, 0.3],
    [0.5, 0.5, 0],
    [0, 0, 1],
  ];
  const sources = [{ vertex: 3, offset: 0.5 }, ...weights.map((inside, i) => ({ face: i % 4, weights: inside }))];
  const once = split({ ...TETRAHEDRON, sources });
  expect(once.positions).toHaveLength(3 * (4 + 6));
  expect(once.triangles).toHaveLength(4 * TETRAHEDRON.triangles.length);
  expect(area(once)).toBeCloseTo(area(TETRAHEDRON), 12);
  expect(once.sources[0]).toEqual(sources[0]);
  const twice = split(once);
  for (const [i, inside] of weights.entries()) {
    const place = at(TETRAHEDRON, i % 4, inside);
    for (const finer of [once, twice]) {
      const source = finer.sources[i + 1];
      if (!('face' in source)) throw new Error('The source has left its triangle.');
      expect(Math.min(...source.weights)).toBeGreaterThanOrEqual(0);
      at(finer, source.face, source.weights).forEach((x, axis) => expect(x).toBeCloseTo(place[axis], 12));
    }
  }
});

test('sources are found on what is drawn, with initial distances in its unit', () => {
  const opened = { surface: TETRAHEDRON, inputVertices: Uint32Array.of(5, 7, 5, 9), drawTransform: { scale: 2 } };
  const sources = [{ vertex: 7, offset: 0.25 }, { vertex: 6 }, { face: 1, weights: [1, 0, 0] as Triple }];
  const placed = studied(opened as unknown as Parameters<typeof studied>[0], sources).sources;
  expect(placed).toEqual([
    { vertex: 1, offset: 0.5 },
    { face: 1, weights: [1, 0, 0], offset: 0 },
  ]);
});

test('no surface is split into more triangles than exact distances have time for', () => {
  expect(levelsOf(4)).toBe(3);
  expect(levelsOf(MOST_TRIANGLES / 16)).toBe(3);
  expect(levelsOf(MOST_TRIANGLES / 16 + 1)).toBe(2);
  expect(levelsOf(MOST_TRIANGLES / 4 + 1)).toBe(1);
  expect(levelsOf(MOST_TRIANGLES + 1)).toBe(0);
});

/** Errors that fall with the edge, by heat, and with its square, by propagation, on average; exact at most. */
const levels: Level[] = [1, 0.5, 0.25].map((edge, i) => ({
  triangles: 100 * 4 ** i,
  edge: ofModel(edge),
  heat: { mean: 0.02 * edge, max: 0.3 },
  propagation: { mean: 0.004 * edge ** 2, max: 0 },
}));

test('a slope is the power of the edge length that an error falls with', () => {
  expect(slopeOf(levels, ({ heat }) => heat.mean)).toBeCloseTo(1, 12);
  expect(slopeOf(levels, ({ heat }) => heat.max)).toBeCloseTo(0, 12);
  expect(slopeOf(levels, ({ propagation }) => propagation.mean)).toBeCloseTo(2, 12);
  expect(slopeOf(levels, ({ propagation }) => propagation.max)).toBeNull();
  expect(slopeOf(levels.slice(0, 1), ({ heat }) => heat.mean)).toBeNull();
});

test('Markdown has a line a surface, and one of slopes', () => {
  const lines = markdownOf(levels, { ...MODEL, symbol: 'mm', scale: 1000 })
    .trim()
    .split('\n');
  expect(lines).toHaveLength(6);
  expect(lines[0]).toContain('| Mean edge (mm) |');
  expect(lines[1]).toBe('| ---: | ---: | ---: | ---: | ---: | ---: |');
  expect(lines[3]).toBe('| 400 | 500.0 | 1.00 | 30.0 | 0.100 | 0.00 |');
  expect(lines[5]).toBe('| Slope |  | 1.00 | 0.00 | 2.00 | – |');
});
