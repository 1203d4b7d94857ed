import { expect, test } from '@playwright/test';
import type { DrawMesh } from '../../web/protocol';
import { drawnPlace, filePlace, nearestPlace } from '../../web/session/nearest';
import { NO_MESH } from '../../web/view/layers';
import { UP } from '../../web/wasm/contract';

type Vector = [number, number, number];

/** A wavy sheet with the boxes that the worker makes of one: leaves of eight triangles under a complete binary tree. */
function sheet(n: number): DrawMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  for (let j = 0; j <= n; j++) for (let i = 0; i <= n; i++) positions.push(i / n, j / n, 0.2 * Math.sin(i + 2 * j));
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const a = i + (n + 1) * j;
      triangles.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  }
  const faces = triangles.length / 3;
  const leaves = Math.ceil(faces / 8);
  const boxes = new Float32Array(6 * (2 * leaves - 1));
  const fit = (node: number, points: readonly number[][]) => {
    for (let k = 0; k < 3; k++) {
      boxes[6 * node + k] = Math.min(...points.map((point) => point[k])) - 1e-6;
      boxes[6 * node + 3 + k] = Math.max(...points.map((point) => point[k])) + 1e-6;
    }
  };
  const at = (corner: number) => positions.slice(3 * triangles[corner], 3 * triangles[corner] + 3);
  for (let leaf = 0; leaf < leaves; leaf++) {
    const corners = Array.from({ length: Math.min(24, 3 * faces - 24 * leaf) }, (_, i) => at(24 * leaf + i));
    fit(leaves - 1 + leaf, corners);
  }
  for (let node = leaves - 2; node >= 0; node--) {
    const ends = [2 * node + 1, 2 * node + 2].flatMap((child) => [
      [...boxes.subarray(6 * child, 6 * child + 3)],
      [...boxes.subarray(6 * child + 3, 6 * child + 6)],
    ]);
    fit(node, ends);
  }
  return {
    ...NO_MESH,
    positions: Float32Array.from(positions),
    triangles: Uint32Array.from(triangles),
    order: Uint32Array.from({ length: faces }, (_, face) => face),
    boxes,
  } as DrawMesh;
}

/** Where a face with weights is. */
function placeIn({ positions, triangles }: DrawMesh, face: number, weights: readonly number[]): Vector {
  const at = (k: number) =>
    weights.reduce((sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + k], 0);
  return [at(0), at(1), at(2)];
}

const away = (a: Vector, b: Vector) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

test('no place of the surface is nearer than the one that is found, which is as far as is told', () => {
  const mesh = sheet(9);
  const faces = mesh.triangles.length / 3;
  const inputVertices = Uint32Array.from({ length: mesh.positions.length / 3 }, (_, vertex) => 1000 + vertex);
  const steps = 12;
  for (const point of [
    [0.5, 0.5, 1],
    [0.31, 0.77, 0.02],
    [-1, 2, 0.3],
    [2, 0.4, -0.1],
    [0.9, 0.05, -0.4],
  ] as Vector[]) {
    const found = nearestPlace(mesh, inputVertices, point);
    let sampled = Infinity;
    for (let face = 0; face < faces; face++) {
      for (let i = 0; i <= steps; i++) {
        for (let j = 0; i + j <= steps; j++) {
          const weights = [i / steps, j / steps, (steps - i - j) / steps];
          sampled = Math.min(sampled, away(placeIn(mesh, face, weights), point));
        }
      }
    }
    const place =
      'face' in found.point
        ? placeIn(mesh, found.point.face, found.point.weights)
        : 'vertex' in found.point
          ? ([...mesh.positions.subarray(3 * (found.point.vertex - 1000)).subarray(0, 3)] as Vector)
          : point;
    expect(away(place, point)).toBeCloseTo(found.away, 4);
    expect(found.away).toBeLessThanOrEqual(sampled);
    // Samples are so near to each other that none of them is much farther.
    expect(sampled - found.away).toBeLessThan(0.03);
  }
});

test('the coordinates of a vertex are that vertex of the file', () => {
  const mesh = sheet(5);
  const inputVertices = Uint32Array.from({ length: mesh.positions.length / 3 }, (_, vertex) => 7 * vertex);
  for (const vertex of [0, 13, 35]) {
    const [x, y, z] = mesh.positions.subarray(3 * vertex, 3 * vertex + 3);
    expect(nearestPlace(mesh, inputVertices, [x, y, z])).toEqual({ point: { vertex: 7 * vertex }, away: 0 });
  }
});

test('what is drawn is turned back into the axes and the unit of the file', () => {
  const place: Vector = [4.5, -3, 8];
  for (const up of UP.names) {
    const transform = { center: [1, 2, 3] as Vector, scale: 0.25, up };
    const drawn = drawnPlace(place, transform);
    filePlace(drawn, transform).forEach((value, k) => expect(value).toBeCloseTo(place[k], 12));
    const axis = [0, 0, 0].map((_, k) => (up.endsWith('xyz'[k]) ? (up.startsWith('-') ? -1 : 1) : 0));
    const upward = drawnPlace([1 + axis[0], 2 + axis[1], 3 + axis[2]], transform);
    expect(upward.map((value) => value + 0)).toEqual([0, 0.25, 0]);
  }
});
