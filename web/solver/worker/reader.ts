/** Files of surfaces, read by a module that is loaded with the first of them. */
import readerAddress from '../../wasm/reader/heatwalk_reader_bg.wasm?url';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { fileName } from '../../files/paths';
import { inFreshInstance, moduleOnDemand } from './demand';
import { type Files, withFiles } from './files';

const reader = moduleOnDemand(() => import('../../wasm/reader/heatwalk_reader.js'), readerAddress);

/** Reads the mesh with these bytes at `mesh`, and what it refers to. */
export function readMesh(mesh: string, bytes: Uint8Array, files: Files): Promise<wasm.MeshFile> {
  return inFreshInstance(reader, ({ ReadMesh }) => {
    const read = withFiles(mesh, files, (resource) => ReadMesh.read(fileName(mesh), bytes, resource));
    return wasm.MeshFile.unpacked(read.take(), read.up);
  });
}
