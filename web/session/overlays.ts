/** What is shown beside the distance, or in its place: other fields, arrows, edges. Asks the solver for what is wanted. */
import type { DistanceField, PathCurves } from '../protocol';
import type { Engine } from '../solver/engine';
import { OF_HEAT, type Overlay, type SceneState } from '../state/scene';
import {
  type EdgeKind,
  FACE_FIELD,
  type FaceField,
  type Method,
  VERTEX_FIELD,
  type VertexField,
} from '../wasm/contract';
import { type Edges, rimmed } from '../view/layers';
import type { Cells } from './cells';
import type { Decals } from './decals';
import type { Directions } from './directions';
import type { Paths } from './paths';
import type { Offsets } from './offsets';
import { drawnIsolines } from './isolines';
import type { Session } from './session';

/** In the order in which they are drawn, so that the rarer ones stay on top. */
const EDGES: readonly { overlay: Overlay; kind: EdgeKind; colour: string }[] = [
  { overlay: 'edges', kind: 'mesh', colour: '#2b3036' },
  { overlay: 'operator', kind: 'operator', colour: '#1667d9' },
  { overlay: 'boundary', kind: 'boundary', colour: '#e0248a' },
  { overlay: 'contacts', kind: 'contact', colour: '#e87500' },
];

const ISOLINES = { colour: '#e5202e', width: 1.6 };
/** What the overlays depend on, beside the answer. */
const OTHERS = ['overlays', 'colorBy', 'heading'] as const;
const PATHS: readonly PathCurves[] = ['loops', 'loop', 'bezier'];
/** Of their rims: they are many. */
const RIMS = 0.5;

export class Overlays {
  readonly #session: Session;
  /** Counts what was wanted: an answer to an older wish is dropped. */
  #wish = 0;
  /** Whether edges are to be asked for, also where the wish that said so was overtaken. */
  #needsEdges = true;
  #latest: Promise<void> = Promise.resolve();
  /** Once they were wanted. */
  #cells: Promise<Cells> | undefined;
  #decals: Promise<Decals> | undefined;
  #offsets: Promise<Offsets> | undefined;
  #directions: Promise<Directions> | undefined;
  readonly #paths = new Map<PathCurves, Promise<Paths>>();

  constructor(session: Session) {
    this.#session = session;
  }

  /** Resolves when everything that is wanted is shown. */
  async settled(): Promise<void> {
    for (let latest; latest !== this.#latest;) {
      latest = this.#latest;
      await latest;
    }
  }

  /** Keeps the view up to date from now on. */
  follow(): void {
    const session = this.#session;
    session.scene.subscribe((state, previous) => {
      const isElsewhere = state.style.period !== previous.style.period || state.isolines !== previous.isolines;
      const isSpaced = (state.overlays.includes('isolines') || state.overlays.includes('curves')) && isElsewhere;
      const isOther = OTHERS.some((field) => state[field] !== previous[field]);
      if (isSpaced || isOther) this.#latest = this.#update(true);
      if (state.decals !== previous.decals)
        this.#latest = Promise.all([this.#latest, this.#lay()]).then(() => undefined);
    });
    session.pose.watch(() => {
      const { overlays } = session.scene.state;
      if (overlays.some((overlay) => overlay !== 'scenery')) this.#latest = this.#update(true);
      else void this.#lay();
    });
    session.shown.watch((shown, previous) => {
      const anew =
        shown?.opened !== previous?.opened ||
        shown?.answer.factoring !== previous?.answer.factoring ||
        shown?.answer.question.method !== previous?.answer.question.method;
      if (shown) this.#latest = this.#update(anew);
    });
  }

