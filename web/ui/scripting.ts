/** `window.heatwalk`: the page's scripting API, with lengths in the unit of the model. Described in docs/scripting.md. */
import type { Distances, MeshFigures, Openable, Options, Path, Place, Source, State } from '../embed';
import type { Clip, DistanceField, FaceField, Moment, PathKind, MeshPoint } from '../protocol';
import { bestDistanceAt, exactDistanceAt } from '../session/distances';
import type { Session } from '../session/session';
import type { TapeFigures } from '../session/tapes';
import type { Engine } from '../solver/engine';
import type { Phase } from '../solver/refiner';
import { unitOf } from '../length';
import { PRESETS } from '../state/presets';
import type { SceneState } from '../state/scene';
import { until } from '../state/signal';
import { png } from '../view/picture';
import type { Up } from '../wasm/contract';

/** What changes the page, and what waits for its answer. Whatever is wrong with it rejects, and the scene stays. */
export interface Script {
  /** Opens a mesh, and resolves once it is shown. */
  open(what: Openable): Promise<MeshFigures>;
  /** Changes the scene by keys of the link and their values. */
  set(options: Options): Promise<void>;
  /** In the place of the single sources that there are; sets of sources stay. */
  setSources(sources: readonly Source[]): Promise<void>;
  /** Null takes the walker away. */
  setWalker(walker: Place | null): Promise<void>;
  setTapes(tapes: readonly { points: readonly Place[]; closed?: boolean }[]): Promise<void>;
  /** What keys and the search do: names in the language of the page, and keys, the same in each. */
  commands(): Promise<readonly { name: string; keys: readonly string[] }[]>;
  /** Does a command, by one of its keys or its name. */
  run(command: string): Promise<void>;
  /** Figures of what is shown, with a link to it. */
  state(): Promise<State>;
  /** Once nothing is solved any more; null without sources. */
  distances(): Promise<Distances | null>;
  /** Likewise; null without a walker, and where no source reaches it. */
  path(): Promise<Path | null>;
}

const SCRIPT = [
  'open',
  'set',
  'setSources',
  'setWalker',
  'setTapes',
  'commands',
  'run',
  'state',
  'distances',
  'path',
] as const satisfies readonly (keyof Script)[];

export interface Heatwalk extends Script {
  /** Resolves when the first scene is solved and drawn, or when it is certain that nothing can be drawn. */
  readonly ready: Promise<void>;
  /**
   * Resolves when nothing is being opened, solved or measured by tapes and refining has ended: everything is exact, or `refining`
   * says why not.
   */
  settled(): Promise<void>;
  /** "WebGPU", "WebGL2", or null when nothing can be drawn. */
  readonly backend: string | null;
  readonly scene: SceneState;
  /** Where the camera is now: yaw, pitch (rad), distance and offset from the centre in bounding radii. */
  readonly camera: readonly number[] | null;
  /** Names of the presets, as links write them. */
  readonly presets: readonly string[];
  /** The CSS pixel of the window on which models are centred. */
  readonly centre: readonly [number, number];
  readonly mesh: {
    name: string;
    triangles: number;
    vertices: number;
    components: number;
    boundaryLoops: number;
    parts: readonly string[];
    active: readonly number[];
    diameter: number;
    /** The symbol of the unit in which the page shows lengths; empty where there is none. */
    unit: string;
    /** The length of the model's unit, which all lengths here are in, in that one. */
    scale: number;
    /** The axis of the file that is drawn upward. */
    up: Up;
    /** How many it has inside; 0 for a surface. */
    tetrahedra: number;
    /** Of these, in the unit of the file cubed. */
    volume: number;
  } | null;
  /** The animations of the file, by name, and the moment that is shown: null where that is the pose in the file. */
  readonly animation: { clips: readonly Clip[]; moment: Moment | null };
  /** Of the field that is shown. */
  readonly field: Omit<DistanceField, 'distance' | 'tangents' | 'inner'> | null;
  /** Stored entries of all Cholesky factors of the mesh on screen; 0 where nothing is factored. */
  readonly factorNonzeros: number;
  /** State of refinement: see `Phase`. */
  readonly refining: Phase;
  /** Fields solved and shown since the page was opened; refinement steps are not counted. */
  readonly solves: number;
  /** Arc lengths, what the path costs, and its kind; null without a walker. */
  readonly walker: { arc: number; length: number; cost: number; arrived: boolean; kind: PathKind } | null;
  /** What tapes measure, in the unit of the file; lengths and areas that are not known, or are none, are null. */
  readonly tapes: readonly TapeFigures[];
  /** Distance at a place of the shown field, linear between those of vertices; Infinity where no source reaches; NaN where the mesh has no such place. */
  distanceAt(point: MeshPoint): number;
  /** The exact one, as `Queries.exactDistances`. */
  exactDistanceAt(point: MeshPoint): Promise<number | null>;
  /** The best that is known, as the page shows it under the pointer; null without a field. */
  bestDistanceAt(point: MeshPoint): Promise<number | null>;
  /** #F × 3: vectors of the triangles by the field held by the solver; `Queries.gradients` says which. */
  gradients(kind: FaceField): Promise<Float32Array>;
  /** Logarithm of heat at the drawn vertices, as `Queries.heat` gives it. */
  heat(): Promise<Float32Array>;
  /**
   * A PNG of the scene once all is settled, `scale` times as large as the window, with a transparent background if `clear`; with
   * the legend if `legend`, where the page shows one.
   */
  picture(scale?: number, clear?: boolean, legend?: boolean): Promise<Blob>;
  /** The place under a CSS pixel of the window. */
  placeAt(x: number, y: number): MeshPoint | null;
  /** The CSS pixel of the window where a place is seen. */
  pixelOf(point: MeshPoint): [number, number] | null;
}

