import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { MODEL, ofModel } from '../../web/length';
import { pathFile, towardEye, trackPoints, tracksFile } from '../../web/session/export';
import { commandLines, type Measured, pythonLines } from '../../web/state/reproduce';
import { emptyScene } from '../../web/state/scene';
import { rustLines } from '../../web/state/rust';
import type { Vector } from '../../web/state/vector';
import { complaints } from '../gltf';

const REPORT = { degenerateFaces: 0, duplicateFaces: 0, flippedFaces: 0 } as Measured['opened']['report'];
const field = (exactBelow: number, windows?: number): Measured['field'] => ({
  exactBelow: ofModel(exactBelow),
  windows,
  timeFactor: 1,
  refineMs: 0,
});
const STATE = { ...emptyScene({ kind: 'preset', id: 'torus' }), sources: [{ vertex: 7 }] };
const MEASURED: Measured = {
  state: STATE,
  mesh: 'shape:torus',
  origin: null,
  opened: {
    simplified: null,
    interior: null,
    report: REPORT,
    active: [0],
    parts: [{ name: 'torus', triangles: 2, ranges: Uint32Array.of(0, 2) }],
    clips: [],
    drawTransform: { center: [0, 0, 0], scale: 1, up: 'z' },
  },
  field: field(Infinity),
  unit: MODEL,
};

test('the command line names the mesh, the sources and what found the distances', () => {
  expect(commandLines(MEASURED)).toBe('heatwalk distance shape:torus --source 7 --method exact --output distances.csv');
  const parameters = { ...STATE.parameters, timeStep: 10, exactRadius: Infinity };
  const sources = [{ face: 3, weights: [0.25, 0.25, 0.5] as [number, number, number], offset: 2 }];
  const state = { ...STATE, parameters, sources, links: 1, parts: [1] };
  // Its triangles are those of the file from 2 on, but for two.
  const [torus] = MEASURED.opened.parts;
  const other = { name: 'other', triangles: 4, ranges: Uint32Array.of(2, 4, 6, 8) };
  const opened = { ...MEASURED.opened, active: [1], parts: [torus, other] };
  const asked = {
    ...MEASURED,
    state,
    opened,
    mesh: "a cow's.obj",
    field: field(0),
  };
  expect(commandLines(asked)).toBe(
    String.raw`heatwalk distance 'a cow'\''s.obj' --part 1 --source 7:0.25,0.25,0.5@2 --link 1 --method heat --t 10 --near inf --output distances.csv`,
  );
  expect(commandLines({ ...MEASURED, field: field(1, 2) })).toContain('--method propagation --windows 2');
  expect(pythonLines(MEASURED)).toContain('subprocess.run(["heatwalk", "distance", "shape:torus", "--source", "7", ');
  const dashed = commandLines({ ...MEASURED, mesh: '-#.obj' });
  expect(dashed).toContain("heatwalk distance './-#.obj' ");
});

test('what the program cannot be asked for is refused with the reason', () => {
  const painted = { ...STATE, ground: { ...STATE.ground, slope: true } };
  expect(() => rustLines({ ...MEASURED, state: painted })).toThrow('without costs and walls');
  const dropped = { ...MEASURED.opened, report: { ...REPORT, flippedFaces: 1 } };
  const inside = { ...STATE, sources: [{ face: 0, weights: [1, 0, 0] as [number, number, number] }] };
  expect(() => commandLines({ ...MEASURED, state: inside, opened: dropped })).toThrow('only found again at vertices');
});

