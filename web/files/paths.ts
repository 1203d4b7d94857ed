/** Paths of the files of one input. */
import { t } from '../texts/translate';
import { POINT_EXTENSIONS, SURFACE_EXTENSIONS, TETRAHEDRON_EXTENSIONS } from '../wasm/contract';

const SURFACES: readonly string[] = SURFACE_EXTENSIONS;
const TETRAHEDRA: readonly string[] = TETRAHEDRON_EXTENSIONS;
/** Of rows of numbers. */
const TABLE = 'csv';
/** Of lines of points; those of tables are places on the mesh on screen. */
const POINTS: readonly string[] = POINT_EXTENSIONS.filter((extension) => extension !== TABLE);
const MESHES = [...new Set([...SURFACES, ...TETRAHEDRA, ...POINTS])];
const ARCHIVE = 'zip';
const PACKED = 'gz';
/** Of what meshes refer to. */
const RESOURCES = ['bin', 'mtl', 'png', 'jpg', 'jpeg', 'webp'];
/** All that can be opened, for a dialog. */
export const ACCEPTED = [...MESHES, ...RESOURCES, TABLE, ARCHIVE, PACKED].map((extension) => `.${extension}`).join(',');

/** In words. */
export const formats = () =>
  t(
    'GLB, glTF with its .bin, OBJ with its .mtl, OFF, PLY, STL, 3MF, VTK (.vtk, .vtp, .vtu), brains of GIFTI (.surf.gii) and FreeSurfer (.pial, .white, .inflated, .sphere, .orig, .smoothwm), tetrahedra of Medit (.mesh), Gmsh (.msh), TetGen (.node with .ele), points (.xyz, .pts, .asc, .txt), alone, in a folder or in a .zip, also packed by gzip (.gz)',
  );

/** What systems put beside the files of the user. */
const HIDDEN = /(^|\/)(\.|__MACOSX\/)/;

export function isMesh(path: string): boolean {
  return MESHES.includes(extensionOf(path)) && !HIDDEN.test(path);
}

/** Whether it may be written for people; in an archive it is. */
export function isText(path: string): boolean {
  return extensionOf(path) === 'txt';
}

/** Whether gzip has packed it. */
export function isPacked(path: string): boolean {
  return extensionOf(path) === PACKED;
}

export function withoutGz(path: string): string {
  return isPacked(path) ? path.slice(0, -`.${PACKED}`.length) : path;
}

/** Whether a mesh is one of tetrahedra by its name. */
export function holdsTetrahedra(path: string): boolean | 'perhaps' {
  const extension = extensionOf(path);
  return TETRAHEDRA.includes(extension) && (!SURFACES.includes(extension) || 'perhaps');
}

export function isArchive(path: string): boolean {
  return extensionOf(path) === ARCHIVE;
}

/** Whether it holds rows of numbers. */
export function isTable(path: string): boolean {
  return extensionOf(path) === TABLE;
}

/** Whether it is an image that browsers show. */
export function isImage(path: string): boolean {
  return /\.(png|jpe?g|webp|gif|avif|svg|bmp)$/i.test(path);
}

export function fileName(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1);
}

/** Without its dot, in lower case; empty where there is none. */
function extensionOf(path: string): string {
  return /\.(\w+)$/.exec(path)?.[1]?.toLowerCase() ?? '';
}

/** The meshes of a folder, the uppermost first. */
export function meshesAmong(paths: readonly string[]): string[] {
  const all = paths.filter(isMesh);
  const others = all.filter((path) => !POINTS.includes(extensionOf(path)));
  // Text beside a mesh is about it.
  const meshes = others.length > 0 || paths.some(isArchive) ? others : all;
  // A pair of files of TetGen is one mesh.
  const named = new Set(meshes.map((path) => path.toLowerCase()));
  const isSecond = (path: string) => /\.ele$/i.test(path) && named.has(path.toLowerCase().replace(/ele$/, 'node'));
  return meshes.filter((path) => !isSecond(path)).toSorted((a, b) => depth(a) - depth(b));
}

function depth(path: string): number {
  return path.split('/').length;
}

/**
 * The path of the file that `mesh` refers to by the relative URI `uri`: as it is written, else by its file name alone, else
 * both again whatever the case. A file name counts only where one file bears it.
 */
export function resolve(mesh: string, uri: string, paths: readonly string[]): string | undefined {
  for (const form of [(path: string) => path, (path: string) => path.normalize().toLowerCase()]) {
    const wanted = form(joined(mesh, uri));
    const exact = paths.find((path) => form(path) === wanted);
    if (exact !== undefined) return exact;
    const named = paths.filter((path) => fileName(form(path)) === fileName(wanted));
    if (named.length === 1) return named[0];
  }
  return undefined;
}

/** What `uri` is relative to the folder of `mesh`; backslashes are separators, as some exporters write them. */
export function joined(mesh: string, uri: string): string {
  const steps = mesh.split('/').slice(0, -1);
  for (const step of uri.replaceAll('\\', '/').split('/')) {
    if (step === '..') steps.pop();
    else if (step !== '' && step !== '.') steps.push(step);
  }
  return steps.join('/');
}
