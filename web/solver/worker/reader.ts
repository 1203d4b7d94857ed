/** Files of surfaces, read by a module that is loaded with the first of them. */
import readerAddress from '../../wasm/reader/heatwalk_reader_bg.wasm?url';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { fileName } from '../../files/paths';
import { onDemand } from './demand';
import { type Files, withFiles } from './files';

const reader = onDemand(async () => {
  const module = await import('../../wasm/reader/heatwalk_reader.js');
  await module.default({ module_or_path: readerAddress });
  return module;
});

/** Reads the mesh with these bytes at `mesh`, and what it refers to. */
export async function readMesh(mesh: string, bytes: Uint8Array, files: Files): Promise<wasm.MeshFile> {
  const { ReadMesh, __wbg_reset_state: renew } = await reader();
  try {
    const read = withFiles(mesh, files, (resource) => ReadMesh.read(fileName(mesh), bytes, resource));
    return wasm.MeshFile.unpacked(read.take(), read.up);
  } finally {
    // Each file has an instance of its own: memory of the last one goes back, and a trap ends nothing else.
    renew();
  }
}
