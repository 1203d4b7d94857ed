/** The solver's module takes what the page may say, name by name, and nothing else. */
import fs from 'node:fs';
import path from 'node:path';
import { expect, test } from '@playwright/test';
import {
  AUTOMATIC,
  BOUNDARY,
  DEFAULT_PARAMETERS,
  EDGE_KIND,
  EXACT_RADIUS_EDGES,
  FACE_FIELD,
  LINEAR_SOLVER,
  MEMORY_LIMIT_MEBIBYTES,
  MULTI_SOURCE,
  OPERATOR,
  type Parameters,
  PATH_KIND,
  TIME_STEP_FACTORS,
  TOO_LARGE,
  WINDOWS,
} from '../../web/wasm/contract';
import { type Drawing, initSync, MeshFile, type Solver } from '../../web/wasm/solver/heatwalk_worker.js';

const MODULE = path.join(import.meta.dirname, '../../web/wasm/solver/heatwalk_worker_bg.wasm');
/** Of 32-bit floats. */
const ROUNDING = 1e-6;
const SOURCES = [{ vertex: 0 }, { face: 3, weights: [0.2, 0.3, 0.5] as [number, number, number], offset: 0.1 }];

/** All that an option may be, from the least to the greatest. */
const VALUES: { [Option in keyof Parameters]: readonly Parameters[Option][] } = {
  operator: OPERATOR.names,
  solver: LINEAR_SOLVER.names,
  timeStep: [...TIME_STEP_FACTORS, AUTOMATIC],
  boundary: BOUNDARY.names,
  sources: MULTI_SOURCE.names,
  exactRadius: [...EXACT_RADIUS_EDGES, AUTOMATIC],
  memory: [MEMORY_LIMIT_MEBIBYTES[1], AUTOMATIC],
};

let drawing: Drawing;
let solver: Solver;
test.beforeAll(() => {
  initSync({ module: fs.readFileSync(MODULE) });
  // A surface with a boundary and uneven triangles, where every option makes a difference.
  const [positions, triangles] = [new Float32Array(3 * 81), [] as number[]];
  for (let i = 0; i < 81; i++) positions.set([(i % 9) ** 1.5, Math.floor(i / 9) + 3 * (i % 9), 0], 3 * i);
  for (let i = 0; i < 72; i++) if (i % 9 < 8) triangles.push(i, i + 1, i + 10, i, i + 10, i + 9);
  const file = MeshFile.arrays('grid', positions, Uint32Array.from(triangles));
  drawing = file.surface(Uint32Array.of(0), 'y').draw();
  solver = drawing.factor(DEFAULT_PARAMETERS, () => undefined);
});

function configure(options: object): void {
  solver.configure(options, () => undefined);
}

function farthest(options: Partial<Parameters>): number {
  configure({ exactRadius: 0, ...options });
  return solver.solve(SOURCES, false).maxDistance;
}

for (const [option, values] of Object.entries(VALUES)) {
  test(`${option} takes each of its values, and each makes a difference`, () => {
    const answers = values.map((value) => farthest({ [option]: value }));
    for (const answer of answers) expect(answer).toBeGreaterThan(1);
    // Where there is enough memory, more of it changes nothing.
    if (option === 'memory') return;
    // What is chosen automatically may be an end of the range.
    const named = values.filter((value) => value !== AUTOMATIC);
    expect(new Set(answers.slice(0, named.length)).size).toBe(named.length);
  });
}

test('former names are taken', () => {
  for (const [former, name] of Object.entries(MULTI_SOURCE.former)) {
    expect(farthest({ sources: former as typeof name })).toBe(farthest({ sources: name }));
  }
});

test('every kind of path, gradient and edges is answered', () => {
  farthest({});
  for (const kind of PATH_KIND.names) expect(solver.path({ vertex: 80 }, kind).length, kind).toBeGreaterThan(1);
  for (const kind of FACE_FIELD.names) expect(solver.gradients(kind), kind).toHaveLength(3 * 128);
  for (const kind of EDGE_KIND.names) {
    // One component meets no other.
    if (kind === 'contact') expect(solver.edges(kind), kind).toHaveLength(0);
    else expect(solver.edges(kind).length, kind).toBeGreaterThan(0);
  }
});

test('windows are answered with and without factors, by the same distances, and become exact', () => {
  const unfactored = drawing.solver();
  expect(unfactored.factor_nonzeros()).toBe(0);
  expect(solver.factor_nonzeros()).toBeGreaterThan(0);
  for (const windows of WINDOWS) {
    const field = unfactored.propagate(SOURCES, windows, false);
    expect([field.windows, field.timeFactor]).toEqual([windows, undefined]);
    expect(solver.propagate(SOURCES, windows, false).distance).toEqual(field.distance);
    const refined = unfactored.refine(1_000_000);
    expect(refined.exactBelow).toBe(Infinity);
    const { distance } = refined;
    // No path is shorter than the shortest.
    field.distance.forEach((value, i) => expect(value).toBeGreaterThanOrEqual(distance[i] * (1 - ROUNDING)));
  }
  expect(() => unfactored.solve(SOURCES, false)).toThrow('nothing is factored');
  expect(() => unfactored.heat()).toThrow('ask for the heat method');
  expect(() => unfactored.propagate(SOURCES, 0, false)).toThrow('one window at least');
});

test('the exact path is found step by step, and is as long as that of one go', () => {
  solver.propagate(SOURCES, 1, false);
  const length = solver.path({ vertex: 80 }, 'exact').length;
  let steps = 0;
  let found;
  for (; !found; steps++) found = solver.search_path({ vertex: 80 }, 1);
  expect(steps).toBeGreaterThan(1);
  expect(found.length).toBeCloseTo(length, 12);
});

test('what is no option, no value or no name is refused in a sentence', () => {
  expect(() => configure({ heat: 1 })).toThrow("there is no option 'heat'");
  expect(() => configure({ timeStep: 'fast' })).toThrow('timeStep');
  expect(() => configure({ boundary: 'warm' })).toThrow('neumann, dirichlet, average');
  expect(() => solver.path({ vertex: 80 }, 'home' as 'exact')).toThrow('descent, straight, exact');
});

test('failures have the codes of the solver as names', () => {
  expect(() => configure({ timeStep: -1 })).toThrow(expect.objectContaining({ name: 'bad-parameter' }));
  expect(() => configure({ memory: 0, timeStep: 7 })).toThrow(expect.objectContaining({ name: TOO_LARGE }));
});

test('what the module gives is a plain object with all that the page reads', () => {
  farthest({});
  const field = solver.solve(SOURCES, true);
  expect(Object.getPrototypeOf(field)).toBe(Object.prototype);
  expect(field.distance).toBeInstanceOf(Float32Array);
  expect(field).toMatchObject({
    unreachableVertices: 0,
    exactShare: expect.any(Number),
    timeFactor: expect.any(Number),
  });
  expect(structuredClone(field)).toEqual(field);
});
