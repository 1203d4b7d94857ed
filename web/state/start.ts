/** What a mesh starts out with, before a link or anybody says otherwise. */
import { AUTOMATIC } from '../wasm/contract';
import { findPreset } from './presets';
import { emptyScene, type MeshReference, type SceneState } from './scene';
import { MODEL_STYLE } from './styles';

/** Defaults of a mesh without a link. Older links of files leave these keys out, and mean the former defaults. */
export const NEW_FILE_DEFAULTS = { method: 'auto', up: AUTOMATIC } as const;

/** The state in which a mesh starts out; null for a preset that does not exist. */
export function startOf(mesh: MeshReference): SceneState | null {
  switch (mesh.kind) {
    case 'preset':
      return findPreset(mesh.id)?.start ?? null;
    case 'file':
      return emptyScene(mesh);
    case 'address':
      return startOfFile(mesh);
  }
}

/** The state in which a mesh that is opened from a file starts out where some of it is chosen beforehand. */
export function startOfFile(mesh: MeshReference): SceneState {
  return { ...emptyScene(mesh), ...NEW_FILE_DEFAULTS, style: MODEL_STYLE };
}
