/** Meshes of tetrahedra, by a module that is loaded with the first of them. */
import type { DrawTransform, InnerReport, Interior } from '../../protocol';
import type * as interior from '../../wasm/interior/heatwalk_interior';
import interiorAddress from '../../wasm/interior/heatwalk_interior_bg.wasm?url';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import type { Up } from '../../wasm/contract';
import { fileName } from '../../files/paths';
import { onDemand } from './demand';
import { type Files, withFiles } from './files';

/** Of the module, where it is loaded. */
let memory: WebAssembly.Memory | undefined;

/** Bytes of wasm memory that tetrahedra use. */
export function interiorBytes(): number {
  return memory?.buffer.byteLength ?? 0;
}

const loaded = onDemand(async () => {
  const module = await import('../../wasm/interior/heatwalk_interior.js');
  ({ memory } = await module.default({ module_or_path: interiorAddress }));
  return module;
});

/** Tetrahedra that are open, and how long it took to make them. */
export interface Tetrahedra {
  tetrahedra: interior.Tetrahedra;
  madeMs: number;
  /** Whether they are those of a file, and not made. */
  isFile: boolean;
}

/** Those of a file. */
export async function readTetrahedra(mesh: string, bytes: Uint8Array, files: Files): Promise<Tetrahedra> {
  const module = await loaded();
  const read = (resource: interior.Resource) => module.Tetrahedra.read(fileName(mesh), bytes, resource);
  return { ...timed(() => withFiles(mesh, files, read)), isFile: true };
}

/** The surface of a file that may have held some. */
export async function readFaces(mesh: string, bytes: Uint8Array, files: Files): Promise<wasm.MeshFile> {
  const module = await loaded();
  const read = (resource: interior.Resource) => module.Tetrahedra.surface(fileName(mesh), bytes, resource);
  return wasm.MeshFile.unpacked(withFiles(mesh, files, read), undefined);
}

/** Those of a shape that is made in code. */
export async function shapeOfTetrahedra(name: string): Promise<Tetrahedra> {
  const module = await loaded();
  return timed(() => module.Tetrahedra.shape(name));
}

/** About `count` that fill what the chosen parts of a file enclose. */
export async function filled(
  file: wasm.MeshFile,
  parts: Uint32Array,
  count: number,
  progress: (fraction: number) => void,
): Promise<Tetrahedra> {
  const module = await loaded();
  const triangles = file.triangles_of(parts);
  return timed(() => module.Tetrahedra.fill(file.positions(), triangles, count, progress));
}

/** Those that are made. */
function timed(make: () => interior.Tetrahedra): Tetrahedra {
  const began = performance.now();
  const tetrahedra = make();
  return { tetrahedra, madeMs: performance.now() - began, isFile: false };
}

/** The boundary as a mesh that can be drawn, and the vertices of the input that its vertices are. `up`: what points up, if that is known. */
export function boundaryOf(
  { tetrahedra }: Tetrahedra,
  name: string,
  up: Up | undefined,
): { file: wasm.MeshFile; vertices: Uint32Array } {
  const boundary = tetrahedra.boundary();
  const file = wasm.MeshFile.surface_of(name, boundary.positions(), boundary.triangles(), up);
  const vertices = boundary.vertices();
  boundary.free();
  return { file, vertices };
}

/** What the page gets of them. */
export function interiorOf({ tetrahedra, madeMs }: Tetrahedra, drawn: DrawTransform): Interior {
  return {
    positions: tetrahedra.places(drawn),
    tetrahedra: tetrahedra.corners(),
    report: tetrahedra.report() as InnerReport,
    madeMs,
  };
}

/** A solver on them; `vertices`: those of the input that drawn ones are (#D), `triangles`: those that are drawn. */
export function innerSolver(
  { tetrahedra }: Tetrahedra,
  vertices: Uint32Array,
  triangles: Uint32Array,
  drawn: DrawTransform,
): interior.InnerSolver {
  return tetrahedra.solver(vertices, triangles, drawn);
}
