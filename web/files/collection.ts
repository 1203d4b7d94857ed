/** The meshes of one input: files, or an archive of them. */
import { Failure } from '../error';
import type { InputFile, MeshInput } from '../protocol';
import { formats, fileName, isArchive, isPacked, meshesAmong } from './paths';
import { counted, enumerated, t, type Words } from '../texts';

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
  if (!archive) throw new NoMesh(paths);
  return collectArchive(archive.content);
}

async function unpacked(file: InputFile): Promise<InputFile> {
  return isPacked(file.path) ? (await import('./gzip')).unpacked(file) : file;
}

/** The meshes of an archive. */
export async function collectArchive(archive: Blob): Promise<Collection> {
  const { Archive } = await import('./zip');
  const { paths } = await Archive.of(archive);
  const [first, ...others] = meshesAmong(paths);
  if (first === undefined) throw new NoMesh(paths);
  return { meshes: [first, ...others], input: (mesh) => ({ kind: 'archive', mesh, archive }) };
}

const NAMED = 5;

/** Formats that no reader for a page reads well: converters do. */
const CONVERTED = /\.(fbx|dae)$/i;
const CONVERT = t(
  'FBX and COLLADA (.dae) files are not read: convert them to GLB, in Blender (COLLADA up to version 4.5) or by “assimp export model.fbx model.glb”.',
);

/** An input without a mesh. */
export class NoMesh extends Failure {
  constructor(paths: readonly string[]) {
    const names: Words[] = paths.slice(0, NAMED).map(fileName);
    if (paths.length > NAMED) names.push(counted(paths.length - NAMED, '{0} more file', '{0} more files'));
    const all = enumerated(names.length > 0 ? names : [t('the input')]);
    super(
      paths.some((path) => CONVERTED.test(path))
        ? CONVERT
        : t`No mesh found in ${all}. Supported formats: ${formats()}.`,
    );
  }
}
