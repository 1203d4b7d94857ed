/** The files of a mesh, each read when it is asked for. */
import { resolve } from '../../files/paths';
import type { InputFile } from '../../protocol';
import type { Resource } from '../../wasm/reader/heatwalk_reader';

/** What only workers have; the page takes the types of its calls from here, too. */
declare class FileReaderSync {
  readAsArrayBuffer(content: Blob): ArrayBuffer;
}

/** Bytes that can be handed over. */
export type Bytes = Uint8Array<ArrayBuffer>;

export interface Files {
  paths: readonly string[];
  read: (path: string) => Bytes;
}

export function filesOf(files: readonly InputFile[]): Files {
  const contents = new Map(files.map(({ path, content }) => [path, content]));
  const reader = new FileReaderSync();
  return {
    paths: [...contents.keys()],
    read: (path) => new Uint8Array(reader.readAsArrayBuffer(contents.get(path) ?? new Blob())),
  };
}

export async function unpackedOf(content: Blob): Promise<Files> {
  const { Archive } = await import('../../files/zip');
  const archive = await Archive.of(content);
  return { paths: archive.paths, read: (path) => archive.read(path) };
}

/** Reads the mesh at `mesh` by a reader that asks for the files that it refers to. */
export function withFiles<T>(mesh: string, { paths, read }: Files, reader: (resource: Resource) => T): T {
  let failure: unknown;
  try {
    return reader((uri) => {
      const path = resolve(mesh, uri, paths);
      if (path === undefined) return undefined;
      try {
        return read(path);
      } catch (error) {
        failure ??= error;
        return undefined;
      }
    });
  } catch (error) {
    // Why a file could not be read says more than that the mesh misses it.
    throw failure ?? error;
  }
}