declare global {
  interface Window {
    readonly heatwalk: Heatwalk;
  }
}

/**
 * `decorated` resolves when what is shown beside the field is there, `answered` when what is asked for by it is: tapes and the other
 * side of a comparison. `tapes`: what they tell. `load`: what changes the page.
 */
export function expose(
  session: Session,
  ready: Promise<void>,
  decorated: () => Promise<void>,
  answered: () => Promise<void>,
  tapes: { readonly figures: readonly TapeFigures[] },
  load: () => Promise<Script>,
): void {
  const asked = SCRIPT.map((name) => [
    name,
    async (...given: unknown[]) => ((await load())[name] as (...all: unknown[]) => unknown)(...given),
  ]);
  const api: Heatwalk = {
    ...(Object.fromEntries(asked) as Script),
    ready,
    async settled() {
      await ready;
      // What is asked for by the answer takes its time, and meanwhile there may be another question.
      do {
        await until(
          () => session.settled,
          session.loading,
          session.refiner.phase,
          session.pose,
          session.animator.moment,
        );
        await answered();
      } while (!session.settled);
    },
    get backend() {
      return session.view.backend.value;
    },
    get scene() {
      return structuredClone(session.scene.state);
    },
    get camera() {
      return session.view.camera;
    },
    presets: PRESETS.map(({ id }) => id),
    get centre() {
      return session.view.centre;
    },
    get mesh() {
      if (!session.shown.value) return null;
      const { opened, places } = session.shown.value;
      const { symbol: unit, scale } = unitOf(session.scene.state, opened);
      return {
        name: opened.name,
        triangles: opened.report.faces,
        vertices: opened.report.vertices,
        components: opened.report.components,
        boundaryLoops: opened.report.boundaryLoops,
        parts: opened.parts.map(({ name }) => name),
        active: [...opened.active],
        diameter: places.diameter,
        unit,
        scale,
        up: opened.drawTransform.up,
        tetrahedra: opened.interior?.report.tetrahedra ?? 0,
        volume: opened.interior?.report.volume ?? 0,
      };
    },
    get animation() {
      return { clips: session.shown.value?.opened.clips ?? [], moment: session.pose.value };
    },
    get field() {
      const field = session.shown.value?.answer.field;
      if (!field) return null;
      const { distance: _distance, tangents: _tangents, inner: _inner, finer: _finer, ...figures } = field;
      return figures;
    },
    get factorNonzeros() {
      return session.shown.value?.answer.factoring.factorNonzeros ?? 0;
    },
    get refining() {
      return session.refiner.phase.value;
    },
    get solves() {
      return session.solves;
    },
    get walker() {
      const { arc, length, arrived } = session.walk;
      const { pathKind: kind, path } = session.shown.value?.answer ?? {};
      return kind && length > 0 ? { arc, length, cost: path?.cost ?? length, arrived, kind } : null;
    },
    get tapes() {
      return tapes.figures;
    },
    distanceAt(point) {
      const shown = session.shown.value;
      return shown?.answer.field ? shown.places.valueAt(point, shown.answer.field) : Number.NaN;
    },
    exactDistanceAt: (point) => exactDistanceAt(session, point),
    bestDistanceAt: (point) => bestDistanceAt(session, point),
    gradients: async (kind) => openEngine(session).queries.gradients(kind),
    heat: async () => openEngine(session).queries.heat(),
    async picture(scale = 1, clear = false, legend = false) {
      await api.settled();
      // What is wanted since the field came is asked for in the next frame.
      await new Promise(requestAnimationFrame);
      await decorated();
      return png(session.view, scale, clear, legend);
    },
    placeAt: (x, y) => session.view.pick(x, y)?.point ?? null,
    pixelOf(point) {
      const position = session.shown.value?.places.at(point)?.position;
      return position ? session.view.project(position) : null;
    },
  };
  Object.defineProperty(window, 'heatwalk', { value: Object.freeze(api) });
}

function openEngine({ engine }: Session): Engine {
  if (!engine) throw new Error('No mesh is open.');
  return engine;
}
