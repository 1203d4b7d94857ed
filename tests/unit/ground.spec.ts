import { expect, test } from '@playwright/test';
import { codesOfRows, codesOfVertices } from '../../web/state/costs';
import { BRUSH } from '../../web/state/brush';
import {
  CLOSED_GATE,
  codeOf,
  costOf,
  decodeGround,
  encodeGround,
  fits,
  type Ground,
  isWeighted,
  LEVEL,
  OPEN_GATE,
  WALL,
} from '../../web/state/ground';
import { areaOf, Stroke, type Terrain, toggled, touched } from '../../web/state/painting';

test('costs survive their codes: powers of two exactly, others to three per cent', () => {
  for (const cost of [0.25, 0.5, 1, 2, 4, 64]) expect(costOf(codeOf(cost))).toBe(cost);
  for (const cost of [0.001, 0.03, 0.7, 3, 17, 999, 1000])
    expect(Math.abs(costOf(codeOf(cost)) / cost - 1)).toBeLessThan(0.03);
  for (let code = 0; code < 256; code++) expect(costOf(code)).toBeGreaterThanOrEqual(0.001);
  expect([WALL, CLOSED_GATE, OPEN_GATE].map(costOf)).toEqual([Infinity, Infinity, 1]);
});

test('the ground survives the link, however it is painted', () => {
  const faces = Uint8Array.from({ length: 5000 }, (_, i) => (i % 7 === 0 ? WALL : i < 2500 ? codeOf(4) : 0));
  const lines = [
    { vertices: [5, 900_000, 3], open: true },
    { vertices: [0, 1], open: false },
  ];
  for (const ground of [
    { faces, lines },
    { faces, lines: [] },
    { faces: LEVEL.faces, lines },
  ]) {
    expect(decodeGround(encodeGround({ ...LEVEL, ...ground }))).toEqual(ground);
  }
  expect(encodeGround(LEVEL)).toBe('');
  expect(decodeGround('')).toEqual({ faces: LEVEL.faces, lines: [] });
});

test('an area of a large mesh is short in the link', () => {
  const faces = new Uint8Array(47_000).fill(codeOf(4), 10_000, 12_000);
  expect(encodeGround({ ...LEVEL, faces }).length).toBeLessThan(40);
});

test('text that is no ground is refused', () => {
  const text = encodeGround({ ...LEVEL, faces: new Uint8Array(100).fill(WALL) });
  for (const broken of ['a', '!!!!', text.slice(0, -3), 'AAAAAAAA']) expect(decodeGround(broken)).toBeUndefined();
});

test('a ground fits a mesh of as many triangles that has the vertices of its walls', () => {
  const faces = new Uint8Array(4).fill(WALL);
  const lines = [{ vertices: [7, 8], open: false }];
  expect(fits({ ...LEVEL, faces, lines }, { triangles: 4, inputVertices: 9 })).toBe(true);
  expect(fits({ ...LEVEL, faces }, { triangles: 5, inputVertices: 9 })).toBe(false);
  expect(fits({ ...LEVEL, lines }, { triangles: 4, inputVertices: 8 })).toBe(false);
});

const of = (faces: number[], change: Partial<Ground> = {}) =>
  isWeighted({ ...LEVEL, ...change, faces: Uint8Array.from(faces) });

test('costs differ where one does, whatever walls there are', () => {
  expect(of([])).toBe(false);
  expect(of([0, WALL, OPEN_GATE])).toBe(false);
  expect(of([codeOf(4), codeOf(4), WALL])).toBe(false);
  expect(of([codeOf(4), 0])).toBe(true);
  expect(of([], { slope: true })).toBe(true);
  expect(of([], { highest: 2 })).toBe(true);
});

/** A strip of so many unit squares along x, each of two triangles. */
function strip(squares: number): Terrain {
  const positions = Array.from({ length: squares + 1 }, (_, x) => [x, 0, 0, x, 1, 0]).flat();
  const triangles = Array.from({ length: squares }, (_, x) => [
    2 * x,
    2 * x + 2,
    2 * x + 1,
    2 * x + 2,
    2 * x + 3,
    2 * x + 1,
  ]);
  const neighbors = Array.from({ length: 2 * squares }, (_, face) => [face - 1, face, face + 1]).flat();
  const inside = (face: number) => Math.min(2 * squares - 1, Math.max(0, face));
  return {
    positions: Float32Array.from(positions),
    triangles: Uint32Array.from(triangles.flat()),
    neighbors: Uint32Array.from(neighbors, inside),
  };
}

