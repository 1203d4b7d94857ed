/** Solves small shapes and forgets them, so that the browser has optimised the solver's code before a mesh comes. */
import { DEFAULT_WINDOWS } from '../../wasm/contract';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { FIRST_WORK } from './mesh';

/** How far the second of two meshes to warm up on is from the first; their longest sides are 1 to 2. */
const BESIDE = 0.3;

export function solveSmallShapes(): void {
  const file = wasm.MeshFile.sphere();
  const surface = file.surface(Uint32Array.of(0), 'y');
  const drawing = surface.draw();
  drawing.shade();
  const solver = drawing.factor({}, () => undefined);
  const sources = [{ vertex: 0 }];
  for (const quick of [false, true]) solver.solve(sources, quick);
  for (const windows of [1, DEFAULT_WINDOWS]) solver.propagate(sources, windows, windows === 1);
  solver.refine(FIRST_WORK);
  lookForContacts(drawing.take_mesh());
  for (const used of [solver, drawing, surface, file]) used.free();
}

/** Between a mesh and the same one beside it, which it pierces. */
function lookForContacts({ positions, triangles }: wasm.DrawMesh): void {
  const both = new Float32Array(2 * positions.length);
  both.set(positions);
  both.set(
    positions.map((coordinate, index) => coordinate + (index % 3 === 0 ? BESIDE : 0)),
    positions.length,
  );
  const faces = new Uint32Array(2 * triangles.length);
  faces.set(triangles);
  faces.set(
    triangles.map((vertex) => vertex + positions.length / 3),
    triangles.length,
  );
  const file = wasm.MeshFile.arrays('', both, faces);
  const surface = file.surface(Uint32Array.of(0), 'y');
  const drawing = surface.draw();
  const solver = drawing.solver();
  solver.bridge('auto', 0, false);
  for (const used of [solver, drawing, surface, file]) used.free();
}
