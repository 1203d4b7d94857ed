/** A scene in a file: an archive of its link, its mesh, and the files that the mesh refers to. */
import { Failure } from '../error';
import { strToU8, Zip, ZipDeflate } from 'fflate';
import type { InputFile, MeshInput } from '../protocol';
import { percentDecoded } from './address';
import { resolve } from './paths';
import { gltfReferences, librariesOf, mapsOf } from './references';
import { Archive } from './zip';
import { t } from '../texts';

/** What tells a scene from any other archive. */
const SCENE = 'heatwalk.json';
/** Where the images that lie on the surface are. */
const IMAGES = 'heatwalk-images/';
const VERSION = 1;

export interface SceneFile {
  /** The fragment of its link. */
  link: string;
  /** Path of the mesh in the archive; null for one that every page has. */
  mesh: string | null;
  /** Those that lie on the surface, of files. */
  images: readonly InputFile[];
}

/** `input`: that of the mesh; null for one that every page has. `images`: of files, that lie on the surface. */
export async function packScene(
  link: string,
  input: MeshInput | null,
  images: readonly InputFile[] = [],
): Promise<Blob> {
  const mesh = input && 'mesh' in input ? input.mesh : null;
  const manifest = strToU8(JSON.stringify({ heatwalk: VERSION, mesh, link }, null, 2));
  const files = input ? await filesOf(input) : new Map<string, Uint8Array>();
  return zipped(new Map([[SCENE, manifest], ...files, ...(await Promise.all(images.map(packedImage)))]));
}

async function packedImage({ path, content }: InputFile): Promise<[string, Uint8Array]> {
  return [IMAGES + path, new Uint8Array(await content.arrayBuffer())];
}

/** Names are no keys of an object: `constructor` and `__proto__` are names like others. */
function zipped(files: Contents): Blob {
  const chunks: Uint8Array<ArrayBuffer>[] = [];
  const zip = new Zip((error, chunk) => {
    if (error) throw error;
    chunks.push(chunk);
  });
  for (const [path, content] of files) {
    // Most of it is compressed already, or soon.
    const file = new ZipDeflate(path, { level: 1 });
    zip.add(file);
    file.push(content, true);
  }
  zip.end();
  return new Blob(chunks, { type: 'application/zip' });
}

/**
 * The scene in an archive; null for an archive that holds none.
 *
 * @throws where there is one that cannot be read.
 */
export async function sceneIn(content: Blob): Promise<SceneFile | null> {
  const archive = await Archive.of(content);
  if (!archive.paths.includes(SCENE)) return null;
  const manifest = parsed(new TextDecoder().decode(archive.read(SCENE)));
  if (!manifest || typeof manifest.link !== 'string' || !(manifest.mesh === null || typeof manifest.mesh === 'string'))
    throw new Failure(t`its ${SCENE} is damaged; save the scene again`);
  if (manifest.heatwalk !== VERSION)
    throw new Failure(t`its ${SCENE} was written by another version of the page; reload the page, and open it again`);
  if (manifest.mesh !== null && !archive.paths.includes(manifest.mesh))
    throw new Failure(t`its mesh ${manifest.mesh} is not in the archive; save the scene again`);
  const images = archive.paths.filter((path) => path.startsWith(IMAGES));
  const image = (path: string) => ({ path: path.slice(IMAGES.length), content: new Blob([archive.read(path)]) });
  return { link: manifest.link, mesh: manifest.mesh, images: images.map(image) };
}

function parsed(text: string): { heatwalk?: unknown; link?: unknown; mesh?: unknown } | null {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' ? value : null;
  } catch {
    return null;
  }
}

type Contents = ReadonlyMap<string, Uint8Array>;

async function filesOf(input: MeshInput): Promise<Contents> {
  switch (input.kind) {
    case 'files': {
      const contents = new Map(input.files.map(({ path, content }: InputFile) => [path, content]));
      const read = async (path: string) => new Uint8Array(await (contents.get(path) ?? new Blob()).arrayBuffer());
      return belonging(input.mesh, [...contents.keys()], read);
    }
    case 'archive': {
      const archive = await Archive.of(input.archive);
      return belonging(input.mesh, archive.paths, (path) => Promise.resolve(archive.read(path)));
    }
    case 'shape':
    case 'tetrahedra':
    case 'arrays':
      return new Map();
  }
}

/** A mesh and what it refers to, of files that were opened together. */
async function belonging(
  mesh: string,
  paths: readonly string[],
  read: (path: string) => Promise<Uint8Array>,
): Promise<Contents> {
  const found = new Map([[mesh, await read(mesh)]]);
  const textOf = (path: string) => new TextDecoder().decode(found.get(path));
  const take = async (uri: string): Promise<string | null> => {
    const path = resolve(mesh, uri, paths);
    if (path === undefined) return null;
    if (!found.has(path)) found.set(path, await read(path));
    return path;
  };
  if (/\.gltf$/i.test(mesh)) {
    for (const { uri } of gltfReferences(mesh, textOf(mesh))) await take(percentDecoded(uri));
  } else if (/\.obj$/i.test(mesh)) {
    for (const { uri } of librariesOf(mesh, textOf(mesh))) {
      const library = await take(percentDecoded(uri));
      const maps = library === null ? [] : mapsOf(mesh, library, textOf(library));
      for (const map of maps) await take(percentDecoded(map.uri));
    }
  } else if (/\.(node|ele)$/i.test(mesh)) {
    const name = mesh.slice(mesh.lastIndexOf('/') + 1).replace(/\.(node|ele)$/i, '');
    await take(`${name}.node`);
    await take(`${name}.ele`);
  }
  return found;
}
