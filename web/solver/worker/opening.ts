/** What is opened: a surface of a file or made in code, simplified or not, or tetrahedra. */
import type { Appearance, MeshInput, OpenedMesh, ProgressListener, Simplified } from '../../protocol';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import type { Up } from '../../wasm/contract';
import { fileName, holdsTetrahedra } from '../../files/paths';
import { type Files, filesOf, unpackedOf } from './files';
import { decodeImages } from './images';
import { boundaryOf, filled, readFaces, readTetrahedra, shapeOfTetrahedra, type Tetrahedra } from './interior';
import { makeShape } from './maker';
import { type Faces, readMesh } from './reader';
import { simplify } from './simplify';

/** Where simplifying and filling begin in the time that opening takes, and where filling ends. */
const SIMPLIFY_FROM = 0.05;
const FILL_FROM = 0.1;
export const FILLED_FROM = 0.28;

interface MeshSource {
  name: string;
  /** SHA-256 of the file, hex; empty for what is in none. */
  hash: string;
  read: () => Promise<Faces | Tetrahedra>;
}

/** What is wanted of a mesh: the indices of its parts, or all; at most `most` triangles; filled with about `fill` tetrahedra. */
interface Wish {
  parts: readonly number[];
  most: number | null;
  fill: number | null;
}

/** Reads a mesh, or makes it, as it is wanted. */
export async function openingOf(
  { name, read }: MeshSource,
  { parts, most, fill }: Wish,
  progress: ProgressListener,
): Promise<Opening> {
  const given = await read();
  if ('tetrahedra' in given) {
    const opening = tetrahedraIn(given, name, null);
    return given.isFile ? opening : { ...opening, unit: NO_UNIT };
  }
  const opening = await fewer(given, name, parts, most, progress);
  return fill === null ? opening : stuffed(opening, name, fill, progress);
}

export async function sourceOf(input: MeshInput): Promise<MeshSource> {
  switch (input.kind) {
    case 'files':
      return sourceIn(filesOf(input.files), input.mesh);
    case 'archive':
      return sourceIn(await unpackedOf(input.archive), input.mesh);
    case 'shape':
      return madeSource(input.shape, async () => withFaces(await makeShape(input.shape)));
    case 'tetrahedra':
      return madeSource(input.shape, () => shapeOfTetrahedra(input.shape));
    case 'arrays': {
      const { name, positions, triangles } = input;
      return madeSource(name, async () => withFaces(wasm.MeshFile.arrays(name, positions, triangles)));
    }
  }
}

function madeSource(name: string, read: MeshSource['read']): MeshSource {
  return { name, hash: '', read };
}

function withFaces(file: wasm.MeshFile): Faces {
  return { file, isCloud: false };
}

async function sourceIn(files: Files, mesh: string): Promise<MeshSource> {
  const bytes = files.read(mesh);
  const read = async () => {
    const tetrahedra = holdsTetrahedra(mesh);
    if (tetrahedra === false) return readMesh(mesh, bytes, files);
    try {
      return await readTetrahedra(mesh, bytes, files);
    } catch (error) {
      if (!(error instanceof Error && error.name === 'no-tetrahedra')) throw error;
      return tetrahedra === true ? withFaces(await readFaces(mesh, bytes, files)) : readMesh(mesh, bytes, files);
    }
  };
  return { name: fileName(mesh), hash: await hashOf(bytes), read };
}

/** What is to be opened. */
export interface Opening extends Faces {
  chosen: Uint32Array;
  simplified: Simplified | null;
  /** The symbol of the unit of lengths, and whether it is assumed. */
  unit: Pick<OpenedMesh, 'unit' | 'unitAssumed'>;
  /** Tetrahedra whose boundary the file is, and the vertices of their input that its vertices are. */
  inner: { mesh: Tetrahedra; vertices: Uint32Array } | null;
}

function tetrahedraIn(mesh: Tetrahedra, name: string, simplified: Simplified | null, up?: Up): Opening {
  const { file, vertices } = boundaryOf(mesh, name, up);
  return {
    ...withFaces(file),
    chosen: Uint32Array.of(0),
    simplified,
    unit: unitOf(file),
    inner: { mesh, vertices },
  };
}

/** About `count` tetrahedra in what the chosen parts of a file enclose. */
async function stuffed(
  { file, chosen, simplified, unit }: Opening,
  name: string,
  count: number,
  progress: ProgressListener,
): Promise<Opening> {
  const report = (fraction: number) =>
    progress({ stage: 'Filling', fraction: FILL_FROM + fraction * (FILLED_FROM - FILL_FROM), vertices: 0 });
  report(0);
  const tetrahedra = await filled(file, chosen, count, report);
  const { upright } = file.contents();
  file.free();
  return { ...tetrahedraIn(tetrahedra, name, simplified, upright), unit };
}

/** The chosen parts of a file; a simplified model of these as the only part where they have more triangles than are wanted. */
async function fewer(
  faces: Faces,
  name: string,
  parts: readonly number[],
  most: number | null,
  progress: ProgressListener,
): Promise<Opening> {
  const { file } = faces;
  const all = file.contents().parts;
  // A link may name parts of another file.
  const there = parts.filter((part) => part < all.length);
  const chosen = Uint32Array.from(there.length > 0 ? there : all.keys());
  if (most === null || chosen.reduce((sum, part) => sum + (all[part]?.triangles ?? 0), 0) <= most) {
    return { ...faces, chosen, simplified: null, unit: unitOf(file), inner: null };
  }
  progress({ stage: 'Simplifying', fraction: SIMPLIFY_FROM, vertices: 0 });
  const less = await simplify(file, chosen, name, most);
  file.free();
  return { ...less, isCloud: false, chosen: Uint32Array.of(0), unit: unitOf(less.file), inner: null };
}

/** Of shapes that are made in code. */
const NO_UNIT: Opening['unit'] = { unit: '', unitAssumed: false };

function unitOf(file: wasm.MeshFile): Opening['unit'] {
  const { unit, unitAssumed } = file.contents();
  return { unit, unitAssumed };
}

/** What a file says of its looks; its images are decoded while the surface is built. */
export async function lookOf(file: wasm.MeshFile): Promise<{ appearance: Appearance | null; undecoded: string[] }> {
  if (!file.has_appearance()) return { appearance: null, undecoded: [] };
  const materials = file.materials();
  const { images, undecoded } = await decodeImages(file.images());
  return { appearance: { materials, images }, undecoded };
}

/** SHA-256 of a file; empty where the browser offers none (pages that are not served over HTTPS). */
async function hashOf(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  if (!('subtle' in crypto)) return '';
  const digest = await crypto.subtle.digest('SHA-256', bytes);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