  /** Edges belong to the mesh and the parameters, the others to the field. */
  async #update(anew: boolean): Promise<void> {
    const wish = ++this.#wish;
    const session = this.#session;
    this.#needsEdges ||= anew || session.scene.state.overlays.includes('isolines');
    const { view } = session;
    const { answer } = session.shown.value ?? {};
    const field = answer?.field ?? null;
    const { engine } = session;
    // A fresh worker's first answer asks again.
    if (!engine || !answer) return;
    const { method } = answer.question;
    const { overlays, colorBy } = available(session.scene.state, method);
    try {
      const edges = this.#needsEdges ? await edgesOf(engine, overlays) : null;
      const isolines = edges && overlays.includes('isolines') ? drawnIsolines(session) : null;
      if (isolines) {
        const ends = await engine.queries.isolineEnds(isolines);
        edges?.push(...rimmed({ ...ISOLINES, ends }, RIMS));
      }
      if (overlays.includes('cells')) this.#cells ??= import('./cells').then(({ Cells }) => new Cells(session));
      if (overlays.includes('curves'))
        this.#offsets ??= import('./offsets').then(({ Offsets }) => new Offsets(session));
      if (overlays.includes('carried'))
        this.#directions ??= import('./directions').then(({ Directions }) => new Directions(session));
      for (const kind of PATHS) {
        if (!overlays.includes(kind) || this.#paths.has(kind)) continue;
        const paths = import('./paths').then(({ Paths }) => new Paths(session, kind));
        this.#paths.set(kind, paths);
      }
      const besides = [this.#cells, this.#offsets, this.#directions, ...this.#paths.values()];
      const beside = besides.map((one) => one?.then((shown) => shown.follow()));
      beside.push(this.#lay());
      const kind = FACE_FIELD.names.find((vectors) => overlays.includes(vectors));
      const arrows = kind && field ? await this.#arrowsOf(engine, kind, field) : new Float32Array();
      const other = colorBy === 'distance' || !field ? null : await instead(engine, colorBy, field);
      if (wish !== this.#wish) return;
      if (edges) {
        view.setEdges('overlays', edges);
        this.#needsEdges = false;
      }
      if (!overlays.includes('carried')) view.setArrows(arrows);
      session.paint(other);
      await Promise.all(beside);
    } catch (error) {
      // The answer by another method asks again.
      if (wish === this.#wish && method === session.scene.state.method) session.fail(error);
    }
  }

  /** Lays the images of the scene on the surface. */
  async #lay(): Promise<void> {
    const session = this.#session;
    if (session.scene.state.decals.length > 0)
      this.#decals ??= import('./decals').then(({ Decals }) => new Decals(session));
    await (await this.#decals)?.follow();
  }

  async #arrowsOf(
    { opened, queries }: Engine,
    kind: FaceField,
    { finer: drawn, byCorner }: DistanceField,
  ): Promise<Float32Array> {
    const { finer } = opened.surface;
    const isDrawnSo = kind === 'distance' && this.#session.pose.value === null;
    if (!finer || !drawn || !isDrawnSo) return queries.gradients(kind);
    return (await import('../view/finer')).gradientsOn(finer, drawn.distance, byCorner);
  }
}

/** What is wanted, without what only the heat method has. */
export function available({ overlays, colorBy }: SceneState, method: Method): Pick<SceneState, 'overlays' | 'colorBy'> {
  if (method === 'heat') return { overlays, colorBy };
  return {
    overlays: overlays.filter((overlay) => !OF_HEAT.overlays.includes(overlay)),
    colorBy: OF_HEAT.colorBy.includes(colorBy) ? VERTEX_FIELD.default : colorBy,
  };
}

async function edgesOf(engine: Engine, overlays: readonly Overlay[]): Promise<Edges[]> {
  const edges: Edges[] = [];
  for (const { overlay, kind, colour } of EDGES) {
    if (overlays.includes(overlay)) edges.push({ ends: await engine.queries.edges(kind), colour });
  }
  return edges;
}

/** The field that is shown instead of the distance. */
export async function instead(
  engine: Engine,
  colorBy: VertexField,
  { distance, tangents, byCorner }: DistanceField,
): Promise<Parameters<Session['paint']>[0]> {
  if (colorBy === 'heat') {
    // In powers of ten below the hottest place, so that it grows away from the sources as distance does.
    const cold = (await engine.queries.heat()).map((logarithm) => -logarithm);
    const whole = largest(cold);
    return { field: { distance: cold, tangents, maxDistance: whole, byCorner }, whole };
  }
  const errors = (await engine.queries.errors()) ?? new Float32Array(distance.length);
  // Errors are noise from vertex to vertex, so they have colours and no stripes.
  const field = { distance: errors, tangents: new Int8Array(tangents.length), maxDistance: largest(errors), byCorner };
  return { field, whole: 0 };
}

function largest(values: Float32Array): number {
  return values.reduce((most, value) => (Number.isFinite(value) && value > most ? value : most), 0);
}
