/** Files of surfaces, read by a module that is loaded with the first of them. */
import readerAddress from '../../wasm/reader/heatwalk_reader_bg.wasm?url';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { fileName } from '../../files/paths';
import { inFreshInstance, moduleOnDemand } from './demand';
import { type Files, filesOf, withFiles } from './files';

const reader = moduleOnDemand(() => import('../../wasm/reader/heatwalk_reader.js'), readerAddress);

/** A surface of a file or a shape. */
export interface Faces {
  file: wasm.MeshFile;
  /** Whether its vertices are points that came without faces. */
  isCloud: boolean;
}

/** Reads the mesh with these bytes at `mesh`, and what it refers to; of points without faces, the surface that joins them. */
export function readMesh(mesh: string, bytes: Uint8Array, files: Files): Promise<Faces> {
  return inFreshInstance(reader, ({ ReadMesh }) => {
    const read = withFiles(mesh, files, (resource) => ReadMesh.read(fileName(mesh), bytes, resource));
    return { file: wasm.MeshFile.unpacked(read.take(), read.up), isCloud: read.is_cloud };
  });
}

const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';

/** Reads a triangle and forgets it, so that the module is there, and the browser has compiled its code, before a file comes. */
export async function readTriangle(): Promise<void> {
  const { file } = await readMesh('triangle.obj', new TextEncoder().encode(TRIANGLE), filesOf([]));
  file.free();
}
