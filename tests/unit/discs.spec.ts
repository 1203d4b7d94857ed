import { expect, test } from '@playwright/test';
import { discsOf, SIDES } from '../../web/solver/discs';
import { drawingDiscs } from '../../web/view/discs';
import type { DrawMesh, DrawnSurface } from '../../web/protocol';
import { entry } from '../../web/state/entry';
import { dot, minus, vectorAt, vectorsIn, weighted, cornersOf } from '../../web/state/vector';
import type { Viewer } from '../../web/wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';
import { grid, type Mesh, sphere } from '../fixtures';

function drawn({ positions, triangles }: Mesh): DrawMesh {
  return {
    positions: Float32Array.from(positions.flat()),
    normals: Float32Array.from(positions.flatMap(() => [0, 0, 1])),
    triangles: Uint32Array.from(triangles.flat()),
    texcoords: new Float32Array(),
    colors: Uint16Array.from(positions.flatMap((_, point) => [point, 0, 0, 65_535])),
    runs: new Uint32Array(),
    order: Uint32Array.from(triangles.keys()),
    boxes: new Float32Array(),
  };
}

const points = ({ positions }: Mesh) => Uint32Array.from(positions.keys());

test('each point has a disc of its color around it, in the plane of its triangles', () => {
  const ball = sphere(8);
  const { mesh } = discsOf(drawn(ball), points(ball));
  const corners = SIDES + 1;
  expect(mesh.positions.length).toBe(3 * corners * ball.positions.length);
  expect(mesh.triangles.length).toBe(3 * SIDES * ball.positions.length);
  const seen = new Set<number>();
  for (let disc = 0; disc < ball.positions.length; disc++) {
    const middle = vectorAt(mesh.positions, corners * disc);
    const normal = vectorAt(mesh.normals, corners * disc);
    // The outside of a ball is away from its middle.
    expect(dot(normal, middle)).toBeGreaterThan(0.95);
    seen.add(entry(mesh.colors, 4 * corners * disc));
    const radii = Array.from({ length: SIDES }, (_, k) => {
      const spoke = minus(vectorAt(mesh.positions, corners * disc + k + 1), middle);
      expect(dot(spoke, normal)).toBeCloseTo(0, 6);
      return Math.hypot(...spoke);
    });
    expect(Math.max(...radii) - Math.min(...radii)).toBeLessThan(1e-6);
    expect(radii[0]).toBeGreaterThan(0.05);
    expect(radii[0]).toBeLessThan(0.5);
  }
  expect(seen.size).toBe(ball.positions.length);
});

test('places on discs are those of the surface beneath, and none is beyond its border', () => {
  const square = grid(6);
  const surface = drawn(square);
  const { mesh, triangles, weights } = discsOf(surface, points(square));
  vectorsIn(mesh.positions).forEach(([x, y], vertex) => {
    const shares = vectorAt(weights, vertex);
    expect(shares[0] + shares[1] + shares[2]).toBeCloseTo(1, 6);
    expect(Math.min(...shares)).toBeGreaterThanOrEqual(0);
    const place = weighted(cornersOf(surface.positions, surface.triangles, entry(triangles, vertex)), shares);
    // A disc may reach beyond the triangles around its point, a little beside a diagonal, and by its radius at the border.
    const isInside = Math.min(x, y, 1 - x, 1 - y) >= 0;
    expect(Math.hypot(place[0] - x, place[1] - y)).toBeLessThan(isInside ? 0.03 : 0.15);
    expect(Math.min(...place.slice(0, 2), ...place.slice(0, 2).map((at) => 1 - at))).toBeGreaterThan(-1e-6);
  });
});

test('boxes hold their discs, and those below', () => {
  const ball = sphere(6);
  const { mesh } = discsOf(drawn(ball), points(ball));
  const inner = ball.positions.length - 1;
  const box = (node: number) => [vectorAt(mesh.boxes, 2 * node), vectorAt(mesh.boxes, 2 * node + 1)] as const;
  const isIn = (place: readonly number[], [low, high]: ReturnType<typeof box>) =>
    place.every((at, axis) => entry(low, axis) <= at && at <= entry(high, axis));
  vectorsIn(mesh.positions).forEach((place, vertex) =>
    expect(isIn(place, box(inner + Math.floor(vertex / (SIDES + 1))))).toBe(true),
  );
  for (let node = 1; node < mesh.boxes.length / 6; node++) {
    const [low, high] = box(node);
    expect(isIn(low, box((node - 1) >> 1)) && isIn(high, box((node - 1) >> 1))).toBe(true);
  }
});

