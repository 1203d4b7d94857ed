/** Why an input has no mesh: read by few, and fetched when it is. */
import { formats, fileName } from './paths';
import { counted, enumerated, t, type Words } from '../texts';

const NAMED = 5;

/** Formats that no reader for a page reads well: converters do. */
const CONVERTED = /\.(fbx|dae)$/i;
const CONVERT = t(
  'FBX and COLLADA (.dae) files are not read: convert them to GLB, in Blender (COLLADA up to version 4.5) or by “assimp export model.fbx model.glb”.',
);

/** `paths`: of all files; `archive`: the name of the one that they are in. */
export function reasonOf(paths: readonly string[], archive: string | undefined): Words {
  if (paths.some((path) => CONVERTED.test(path))) return CONVERT;
  const names: Words[] = paths.slice(0, NAMED).map(fileName);
  if (paths.length > NAMED) names.push(counted(paths.length - NAMED, '{0} more file', '{0} more files'));
  if (archive !== undefined && names.length > 0)
    return t`The archive ${archive} contains no mesh, only ${enumerated(names)}. Supported formats: ${formats()}.`;
  return t`No mesh found in ${enumerated(names.length > 0 ? names : [archive ?? t('the input')])}. Supported formats: ${formats()}.`;
}
