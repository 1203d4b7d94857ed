import { expect, test } from '@playwright/test';
import {
  boundaryNear,
  boundaryThrough,
  componentOf,
  type Outlined,
  partOf,
  verticesOfPart,
} from '../../web/session/outlines';
import { MODEL, ofModel } from '../../web/length';
import { SOURCES } from '../../web/state/points';
import type { Source } from '../../web/protocol';
import {
  addSet,
  addSource,
  moveSource,
  removeSelected,
  selectedSet,
  setInitialDistance,
  setSource,
} from '../../web/state/edit';
import { isList, isNamedList, rowsOf } from '../../web/state/list';
import { Scene } from '../../web/state/history';
import { emptyScene } from '../../web/state/scene';
import { decodeSets, encodeSets, fitLink } from '../../web/state/sets';
import { allSources, onceEach, type SourceSet } from '../../web/state/sources';
import { pack } from '../../web/state/text';

const LINE: SourceSet = {
  shape: { kind: 'line', corners: [3, 1], closed: false },
  points: [{ vertex: 3 }, { vertex: 2 }, { vertex: 1 }],
  offset: 0,
};

const fresh = () => new Scene({ ...emptyScene({ kind: 'preset', id: 'bunny' }), sources: [{ vertex: 7 }] });

test('the solver is asked for all places of all sets, with their initial distances added', () => {
  const { state } = fresh();
  expect(allSources(state)).toBe(state.sources);
  const list: SourceSet = {
    shape: { kind: 'list', name: 'a' },
    points: [{ vertex: 4, offset: 1 }, { vertex: 5 }],
    offset: 0.5,
  };
  const both = { ...state, sets: [LINE, list] };
  expect(allSources(both)).toEqual([
    { vertex: 7 },
    { vertex: 3 },
    { vertex: 2 },
    { vertex: 1 },
    { vertex: 4, offset: 1.5 },
    { vertex: 5, offset: 0.5 },
  ]);
  // By which an answer is known to be that to the same question.
  expect(allSources({ ...both })).toBe(allSources(both));
  expect(allSources({ ...both, sources: [] })).toHaveLength(5);
});

test('a set is one step of undo, is selected, and is removed and moved by nothing else', () => {
  const scene = fresh();
  addSet(scene, LINE);
  expect(selectedSet(scene)).toBe(LINE);
  setInitialDistance(scene, 1, ofModel(2), {});
  expect(scene.state.sets[0].offset).toBe(2);
  moveSource(scene, 0, { vertex: 8 }, {});
  scene.undo();
  scene.undo();
  expect(scene.state.sets).toEqual([LINE]);
  scene.set({ selected: 1 });
  expect(removeSelected(scene)).toBe(true);
  expect(scene.state.sets).toEqual([]);
  scene.undo();
  expect(scene.state.sets).toEqual([LINE]);
  setSource(scene, { vertex: 9 });
  expect(allSources(scene.state)).toEqual([{ vertex: 9 }]);
});

test('a place that is given twice is one source, with its least initial distance', () => {
  const inFace: Source = { face: 3, weights: [0.5, 0.25, 0.25] };
  const again: Source = { face: 3, weights: [0.5, 0.25, 0.25] };
  const elsewhere: Source = { face: 3, weights: [0.25, 0.5, 0.25] };
  const given: Source[] = [
    { vertex: 5, offset: 2 },
    inFace,
    { vertex: 7 },
    { vertex: 5, offset: 1 },
    again,
    { vertex: 7, offset: 3 },
  ];
  expect(onceEach([inFace, elsewhere])).toEqual([inFace, elsewhere]);
  expect(onceEach(given)).toEqual([{ vertex: 5, offset: 1 }, inFace, { vertex: 7 }]);
  expect(SOURCES.parse('7,7,5@2,5')).toEqual([{ vertex: 7 }, { vertex: 5 }]);

  const scene = fresh();
  expect(addSource(scene, { vertex: 9 })).toBe(true);
  // It is selected, so that one sees where it is.
  expect(addSource(scene, { vertex: 7, offset: 1 })).toBe(false);
  expect(scene.state).toMatchObject({ sources: [{ vertex: 7 }, { vertex: 9 }], selected: 0 });
  expect(addSource(scene, { vertex: 9 })).toBe(false);
  expect(scene.state.selected).toBe(1);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 7 }]);
});