/** A renderer that keeps what it is given, and hits a triangle. */
function noting(triangle = 0, pick?: (x: number) => object | undefined) {
  const given: Record<string, unknown[]> = {};
  const note =
    (name: string) =>
    (...values: unknown[]) =>
      (given[name] = values);
  const hit = {
    triangle,
    weights: Float32Array.of(0.2, 0.3, 0.5),
    point: Float32Array.of(9, 9, 9),
    normal: Float32Array.of(0, 0, 1),
    free: () => 0,
  };
  const calls = ['set_surface', 'set_field', 'set_other_field', 'set_tints', 'set_arrows'];
  const viewer = {
    ...Object.fromEntries(calls.map((name) => [name, note(name)])),
    camera: () => [0, 0],
    pick: pick ?? (() => hit),
  };
  return { given, hit, viewer: drawingDiscs(viewer as unknown as Viewer) };
}

function cloud(): DrawnSurface & Required<Pick<DrawnSurface, 'discs'>> {
  const square = grid(2);
  const surface = drawn(square);
  return { ...surface, discs: discsOf(surface, points(square)) };
}

test('what vertices and corners of the surface have is given to the discs', () => {
  const surface = cloud();
  const { mesh, weights, triangles } = surface.discs;
  const { given, viewer } = noting();
  viewer.set_surface(surface, null as never);
  expect(given['set_surface']?.[0]).toBe(mesh);
  const values = Float32Array.from({ length: 9 }, (_, vertex) => entry(surface.positions, 3 * vertex));
  viewer.set_field(values, new Int8Array(36).fill(100), 1, false);
  const [spread, tangents] = given['set_field'] as [Float32Array, Int8Array];
  expect(tangents.length).toBe(4 * spread.length);
  const corner = (vertex: number, k: number) => entry(surface.triangles, 3 * entry(triangles, vertex) + k);
  spread.forEach((value, vertex) => {
    const expected = [0, 1, 2].reduce(
      (sum, k) => sum + entry(weights, 3 * vertex + k) * entry(values, corner(vertex, k)),
      0,
    );
    expect(value).toBeCloseTo(expected, 5);
  });
  // Of corners all alike, with what no source reaches.
  const byCorner = new Float32Array(surface.triangles.length).fill(Infinity);
  viewer.set_field(byCorner, new Int8Array(4 * byCorner.length), 1, true);
  const [ofCorners] = given['set_field'] as [Float32Array];
  expect(ofCorners.length).toBe(mesh.triangles.length);
  expect(ofCorners.every((value) => value === Infinity)).toBe(true);
  viewer.set_arrows(Float32Array.from({ length: surface.triangles.length }, () => 1));
  const [arrows] = given['set_arrows'] as [Float32Array];
  expect(vectorsIn(arrows).filter(([x]) => x === 1).length).toBe(9);
  const tints = Uint8Array.from({ length: (4 * surface.triangles.length) / 3 }, (_, i) => Math.floor(i / 4));
  viewer.set_tints(surface, tints);
  const [, ofDiscs] = given['set_tints'] as [DrawMesh, Uint8Array];
  expect(ofDiscs.length).toBe((4 * mesh.triangles.length) / 3);
});

test('a press on a disc takes its point, and on the surface the place', () => {
  const surface = cloud();
  for (let triangle = 0; triangle < 9 * SIDES; triangle++) {
    const { viewer } = noting(triangle);
    viewer.set_surface(surface, null as never);
    const hit = viewer.pick(0, 0);
    const k = hit?.weights.indexOf(1) ?? -1;
    const drawnVertex = entry(surface.triangles, 3 * (hit?.triangle ?? 0) + k);
    expect([...(hit?.point ?? [])]).toEqual(vectorAt(surface.positions, drawnVertex));
    const { discs: _, ...joined } = surface;
    viewer.set_surface(joined, null as never);
    expect(viewer.pick(0, 0)?.triangle).toBe(triangle);
  }
});

const facing = (z: number, triangle: number) => ({ ...noting(triangle).hit, normal: Float32Array.of(0, 0, z) });

test('a press on a gap takes a disc beside it, not the inside behind', () => {
  const surface = cloud();
  // From 3 pixels on to the right of the gap there is a disc that faces the eye; behind the gap one that does not, or nothing.
  for (const [behind, isSeen] of [
    [facing(-1, 0), true],
    [undefined, true],
    [facing(-1, 0), false],
  ] as const) {
    const { viewer } = noting(0, (x) => (isSeen && x >= 3 ? facing(1, 4 * SIDES) : behind));
    viewer.set_surface(surface, null as never);
    const point = viewer.pick(0, 0)?.point;
    const expected = vectorAt(surface.discs.mesh.positions, isSeen ? 4 * (SIDES + 1) : 0);
    expect([...(point ?? [])]).toEqual(expected);
  }
});
