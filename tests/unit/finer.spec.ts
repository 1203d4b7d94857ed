import { expect, test } from '@playwright/test';
import type { DrawnSurface, DrawMesh, TrianglePlaces } from '../../web/protocol';
import { divided } from '../../web/solver/finer';
import {
  areaOfTriangle,
  cornersOf,
  distance,
  dot,
  minus,
  normalized,
  type Triangle,
  type Vector,
  vectorAt,
  vectorsIn,
  weighted,
} from '../../web/state/vector';
import { drawingFiner, gradientsOn } from '../../web/view/finer';
import type { Hit, Viewer } from '../../web/wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';

const NORMAL = [0, 0, 1];

/** Two triangles of a square of side 2, each of its own material, and beside it a small one of a third. */
const PLATE: DrawMesh = {
  positions: Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 1, 1.05, 0),
  normals: Float32Array.from([NORMAL, NORMAL, NORMAL, NORMAL, NORMAL].flat()),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 3, 2, 4),
  texcoords: new Float32Array(),
  colors: Uint16Array.from({ length: 20 }, (_, i) => 100 * Math.floor(i / 4)),
  runs: Uint32Array.of(0, 1, 7, 1, 2, 8, 2, 3, 9),
  order: Uint32Array.of(0, 1, 2),
  boxes: new Float32Array(6),
};

const trianglesOf = ({ positions, triangles }: DrawMesh) =>
  Array.from({ length: triangles.length / 3 }, (_, face) => cornersOf(positions, triangles, face));

const areaOf = (triangles: Triangle[]) => triangles.reduce((sum, triangle) => sum + areaOfTriangle(triangle), 0);

const isAt = (one: Vector, other: Vector) => distance(one, other) < 1e-6;

const isOnRim = (place: Vector) => Math.max(...place.map(Math.abs)) >= 1;

test('a coarse surface is divided without gaps, and knows where its parts are', () => {
  const { finer, places } = divided(PLATE);
  const { mesh, middles, origins, weights } = finer;
  const whole = trianglesOf(PLATE);
  const parts = trianglesOf(mesh);
  expect(parts.length).toBeGreaterThan(1000);
  expect(areaOf(parts)).toBeCloseTo(areaOf(whole), 5);
  // Each part lies in its triangle, where it says.
  const lies = parts.map((corners, part) =>
    corners.every((corner, k) => isAt(weighted(whole[origins[part]], vectorAt(weights, 3 * part + k)), corner)),
  );
  expect(lies).not.toContain(false);
  // So do the places of the middles, which are vertices after those of the surface.
  const vertices = PLATE.positions.length / 3;
  expect(mesh.positions.length / 3).toBe(vertices + middles.length / 2);
  const placesOf = (of: TrianglePlaces) =>
    Array.from(of.triangles, (triangle, place) => weighted(whole[triangle], vectorAt(of.weights, place)));
  const areThere = placesOf(places.middles).map((at, edge) => isAt(at, vectorAt(mesh.positions, vertices + edge)));
  expect(areThere).toHaveLength(middles.length / 2);
  expect(areThere).not.toContain(false);
  // Each corner of a part is a place of its own triangle.
  const corners = placesOf(places.corners);
  expect(corners.length).toBeLessThan(mesh.triangles.length / 2);
  const meet = Array.from(places.ofCorners, (place, corner) => {
    const isOwn = places.corners.triangles[place] === origins[Math.floor(corner / 3)];
    return isOwn && isAt(corners[place], vectorAt(mesh.positions, mesh.triangles[corner]));
  });
  expect(meet).toHaveLength(mesh.triangles.length);
  expect(meet).not.toContain(false);
  // No edge is long, and all but those of the rim have two sides: nothing comes apart.
  const sides = new Map<string, number>();
  for (const [a, b, c] of vectorsIn(mesh.triangles)) {
    for (const ends of [
      [a, b],
      [b, c],
      [c, a],
    ]) {
      const key = ends.toSorted((one, other) => one - other).join();
      sides.set(key, (sides.get(key) ?? 0) + 1);
    }
  }
  const ends = [...sides.keys()].map((key) => key.split(',').map((vertex) => vectorAt(mesh.positions, Number(vertex))));
  expect(Math.max(...ends.map(([one, other]) => distance(one, other)))).toBeLessThan(0.05 + 1e-6);
  const counts = [...sides.values()];
  expect(counts.every((count) => count <= 2)).toBe(true);
  const onRim = ends.filter((_, side) => counts[side] === 1);
  expect(onRim.every((both) => both.every(isOnRim))).toBe(true);
});

test('parts keep the material of their triangle', () => {
  const { mesh, origins } = divided(PLATE).finer;
  const runs = [0, 1, 2].map((run) => vectorAt(mesh.runs, run));
  expect(runs.map(([, , material]) => material)).toEqual([7, 8, 9]);
  runs.forEach(([from, to], triangle) => expect(new Set(origins.subarray(from, to))).toEqual(new Set([triangle])));
  expect([runs[0][0], runs[2][1]]).toEqual([0, origins.length]);
  expect(mesh.colors.length / 4).toBe(mesh.positions.length / 3);
});