const SETS: readonly SourceSet[] = [
  { shape: { kind: 'line', corners: [12, 845, 99], closed: false }, points: [], offset: 0.5 },
  { shape: { kind: 'line', corners: [5], closed: true }, points: [], offset: 0 },
  {
    shape: { kind: 'stroke', closed: false },
    points: [
      { face: 88, weights: [0.25, 0.5, 0.25] },
      { face: 3, weights: [1, 0, 0], offset: 1.5 },
      { tetrahedron: 6, weights: [0.125, 0.25, 0.5, 0.125] },
    ],
    offset: 0,
  },
  { shape: { kind: 'stroke', closed: true }, points: [{ vertex: 3 }], offset: 0 },
  { shape: { kind: 'boundary', vertex: 33 }, points: [], offset: 0 },
  { shape: { kind: 'component', vertex: 0 }, points: [], offset: 0 },
  { shape: { kind: 'part', part: 1 }, points: [], offset: 0 },
  {
    shape: { kind: 'list', name: 'räume, 50 %: a@b.csv' },
    points: [{ vertex: 7, offset: 2 }, { vertex: 5 }],
    offset: 0,
  },
];

/** As an address is read: percent signs are escapes. */
const throughAddress = (text: string) => decodeSets(new URLSearchParams(`sets=${text}`).get('sets') ?? '');

test('sets survive the link, each and all', () => {
  for (const sets of [...SETS.map((set) => [set]), SETS]) {
    expect(throughAddress(encodeSets(sets))).toEqual(sets);
    expect(encodeSets(throughAddress(encodeSets(sets)) ?? [])).toBe(encodeSets(sets));
  }
  expect(encodeSets([])).toBe('');
  expect(encodeSets(SETS.slice(0, 1))).toBe('line:12-845-99@0.5');
});

test('weights are rounded once, and stay weights', () => {
  const shape = { kind: 'stroke', closed: false } as const;
  const third = { face: 1, weights: [1 / 3, 1 / 3, 1 / 3] as [number, number, number] };
  const edge = { face: 2, weights: [0.50005, 0.49995, 0] as [number, number, number] };
  const text = encodeSets([{ shape, points: [third, edge], offset: 0 }]);
  const [read] = decodeSets(text) ?? [];
  for (const point of read.points) {
    const weights = 'weights' in point ? point.weights : [];
    expect(weights.reduce((sum, weight) => sum + weight, 0)).toBeCloseTo(1, 12);
    expect(Math.min(...weights)).toBeGreaterThanOrEqual(0);
  }
  expect(encodeSets([read])).toBe(text);
});

test('ten thousand vertices make a link, and places that are too many for one do not', () => {
  const shape = { kind: 'list', name: 'points.csv' } as const;
  let seed = 1;
  const random = () => (seed = (seed * 48_271) % 2_147_483_647) / 2_147_483_647;
  // In the order of their numbers, as lists are kept: a fifth of the vertices of a mesh, chosen by lot.
  const all = Array.from({ length: 50_000 }, (_, vertex) => vertex);
  const vertices = all.filter(() => random() < 0.2).map((vertex) => ({ vertex }));
  expect(vertices.length).toBeGreaterThan(9800);
  const sets = [{ shape, points: vertices, offset: 0 }];
  expect(encodeSets(sets).length).toBeLessThan(9000);
  expect(throughAddress(encodeSets(sets))).toEqual(sets);
  const places = Array.from({ length: 10_000 }, (_, i) => {
    const [a, b] = [random() / 2, random() / 2];
    return { face: 7 * i, weights: [a, b, 1 - a - b] as [number, number, number] };
  });
  const many = [{ shape, points: places, offset: 0 }];
  expect(fitLink(sets)).toBe(true);
  expect(fitLink(many)).toBe(false);
  expect(encodeSets(many)).toBe('');
});

