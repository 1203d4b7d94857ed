/** One mesh at a time: asks the solver what the scene wants to know and shows the answers. */
import type { ProgressListener, MeshInput, OpenedMesh } from './protocol';
import { Places } from './places';
import { type Scene, type SceneState } from './scene';
import { Signal } from './signal';
import { type Answer, Cancelled, type Engine, SolverClient } from './solver';
import type { View } from './view';
import { Walk } from './walk';

/** A way home that takes longer is traced only when the hand rests. */
const LIVE_PATH_MS = 8;

export interface Loading {
  title: string;
  stage: string;
  /** 0 to 1 */
  fraction: number;
  vertices: number;
}

export interface Shown {
  opened: OpenedMesh;
  places: Places;
  answer: Answer;
}

export interface OpenRequest {
  title: string;
  load: () => Promise<MeshInput>;
  state: SceneState;
  /** Puts a source and a walker where the state has none. */
  choosePlaces: boolean;
  /** Yaw and pitch to frame from when the state has no camera; null keeps the camera as it is. */
  view: readonly [number, number] | null;
}

export class Session {
  readonly scene: Scene;
  readonly view: View;
  readonly walk = new Walk();
  readonly loading = new Signal<Loading | null>(null);
  readonly shown = new Signal<Shown | null>(null);
  /** A question to the solver failed. */
  readonly failure = new Signal<Error | null>(null);
  readonly paused = new Signal(false);
  /** Distance fields shown since the page was opened. */
  solves = 0;
  readonly #client = new SolverClient();
  #engine: Engine | null = null;
  #dragging = false;

  constructor(scene: Scene, view: View) {
    this.scene = scene;
    this.view = view;
    scene.subscribe((state, previous) => this.#follow(state, previous));
    this.paused.watch((paused) => {
      this.walk.paused = paused;
    });
  }

  /** Shows another mesh once it is solved; until then, and if this rejects, everything stays as it was. */
  async open(request: OpenRequest): Promise<Shown> {
    const report: ProgressListener = ({ stage, fraction, vertices }) => {
      if (this.loading.value === mine) {
        mine = { title: request.title, stage, fraction, vertices };
        this.loading.value = mine;
      }
    };
    let mine: Loading = { title: request.title, stage: 'Fetching', fraction: 0, vertices: 0 };
    this.loading.value = mine;
    const { parts, parameters } = request.state;
    let engine: Engine | null = null;
    try {
      engine = await this.#client.open(request.load, parts, parameters, report);
      const { state, shown } = await prepare(engine, request);
      if (this.loading.value !== mine) throw new Cancelled();
      this.#adopt(engine, state, shown, request.view);
      return shown;
    } catch (error) {
      engine?.dispose();
      throw error;
    } finally {
      if (this.loading.value === mine) this.loading.value = null;
    }
  }

  cancelOpening(): void {
    this.loading.value = null;
    this.#client.cancel();
  }

  /** During a drag the way home may wait until the hand rests. */
  set dragging(dragging: boolean) {
    this.#dragging = dragging;
    const answer = this.shown.value?.answer;
    if (!dragging && answer && answer.question.from !== this.scene.state.walker) void this.#solve();
  }

  /** To be called once a frame; true if something was drawn. */
  frame(seconds: number): boolean {
    const diameter = this.shown.value?.places.diameter ?? 1;
    if (!reducedMotion() && this.walk.advance(seconds, diameter)) this.view.setWalker(this.walk.arc);
    return this.view.render(seconds);
  }

  #adopt(engine: Engine, state: SceneState, shown: Shown, view: OpenRequest['view']): void {
    this.#engine?.dispose();
    this.#engine = engine;
    this.failure.value = null;
    this.view.setMesh(shown.opened);
    this.view.setLook(state.look, shown.places.diameter);
    if (state.camera) {
      this.view.camera = state.camera;
    } else if (view) {
      this.view.camera = [...view, 3, 0, 0, 0];
      this.view.frame();
    }
    this.#show(shown, true);
    this.scene.load(state);
    this.#showPins();
    // The next opening finds its worker compiled, and the first picture does not wait for it.
    setTimeout(() => this.#client.warmUp(), 1500);
  }

  #follow(state: SceneState, previous: SceneState): void {
    const { value: shown } = this.shown;
    if (!shown) return;
    if (state.look !== previous.look) this.view.setLook(state.look, shown.places.diameter);
    if (state.sources !== previous.sources || state.selected !== previous.selected) this.#showPins();
    const { question } = shown.answer;
    const asked = question.sources === state.sources && question.parameters === state.parameters;
    if (!asked || question.from !== state.walker) void this.#solve();
  }

  async #solve(): Promise<void> {
    const engine = this.#engine;
    const { value: before } = this.shown;
    if (!engine || !before) return;
    const { sources, parameters, walker } = this.scene.state;
    const wait = this.#dragging && before.answer.pathMs > LIVE_PATH_MS;
    try {
      const answer = await engine.ask({ sources, parameters, from: wait ? null : walker });
      if (!answer || engine !== this.#engine) return;
      const moved = answer.question.from !== before.answer.question.from && !this.#dragging;
      const pathMs = wait ? before.answer.pathMs : answer.pathMs;
      this.#show({ ...before, answer: { ...answer, pathMs } }, moved);
      this.failure.value = null;
    } catch (error) {
      if (!(error instanceof Cancelled)) this.failure.value = error instanceof Error ? error : new Error(String(error));
    }
  }

  #show(shown: Shown, fromStart: boolean): void {
    const { field, path, question } = shown.answer;
    this.view.setDistance(field?.distance ?? new Float32Array(), field?.maxDistance ?? 0);
    if (question.from || !this.#dragging) {
      this.view.setPath(path);
      this.walk.follow(path?.length ?? 0, fromStart);
      if (path) this.view.setWalker(this.walk.arc);
    }
    this.solves += 1;
    this.shown.value = shown;
  }

  #showPins(): void {
    const places = this.shown.value?.places;
    const { sources, selected } = this.scene.state;
    if (!places) return;
    this.view.setPins(
      sources.map((source) => places.at(source)).filter((place) => place !== null),
      selected,
    );
  }
}

/** Makes the state fit the mesh and solves it for the first time. */
async function prepare(engine: Engine, request: OpenRequest): Promise<{ state: SceneState; shown: Shown }> {
  const { opened } = engine;
  const places = new Places(opened);
  const { parameters } = request.state;
  let sources = request.state.sources.filter((source) => places.has(source));
  let walker = request.state.walker && places.has(request.state.walker) ? request.state.walker : null;
  if (request.choosePlaces && sources.length === 0) sources = [places.extreme([0.5, 0.4, 0.75])];
  let answer = await ask(engine, { sources, parameters, from: walker });
  if (request.choosePlaces && !walker && answer.field) {
    walker = places.farthest(answer.field.distance);
    answer = await ask(engine, { sources, parameters, from: walker });
  }
  const { mesh } = request.state;
  return {
    state: {
      ...request.state,
      mesh: mesh.kind === 'file' ? { ...mesh, hash: opened.hash } : mesh,
      sources,
      walker,
      selected: -1,
    },
    shown: { opened, places, answer },
  };
}

async function ask(engine: Engine, question: Answer['question']): Promise<Answer> {
  const answer = await engine.ask(question);
  if (!answer) throw new Cancelled();
  return answer;
}

export function reducedMotion(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}
