import { expect, test } from '@playwright/test';
import { colourOfCell, linearColourOfCell } from '../../web/state/cells';
import { areaOfTriangle, cornersOf, distance, vectorsIn } from '../../web/state/vector';
import { colouredCells } from '../../web/view/cells';
import { ofModel } from '../../web/length';

/** A square of side 1 in two triangles; of the first a quarter belongs to the second cell. */
const TRIANGLES = Uint32Array.of(0, 1, 2, 0, 2, 3);
const POSE = {
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0),
  normals: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1),
};
const FOUND = {
  areas: [ofModel<2>(7 / 8), ofModel<2>(1 / 8)],
  ends: new Float32Array(),
  tiles: Uint32Array.of(1, 0, 0, 0, 0, 0, 0, 1),
  corners: Float32Array.from(
    [
      [0, 1, 0, 0, 0.5, 0.5, 0.5, 0.5, 0],
      [0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0, 1],
      [0.5, 0.5, 0, 0, 0, 1, 1, 0, 0],
      [1, 0, 0, 0, 1, 0, 0, 0, 1],
    ].flat(),
  ),
};

const isCorner = ([x, y]: readonly number[]) => [x, y].every((at) => at === 0 || at === 1);

test('cells are a mesh above the surface, with a vertex for each corner and cell', () => {
  const { mesh, materials } = colouredCells({ triangles: TRIANGLES }, POSE, FOUND, 1, false);
  const { positions, triangles, colors, runs } = mesh;
  const places = vectorsIn(positions);
  expect(materials).toHaveLength(1);
  expect([...runs]).toEqual([0, 4, 0]);
  const areaOf = (face: number) => areaOfTriangle(cornersOf(positions, triangles, face));
  expect([0, 1, 2, 3].map(areaOf).reduce((sum, area) => sum + area)).toBeCloseTo(1, 6);
  for (const [, , z] of places) expect(z).toBeGreaterThan(1e-5);
  // Corners of the surface are shared within a cell: four of them; of the border, each tile has its own.
  expect(places.filter(isCorner)).toHaveLength(4);
  const red = (vertex: number) => colors[4 * vertex];
  expect(new Set([...triangles.subarray(0, 3)].map(red)).size).toBe(1);
  expect(red(triangles[0] ?? -1)).not.toBe(red(triangles[3] ?? -1));
  const open = colouredCells({ triangles: TRIANGLES }, POSE, FOUND, 1, true).mesh;
  expect(open.positions).toHaveLength(2 * positions.length);
  expect(vectorsIn(open.positions).filter(([, , z]) => z < 0)).toHaveLength(places.length);
});

test('colors of cells are apart, and stay in gamut', () => {
  const colours = Array.from({ length: 12 }, (_, cell) => linearColourOfCell(cell));
  for (const [i, one] of colours.entries()) {
    for (const value of one) expect(value).toBeGreaterThan(0);
    for (const value of one) expect(value).toBeLessThan(1);
    for (const other of colours.slice(0, i)) expect(distance(one, other)).toBeGreaterThan(0.03);
  }
  expect(colourOfCell(0)).toMatch(/^rgb\(\d+ \d+ \d+\)$/);
});
