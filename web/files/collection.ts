/** The meshes of one input: files, or an archive of them. */
import { Failure } from '../error';
import type { InputFile, MeshInput } from '../protocol';
import { fileName, isArchive, isPacked, isText, meshesAmong } from './paths';

export interface Collection {
  /** Paths of the meshes, at least one; the one to be opened unless another is wanted comes first. */
  meshes: readonly [string, ...string[]];
  input: (mesh: string) => MeshInput;
}

/** The meshes among files. An archive is looked into where there is no mesh beside it. */
export async function collect(given: readonly InputFile[]): Promise<Collection> {
  const files = await Promise.all(given.map(unpacked));
  const paths = files.map(({ path }) => path);
  const [first, ...others] = meshesAmong(paths);
  if (first !== undefined) return { meshes: [first, ...others], input: (mesh) => ({ kind: 'files', mesh, files }) };
  const archive = files.find(({ path }) => isArchive(path));
  if (!archive) throw await noMesh(paths);
  return collectArchive(archive.content, fileName(archive.path));
}

async function unpacked(file: InputFile): Promise<InputFile> {
  return isPacked(file.path) ? (await import('./gzip')).unpacked(file) : file;
}

/** The meshes of an archive. `name`: what a message calls it. */
export async function collectArchive(archive: Blob, name?: string): Promise<Collection> {
  const { Archive } = await import('./zip');
  const { paths } = await Archive.of(archive);
  const [first, ...others] = meshesAmong(paths.filter((path) => !isText(path)));
  if (first === undefined) throw await noMesh(paths, name);
  return { meshes: [first, ...others], input: (mesh) => ({ kind: 'archive', mesh, archive }) };
}

/** An input without a mesh. */
export class NoMesh extends Failure {}

async function noMesh(paths: readonly string[], archive?: string): Promise<NoMesh> {
  return new NoMesh((await import('./nomesh')).reasonOf(paths, archive));
}