test('a disc covers what it touches around its middle', () => {
  const terrain = strip(10);
  const found = touched(terrain, { face: 8, center: [4.2, 0.2, 0], radius: 0.9 });
  expect([...found.keys()].toSorted((a, b) => a - b)).toEqual([6, 7, 8, 9, 10]);
  expect(found.get(8)).toBe(0);
  expect(found.get(6)).toBeCloseTo(0.2 * Math.SQRT2, 6);
});

test('a stroke paints each place once, and fades at its soft edge', () => {
  const terrain = strip(10);
  const brush = { ...BRUSH, soft: 1 };
  const stroke = new Stroke(LEVEL, 20, brush);
  const disc = { face: 8, center: [4.3, 0.3, 0] as [number, number, number], radius: 3 };
  const once = stroke.paint(LEVEL, terrain, disc);
  expect(stroke.paint(once, terrain, disc)).toEqual(once);
  expect(costOf(once.faces[8])).toBe(4);
  const [near, far] = [costOf(once.faces[10]), costOf(once.faces[13])];
  expect(near).toBeLessThan(4);
  expect(far).toBeLessThan(near);
  expect(far).toBeGreaterThanOrEqual(1);
});

test('the eraser leaves the ground as if it had never been painted', () => {
  const terrain = strip(10);
  const disc = { face: 8, center: [5, 0.5, 0] as [number, number, number], radius: 100 };
  const mud = new Stroke(LEVEL, 20, BRUSH).paint(LEVEL, terrain, disc);
  expect(mud.faces.every((code) => costOf(code) === 4)).toBe(true);
  const erased = new Stroke(mud, 20, { ...BRUSH, material: 'eraser' }).paint(mud, terrain, disc);
  expect(erased.faces).toHaveLength(0);
});

test('a gate opens and closes with all of its area', () => {
  const { neighbors } = strip(5);
  const faces = Uint8Array.from([0, WALL, WALL, 0, 0, CLOSED_GATE, 0, 0, 0, 0]);
  const ground = { ...LEVEL, faces };
  expect(areaOf(neighbors, faces, 1)).toEqual([1, 2]);
  const opened = toggled(ground, neighbors, 2);
  expect(opened?.faces).toEqual(Uint8Array.from([0, OPEN_GATE, OPEN_GATE, 0, 0, CLOSED_GATE, 0, 0, 0, 0]));
  expect(opened && toggled(opened, neighbors, 1)?.faces[2]).toBe(CLOSED_GATE);
  expect(toggled(ground, neighbors, 0)).toBeNull();
});

test('rows of a file are costs and walls, and what is none is named by its line', () => {
  const codes = codesOfRows('costs.csv', 'face,cost\n0,2\r\n\n3,0.5\n1\n4,inf\n', 6);
  expect(Array.from(codes, costOf)).toEqual([2, Infinity, 1, 0.5, Infinity, 1]);
  for (const [text, sentence] of [
    ['0,2\n6,1', 'costs.csv, line 2: there is no triangle 6'],
    ['0,2\n1.5,1', 'costs.csv, line 2: there is no triangle 1.5'],
    ['0,0', 'costs.csv, line 1: a cost is 0'],
    ['0,-3', 'costs.csv, line 1: a cost is -3'],
    ['0,1e4', 'costs.csv, line 1: a cost is 10000'],
    ['0,1\nmud,2', 'costs.csv, line 2: give a triangle'],
    ['0,1\n1,2,3', 'costs.csv, line 2: give a triangle'],
    ['0,1\n1,', 'costs.csv, line 2: give a triangle'],
  ] as const) {
    expect(() => codesOfRows('costs.csv', text, 6)).toThrow(sentence);
  }
});

test('numbers of vertices cost triangles their mean', () => {
  const codes = codesOfVertices('weight', Float32Array.of(1, 2, 3, 8), Uint32Array.of(0, 1, 2, 1, 2, 3));
  expect(costOf(codes[0])).toBe(2);
  expect(costOf(codes[1]) / (13 / 3)).toBeCloseTo(1, 1);
  expect(() => codesOfVertices('weight', Float32Array.of(1, Number.NaN, 1), Uint32Array.of(0, 1, 2))).toThrow(
    'The cost by weight at triangle 0',
  );
});
