/** Paths of files that were given together. */

/** The mesh formats by their extensions; an archive may hold meshes. */
const MESH_FILE = /\.(3mf|glb|gltf|obj|off|ply|stl|vtk|vtp|vtu)$/i;
const ARCHIVE = /\.zip$/i;
export const FORMATS =
  'GLB, glTF with its .bin, OBJ with its .mtl, OFF, PLY, STL, 3MF, VTK (.vtk, .vtp, .vtu), alone, in a folder or in a .zip';

/** What systems put beside the files of the user. */
const HIDDEN = /(^|\/)(\.|__MACOSX\/)/;

export function isMesh(path: string): boolean {
  return MESH_FILE.test(path) && !HIDDEN.test(path);
}

export function isArchive(path: string): boolean {
  return ARCHIVE.test(path);
}

export function fileName(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1);
}

/** The meshes of a folder, the uppermost first. */
export function meshesAmong(paths: readonly string[]): string[] {
  return paths.filter(isMesh).toSorted((a, b) => depth(a) - depth(b));
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
