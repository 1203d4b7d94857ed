/** `window.heatwalk`: the page's scripting face, read-only. Described in docs/scripting.md. */
import type { SurfacePoint } from './protocol';
import type { SceneState } from './scene';
import type { Session } from './session';

export interface Heatwalk {
  /** Resolves when the first scene is solved and drawn, or when it is certain that nothing can be drawn. */
  readonly ready: Promise<void>;
  /** "WebGPU", "WebGL2", or null when nothing can be drawn. */
  readonly backend: string | null;
  readonly scene: SceneState;
  /** Where the camera is now: yaw, pitch (rad), distance and offset from the centre in bounding radii. */
  readonly camera: readonly number[] | null;
  /** The CSS pixel of the window on which models are centred. */
  readonly centre: readonly [number, number];
  readonly mesh: {
    name: string;
    triangles: number;
    vertices: number;
    components: number;
    boundaryLoops: number;
    parts: readonly string[];
    walked: readonly number[];
    diameter: number;
  } | null;
  /** Of the field that is shown. */
  readonly field: { maxDistance: number; unreachableVertices: number; solveMs: number } | null;
  /** Fields shown since the page was opened. */
  readonly solves: number;
  /** Arc lengths; null when nobody walks. */
  readonly walker: { arc: number; length: number; arrived: boolean } | null;
  /** Distance at a place of the shown field; Infinity out of reach; NaN where the mesh has no such place. */
  distanceAt(point: SurfacePoint): number;
  /** The place under a CSS pixel of the window. */
  placeAt(x: number, y: number): SurfacePoint | null;
  /** The CSS pixel of the window where a place is seen. */
  pixelOf(point: SurfacePoint): [number, number] | null;
}

declare global {
  interface Window {
    readonly heatwalk: Heatwalk;
  }
}

export function expose(session: Session, ready: Promise<void>): void {
  const face: Heatwalk = {
    ready,
    get backend() {
      return session.view.backend.value;
    },
    get scene() {
      return structuredClone(session.scene.state);
    },
    get camera() {
      return session.view.camera;
    },
    get centre() {
      return session.view.centre;
    },
    get mesh() {
      if (!session.shown.value) return null;
      const { opened, places } = session.shown.value;
      return {
        name: opened.name,
        triangles: opened.report.faces,
        vertices: opened.report.vertices,
        components: opened.report.components,
        boundaryLoops: opened.report.boundaryLoops,
        parts: opened.parts.map(({ name }) => name),
        walked: [...opened.walked],
        diameter: places.diameter,
      };
    },
    get field() {
      const field = session.shown.value?.answer.field;
      if (!field) return null;
      const { maxDistance, unreachableVertices, solveMs } = field;
      return { maxDistance, unreachableVertices, solveMs };
    },
    get solves() {
      return session.solves;
    },
    get walker() {
      const { arc, length, arrived } = session.walk;
      return length > 0 ? { arc, length, arrived } : null;
    },
    distanceAt(point) {
      const shown = session.shown.value;
      return shown?.answer.field ? shown.places.valueAt(point, shown.answer.field.distance) : Number.NaN;
    },
    placeAt: (x, y) => session.view.pick(x, y)?.point ?? null,
    pixelOf(point) {
      const position = session.shown.value?.places.at(point)?.position;
      return position ? session.view.project(position) : null;
    },
  };
  Object.defineProperty(window, 'heatwalk', { value: Object.freeze(face) });
}