test('the renderer of a coarse surface is given what is on its parts', () => {
  const { finer } = divided(PLATE);
  const { mesh, middles, origins } = finer;
  const calls = new Map<string, unknown[]>();
  const note =
    (name: string) =>
    (...given: unknown[]) =>
      void calls.set(name, given);
  const hit = {
    triangle: 5,
    weights: Float32Array.of(0, 1, 0),
    is_on_section: false,
    point: 'there',
    free: note('free'),
  };
  const renderer = drawingFiner({
    set_surface: note('surface'),
    set_field: note('field'),
    set_tints: note('tints'),
    set_arrows: note('arrows'),
    pick: () => hit,
    frame: note('frame'),
  } as unknown as Viewer);
  const surface: DrawnSurface = { ...PLATE, finer };
  const given = (name: string) => calls.get(name) ?? [];

  renderer.set_surface(surface, null);
  expect(given('surface')[0]).toBe(mesh);
  renderer.frame(true);
  expect(given('frame')).toEqual([true]);

  // By vertices: middles lie between, or are given.
  const [values, tangents] = [Float32Array.of(0, 2, 4, 6, Infinity), new Int8Array(20).fill(50)];
  renderer.set_field(values, tangents, 6, false);
  const [spread, directions] = given('field') as [Float32Array, Int8Array];
  expect(spread).toHaveLength(mesh.positions.length / 3);
  expect(directions).toHaveLength(4 * spread.length);
  expect(spread[5]).toBe((spread[middles[0]] + spread[middles[1]]) / 2);
  const exact = Float32Array.from(spread, (_, i) => i);
  renderer.set_field(exact, tangents, 6, false);
  expect(given('field')[0]).toBe(exact);

  // By corners, each triangle on its own; unreached ones do not reach into others.
  const atCorners = Float32Array.of(0, 1, 2, 5, 5, 5, Infinity, Infinity, Infinity);
  renderer.set_field(atCorners, new Int8Array(36), 6, true);
  const [ofCorners] = given('field') as [Float32Array];
  expect(ofCorners).toHaveLength(mesh.triangles.length);
  const valuesIn = (triangle: number) => [...ofCorners].filter((_, i) => origins[Math.floor(i / 3)] === triangle);
  expect(valuesIn(1).every((value) => Math.abs(value - 5) < 1e-6)).toBe(true);
  expect(new Set(valuesIn(2))).toEqual(new Set([Infinity]));

  renderer.set_tints(
    surface,
    Uint8Array.from({ length: 12 }, (_, i) => Math.floor(i / 4)),
  );
  const [tinted, tints] = given('tints') as [DrawMesh, Uint8Array];
  expect(tinted).toBe(mesh);
  expect(Uint32Array.from(origins, (_, part) => tints[4 * part + 3])).toEqual(origins);
  renderer.set_arrows(new Float32Array());
  expect(given('arrows')).toEqual([new Float32Array()]);

  // Of distances from a corner, arrows lead away from it.
  const rays = Float32Array.from(vectorsIn(mesh.positions), (place) => distance(place, [-1, -1, 0]));
  const gradients = gradientsOn(finer, rays, false);
  renderer.set_arrows(gradients);
  expect(given('arrows')[0]).toBe(gradients);
  const turned = trianglesOf(mesh).map((corners, part) => {
    const away = minus(weighted(corners, [1 / 3, 1 / 3, 1 / 3]), [-1, -1, 0]);
    return dot(normalized(away), normalized(vectorAt(gradients, part)));
  });
  expect(Math.min(...turned.slice(20))).toBeGreaterThan(0.9);
  renderer.set_arrows(Float32Array.of(0, 0, 0, 1, 2, 3, 0, 0, 0));
  expect([...vectorAt(given('arrows')[0] as Float32Array, origins.indexOf(1))]).toEqual([1, 2, 3]);

  // What is met is told as a place of the surface.
  const met = renderer.pick(1, 2) as Hit;
  expect(met.triangle).toBe(origins[5]);
  const corner = mesh.triangles[3 * 5 + 1];
  const place = weighted(cornersOf(PLATE.positions, PLATE.triangles, met.triangle), vectorAt(met.weights, 0));
  expect(distance(place, vectorAt(mesh.positions, corner))).toBeLessThan(1e-6);
  expect(met.point).toBe('there');
  met.free();
  expect(calls.has('free')).toBe(true);

  // Any other surface is drawn as it is.
  renderer.set_surface(PLATE, null);
  renderer.set_field(values, tangents, 6, false);
  expect(given('surface')[0]).toBe(PLATE);
  expect(given('field')[0]).toBe(values);
  expect(renderer.pick(1, 2)).toBe(hit);
});