test('what costs more is in files that the lines write, and what the program does not know in a comment', () => {
  // Of four triangles, the second costs 2, the third is a wall, the fourth an open gate.
  const faces = Uint8Array.of(0, 140, 255, 253);
  const lines = [
    { vertices: [4, 5, 9], open: false },
    { vertices: [1, 2], open: true },
  ];
  const ground = { ...STATE.ground, faces, lines, slope: true, highest: 3 };
  const measured = {
    ...MEASURED,
    state: { ...STATE, ground, method: 'auto' as const, unit: 'mm' as const },
    field: field(1, 4),
  };
  expect(commandLines(measured).split('\n')).toEqual([
    "cat > weights.csv <<'END'",
    'triangle,cost',
    '1,2',
    'END',
    "cat > walls.csv <<'END'",
    'wall',
    '2',
    '4,5',
    '5,9',
    'END',
    'heatwalk distance shape:torus --unit mm --source 7 --weights weights.csv --walls walls.csv --slope-cost tobler --height-cost 3 --up z ' +
      '--method propagation --windows 4 --output distances.csv',
  ]);
  expect(pythonLines(measured)).toContain(String.raw`write_text("triangle,cost\n1,2\n")`);
  const dropped = { ...MEASURED.opened, report: { ...REPORT, degenerateFaces: 1 } };
  expect(commandLines({ ...measured, opened: dropped })).toContain('# Triangles of the file were left out');
  const halfway = { ...MEASURED, field: { ...field(0.5), refineMs: 1 } };
  expect(commandLines(halfway)).toMatch(/^# The page has refined distances below 0.5 to exact ones/);
});

test('paths are written in the unit of the file', () => {
  const points: Vector[] = [
    [10, 20, 30],
    [10.5, 18.5, 31],
  ];
  expect(pathFile('obj', points, MODEL)).toContain('v 10.5 18.5 31\nl 1 2\n');
  expect(
    pathFile(
      'csv',
      [
        [0, 0, 0],
        [0, 3, 4],
      ],
      MODEL,
    ),
  ).toBe('length,x,y,z\n0,0,0,0\n5,0,3,4\n');
});

test('a path as glTF is valid, and holds its points', async () => {
  const points: [number, number, number][] = [
    [0, 0.1, 0],
    [1e-3, 3, 4],
    [-2, 7, 0.3],
  ];
  const glb = pathFile('glb', points, MODEL) as Uint8Array<ArrayBuffer>;
  expect(await complaints(glb)).toEqual([]);
  const [first, second, third] = points;
  const ends = [first, second, second, third];
  expect(new Float32Array(glb.slice(-48).buffer)).toEqual(Float32Array.from(ends.flat()));
  // What the validator finds is told.
  expect(await complaints(glb.with(glb.length - 25, 0x7f).with(glb.length - 26, 0xc0))).not.toEqual([]);
});

test('tracks are numbered in tables, and lines of their own in files of lines', async () => {
  const tracks = trackPoints({ points: Float64Array.of(0, 0, 0, 0, 3, 4, 1, 1, 1), counts: Uint32Array.of(2, 1) });
  expect(tracksFile('csv', tracks, MODEL)).toBe('walker,length,x,y,z\n0,0,0,0,0\n0,5,0,3,4\n1,0,1,1,1\n');
  expect(
    String(tracksFile('obj', tracks, MODEL))
      .split('\n')
      .slice(4),
  ).toEqual(['l 1 2', 'l 3', '']);
  const glb = tracksFile('glb', tracks, MODEL) as Uint8Array<ArrayBuffer>;
  expect(await complaints(glb)).toEqual([]);
  // Who stands where it is has a segment without length.
  expect(new Float32Array(glb.slice(-48).buffer)).toEqual(Float32Array.of(0, 0, 0, 0, 3, 4, 1, 1, 1, 1, 1, 1));
});

test('sets of sources are sources of the command line, with their initial distances', () => {
  const set = {
    shape: { kind: 'list', name: 'a.csv' } as const,
    points: [{ vertex: 3 }, { vertex: 5, offset: 1 }],
    offset: 2,
  };
  const state = { ...STATE, sets: [set] };
  expect(commandLines({ ...MEASURED, state })).toContain('--source 7 --source 3@2 --source 5@3 --method');
  const many = { ...set, points: Array.from({ length: 3000 }, (_, vertex) => ({ vertex })) };
  expect(() => commandLines({ ...MEASURED, state: { ...STATE, sets: [many] } })).toThrow('room for 2,000 sources');
});

test('the eye is where yaw and pitch say', () => {
  expect(towardEye([0, 0])).toEqual([0, 0, 1]);
  expect(towardEye([0, Math.PI / 2])[1]).toBe(1);
});

/** The examples are compiled with the crate's tests. */
const example = (name: string) => readFile(new URL(`../../crate/solver/examples/${name}.rs`, import.meta.url), 'utf8');

test('the lines of Rust are examples of the crate', async () => {
  const parameters = {
    ...STATE.parameters,
    operator: 'plain' as const,
    timeStep: 10,
    exactRadius: Infinity,
    boundary: 'average' as const,
    sources: 'summed' as const,
  };
  const byHeat = { ...STATE, parameters, method: 'heat' as const, bridge: 'off' as const };
  expect(rustLines({ ...MEASURED, state: byHeat, field: field(0) })).toBe(await example('distances_of_shape'));

  const sources = [
    { vertex: 7 },
    { face: 3, weights: [0.25, 0.25, 0.5] as [number, number, number], offset: 2 },
    { vertex: 8, offset: 0.125 },
  ];
  const animation = { ...STATE.animation, clip: 1, seconds: 0.5, live: true };
  const state = { ...STATE, sources, animation, bridge: 0.01, links: 2 };
  const opened = { ...MEASURED.opened, active: [1], parts: [...MEASURED.opened.parts, ...MEASURED.opened.parts] };
  const asked = { ...MEASURED, state, opened, mesh: 'a "cow".glb', field: field(1, 4) };
  expect(rustLines(asked)).toBe(await example('distances_of_file'));
});
