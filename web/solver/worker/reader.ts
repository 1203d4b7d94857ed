/** Files of surfaces, read by a module that is loaded with the first of them. */
import readerAddress from '../../wasm/reader/heatwalk_reader_bg.wasm?url';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { fileName } from '../../files/paths';
import { inFreshInstance, moduleOnDemand } from './demand';
import { type Files, filesOf, withFiles } from './files';

const reader = moduleOnDemand(() => import('../../wasm/reader/heatwalk_reader.js'), readerAddress);

/** Reads the mesh with these bytes at `mesh`, and what it refers to. */
export function readMesh(mesh: string, bytes: Uint8Array, files: Files): Promise<wasm.MeshFile> {
  return inFreshInstance(reader, ({ ReadMesh }) => {
    const read = withFiles(mesh, files, (resource) => ReadMesh.read(fileName(mesh), bytes, resource));
    return wasm.MeshFile.unpacked(read.take(), read.up);
  });
}

const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';

/** Reads a triangle and forgets it, so that the module is there, and the browser has compiled its code, before a file comes. */
export async function readTriangle(): Promise<void> {
  const file = await readMesh('triangle.obj', new TextEncoder().encode(TRIANGLE), filesOf([]));
  file.free();
}