const packed = (plain: string) => `~${pack(new TextEncoder().encode(plain))}`;
const components = (count: number) => packed(Array.from({ length: count }, (_, i) => `component:${i}`).join(','));
const list = (count: number) => `list:a:${Array.from({ length: count }, () => 1).join('_')}`;

test('a link has a thousand sets and a hundred thousand places at most', () => {
  // What is too much is refused at once: a frozen page would take a minute.
  test.setTimeout(30_000);
  expect(decodeSets(components(1000))).toHaveLength(1000);
  expect(decodeSets(components(1001))).toBeUndefined();
  expect(decodeSets(packed('component:1,'.repeat(600_000)))).toBeUndefined();
  expect(decodeSets(packed(`line:${'1-'.repeat(4_000_000)}1`))).toBeUndefined();
  expect(decodeSets(packed([list(60_000), list(40_000)].join(',')))).toHaveLength(2);
  expect(decodeSets(packed([list(60_000), list(40_001)].join(',')))).toBeUndefined();
  expect(decodeSets(packed(`${list(99_999)},line:1-2`))).toBeUndefined();
});

for (const broken of [
  'line:',
  'line:1-x',
  'ring:1',
  'boundary:-1',
  'part:1:2',
  'list:5',
  'list:%E0%A4%A:5',
  'stroke:5/1',
  'stroke:5/9000/2000',
  'stroke:-5',
  'stroke:1*x',
  'line:1@-2',
  'line:1@2@3',
  '~',
  '~AAAA',
]) {
  test(`the sets ${broken} are refused`, () => expect(decodeSets(broken)).toBeUndefined());
}

test('rows are sources by vertex or by place, with an initial distance or without', () => {
  const named = rowsOf('a.csv', 'vertex,offset\n3,0.5\n\n4,\n', MODEL);
  expect(named.map(({ at }) => String(at))).toEqual(['a.csv, line 2', 'a.csv, line 4']);
  expect(named).toMatchObject([
    { place: { vertex: 3 }, offset: 0.5 },
    { place: { vertex: 4 }, offset: 0 },
  ]);
  expect(rowsOf('a.csv', '7', MODEL)).toMatchObject([{ place: { vertex: 7 }, offset: 0 }]);
  expect(rowsOf('a.csv', '1 -2e-3 .5\r\n1,2,3,4', MODEL)).toMatchObject([
    { place: { coordinates: [1, -0.002, 0.5] }, offset: 0 },
    { place: { coordinates: [1, 2, 3] }, offset: 4 },
  ]);
  // By its heading, in any order and with columns that are not needed.
  const [row] = rowsOf('a.csv', '"Z";"name";"X";"Y"\n3;a;1;2', MODEL);
  expect(row).toMatchObject({ place: { coordinates: [1, 2, 3] }, offset: 0 });
  expect(rowsOf('a.csv', 'points\n5', MODEL)).toMatchObject([{ place: { vertex: 5 }, offset: 0 }]);
});

for (const [text, said] of [
  ['vertex\n3\nx', 'a.csv, line 3: a vertex is a whole number'],
  ['1\n\n2.5', 'a.csv, line 3: a vertex is a whole number from 0 on, not “2.5”'],
  ['1\n-1', 'a.csv, line 2: a vertex'],
  ['1,2\n3,-4', 'a.csv, line 2: an initial distance'],
  ['1,2\n3,inf', 'a.csv, line 2: “3 inf” is no source'],
  ['x,y,z\n1,2', 'a.csv, line 2: x, y and z must be numbers'],
  ['1 2 3\n1 2 3 4 5', 'a.csv, line 2: “1 2 3 4 5” is no source'],
  ['x;y;z\n500100,5;4600100,5;300,0', 'a.csv, line 2: “500100,5” has a decimal comma; write a point'],
  ['vertex;offset\n5;10,5', 'a.csv, line 2: “10,5” has a decimal comma'],
  ['vertex,offset\n5,10,5', 'a.csv, line 2 has more cells than the first row has names'],
  ['vertex\n', 'a.csv has no sources'],
  ['-3', 'a.csv: a vertex'],
]) {
  test(`the list ${JSON.stringify(text)} is refused with its line`, () => {
    expect(() => rowsOf('a.csv', text, MODEL)).toThrow(said);
  });
}

test('only a heading makes a table that is dropped one of sources; what is pasted may do without', () => {
  for (const text of ['vertex,offset\n1,2', 'x,y,z\n1,2,3', 'v\n1']) expect(isNamedList(text)).toBe(true);
  for (const text of ['triangle,cost\n1,2', '1,2', 'face\n1', '']) expect(isNamedList(text)).toBe(false);
  for (const text of ['1', '1,2', '1 2 3', 'vertex\nx']) expect(isList(text)).toBe(true);
  for (const text of ['https://models.example/a.obj', 'some words', '1 2 3 4 5', '1,a', ''])
    expect(isList(text)).toBe(false);
});

/** Two squares in one plane, each of two triangles, the second one turned over, and what lies beside each triangle. */
const SQUARES: Outlined = {
  parts: [
    { name: 'left', triangles: 2, ranges: Uint32Array.of(0, 2) },
    { name: 'right', triangles: 2, ranges: Uint32Array.of(2, 4) },
  ],
  active: [0, 1],
  inputVertices: Uint32Array.of(10, 11, 12, 13, 10, 15, 16, 17, 18),
  surface: {
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 5, 0, 0, 6, 0, 0, 6, 1, 0, 5, 1, 0),
    triangles: Uint32Array.of(0, 1, 2, 4, 3, 2, 5, 6, 7, 5, 7, 8),
  },
  neighbors: Uint32Array.of(0, 0, 1, 1, 1, 0, 2, 2, 3, 2, 3, 3),
};

test('a boundary is walked in order, also across triangles that are turned over', () => {
  expect(boundaryThrough(SQUARES, 11)).toEqual([11, 12, 13, 10]);
  expect(boundaryThrough(SQUARES, 15).toSorted()).toEqual([15, 16, 17, 18]);
  expect(boundaryThrough(SQUARES, 99)).toEqual([]);
  expect(boundaryNear(SQUARES, [5.9, 0.1, 0])).toBe(16);
  const closed = { ...SQUARES, neighbors: SQUARES.neighbors.map((_, i) => (Math.floor(i / 3) + 1) % 4) };
  expect(boundaryNear(closed, [0, 0, 0])).toBeNull();
});

test('a component has each of its vertices once, and so has a part', () => {
  expect(componentOf(SQUARES, 13).toSorted()).toEqual([10, 11, 12, 13]);
  expect(componentOf(SQUARES, 17).toSorted()).toEqual([15, 16, 17, 18]);
  expect(componentOf(SQUARES, 99)).toEqual([]);
  expect([0, 1, 2, 3].map((face) => partOf(SQUARES, face))).toEqual([0, 0, 1, 1]);
  expect(verticesOfPart(SQUARES, 1).toSorted()).toEqual([15, 16, 17, 18]);
  const welded = {
    ...SQUARES,
    parts: [{ name: 'left', triangles: 3, ranges: Uint32Array.of(0, 3) }, SQUARES.parts[1]],
  };
  expect(partOf(welded, 0)).toBeNull();
  expect(verticesOfPart(welded, 0)).toEqual([]);
});

test('parts of which the file has triangles by turns keep what is theirs', () => {
  const turns = {
    ...SQUARES,
    parts: [
      { name: 'ends', triangles: 2, ranges: Uint32Array.of(0, 1, 4, 5) },
      { name: 'inactive', triangles: 1, ranges: Uint32Array.of(1, 2) },
      { name: 'middle', triangles: 2, ranges: Uint32Array.of(2, 4) },
    ],
    active: [0, 2],
  };
  expect([0, 1, 2, 3].map((face) => partOf(turns, face))).toEqual([0, 2, 2, 0]);
});
