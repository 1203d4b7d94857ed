/** One mesh at a time: asks the solver what the scene wants to know and shows the answers. */
import type { DistanceField, EdgeKind, ProgressListener, SceneryPart } from '../protocol';
import { SolverClient } from '../solver/client';
import type { Answer, Engine } from '../solver/engine';
import { Refiner } from '../solver/refiner';
import { Cancelled } from '../solver/remote';
import { visible, type Scene, type SceneState } from '../state/scene';
import { Signal } from '../state/signal';
import type { PaintedField, View } from '../view/view';
import { Walk } from '../view/walk';
import { type OpenRequest, prepare, type Shown } from './prepare';

/** A way home that takes longer is traced only when the hand rests. */
const LIVE_PATH_MS = 8;
/** A field that takes longer, a frame at 60 a second, has a small near field while a hand drags. */
const LIVE_FIELD_MS = 16;

/** Radians a second: a turn in sixteen seconds. */
const TURNTABLE_SPEED = Math.PI / 8;

export interface Loading {
  title: string;
  stage: string;
  /** 0 to 1 */
  fraction: number;
  vertices: number;
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
  /** Whether the model turns by itself. */
  readonly turntable = new Signal(false);
  /** Distance fields solved and shown since the page was opened; the slices of refining are not counted. */
  solves = 0;
  readonly refiner = new Refiner(
    (answer) => this.#refined(answer),
    (error) => this.#fail(error),
  );
  readonly #client = new SolverClient();
  #engine: Engine | null = null;
  /** The field shown, of distance. */
  #field: DistanceField | null = null;
  /** What periods of the look are shares of: of distance, the diameter. */
  #whole = 1;
  /** Yaw that the light is set up for, radians. */
  #facing = 0;
  /** How far the stripes have moved, in periods. */
  #flow = 0;
  #dragging = false;
  #quick = false;

  constructor(scene: Scene, view: View) {
    this.scene = scene;
    this.view = view;
    scene.subscribe((state, previous) => this.#follow(state, previous));
    this.paused.watch((paused) => {
      this.walk.paused = paused;
    });
    this.turntable.watch(() => this.showTurntable());
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

  /** During a drag a small near field may do, and the way home may wait until the hand rests. */
  set dragging(dragging: boolean) {
    const answer = this.shown.value?.answer;
    this.#dragging = dragging;
    // Decided once a drag: quick fields soon take less than a frame.
    this.#quick = dragging && (answer?.field?.solveMs ?? 0) > LIVE_FIELD_MS;
    if (dragging) this.refiner.interrupt();
    if (dragging || !answer) return;
    if (this.#isAnswered(answer)) this.#rest();
    else void this.#solve();
  }

  get dragging(): boolean {
    return this.#dragging;
  }

  /** Nothing is being opened, solved or refined, and no hand holds a source. */
  get settled(): boolean {
    return this.loading.value === null && (this.#engine === null || this.refiner.settled);
  }

  /** The field that the worker holds: the one shown, unless a question or a slice is under way. */
  gradients(kind: 'heat' | 'distance'): Promise<Float32Array> {
    return this.#open().gradients(kind);
  }

  heat(): Promise<Float32Array> {
    return this.#open().heat();
  }

  errors(): Promise<Float32Array | null> {
    return this.#open().errors();
  }

  edges(kind: EdgeKind): Promise<Float32Array> {
    return this.#open().edges(kind);
  }

  crowd(count: number): Promise<void> {
    return this.#open().crowd(count);
  }

  stepCrowd(step: number): Promise<Float32Array> {
    return this.#open().stepCrowd(step);
  }

  /** Paints another field in the place of distance, with periods as shares of `whole`; null for distance itself. */
  paint(instead: { field: PaintedField; whole: number } | null): void {
    this.view.setField(instead?.field ?? this.#field);
    const whole = instead?.whole ?? this.shown.value?.places.diameter ?? 1;
    if (whole !== this.#whole) {
      this.#whole = whole;
      this.#showLook();
    }
  }

  showTurntable(): void {
    this.view.spin = this.turntable.value ? TURNTABLE_SPEED : 0;
  }

  #showLook(): void {
    const { look } = this.scene.state;
    this.view.setLook(look, this.#whole, this.#facing);
    if (look.flow === 0) this.#flow = 0;
    this.#showOffset();
  }

  #showOffset(): void {
    this.view.setOffset(this.scene.state.look.offset + this.#flow);
  }

  #open(): Engine {
    if (!this.#engine) throw new Error('No mesh is open.');
    return this.#engine;
  }

  /** Takes what moves by itself further. */
  animate(seconds: number): void {
    const still = reducedMotion();
    const diameter = this.shown.value?.places.diameter ?? 1;
    if ((!still || this.walk.performs) && this.walk.advance(seconds, diameter)) this.view.setWalker(this.walk.arc);
    const { flow } = this.scene.state.look;
    if (flow !== 0 && !still && !this.paused.value) {
      this.#flow = (this.#flow + seconds * flow) % 1;
      this.#showOffset();
    }
  }

  #adopt(engine: Engine, state: SceneState, shown: Shown, view: OpenRequest['view']): void {
    // The one step that can fail, so the first: until then nothing of the old scene is let go.
    const { surface, scenery, drawTransform } = shown.opened;
    this.view.setMesh(surface, visible(scenery, state), drawTransform);
    this.#engine?.dispose();
    this.#engine = engine;
    this.failure.value = null;
    if (view) this.#facing = view[0];
    this.#whole = shown.places.diameter;
    this.view.setLook(state.look, this.#whole, this.#facing);
    if (state.camera) {
      this.view.camera = state.camera;
    } else if (view) {
      this.view.camera = [...view, 3, 0, 0, 0];
      this.view.frame();
    }
    this.#show(shown, true);
    this.scene.load(state);
    this.#showPins();
    this.#rest();
    // The next opening finds its worker compiled, and the first picture does not wait for it.
    setTimeout(() => this.#client.warmUp(), 1500);
  }

  #follow(state: SceneState, previous: SceneState): void {
    const { value: shown } = this.shown;
    if (!shown) return;
    if (state.look !== previous.look) {
      this.#showLook();
    }
    if (state.sources !== previous.sources || state.selected !== previous.selected) this.#showPins();
    this.#showScenery(shown.opened.scenery, state, previous);
    if (!this.#isAnswered(shown.answer)) void this.#solve();
    else if (state.refine !== previous.refine) this.#rest();
  }

  /** A new scenery is costly, so only where other parts are seen. */
  #showScenery(parts: readonly SceneryPart[], state: SceneState, previous: SceneState): void {
    const [now, before] = [visible(parts, state), visible(parts, previous)];
    if (now.length !== before.length || now.some((mesh, i) => mesh !== before[i])) this.view.setScenery(now);
  }

  async #solve(): Promise<void> {
    const engine = this.#engine;
    const { value: before } = this.shown;
    if (!engine || !before) return;
    const { sources, parameters, walker, way } = this.scene.state;
    const wait = this.#dragging && before.answer.pathMs > LIVE_PATH_MS;
    this.refiner.interrupt();
    try {
      const answer = await engine.ask({ sources, parameters, from: wait ? null : walker, way, quick: this.#quick });
      if (!answer || engine !== this.#engine) return;
      const moved = answer.question.from !== before.answer.question.from && !this.#dragging;
      const pathMs = wait ? before.answer.pathMs : answer.pathMs;
      this.#show({ ...before, answer: { ...answer, pathMs } }, moved);
      this.failure.value = null;
      if (!this.#dragging) this.#rest();
    } catch (error) {
      if (error instanceof Cancelled) return;
      this.refiner.giveUp();
      this.#fail(error);
    }
  }

  /** Begins the refinement of what is shown, unless a newer question is already asked. */
  #rest(): void {
    const { value: shown } = this.shown;
    const { state } = this.scene;
    if (this.#engine && shown && this.#isAnswered(shown.answer)) this.refiner.rest(this.#engine, shown.answer, state);
  }

  /** Whether an answer is to what the scene asks. */
  #isAnswered({ question }: Answer): boolean {
    const { sources, parameters, walker, way } = this.scene.state;
    return (
      question.sources === sources &&
      question.parameters === parameters &&
      question.from === walker &&
      question.way === way &&
      (this.#quick || !question.quick)
    );
  }

  #refined(answer: Answer): void {
    const { value: shown } = this.shown;
    if (shown) this.#show({ ...shown, answer }, false);
  }

  #fail(error: unknown): void {
    this.failure.value = error instanceof Error ? error : new Error(String(error));
  }

  #show(shown: Shown, fromStart: boolean): void {
    const { field, path, question } = shown.answer;
    this.#field = field;
    if (this.scene.state.painted === 'distance') this.paint(null);
    if (question.from || !this.#dragging) {
      this.view.setPath(path);
      this.walk.follow(path?.length ?? 0, fromStart);
      if (path) this.view.setWalker(this.walk.arc);
    }
    if (field?.refineMs === 0 && field !== this.shown.value?.answer.field) this.solves += 1;
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

export function reducedMotion(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}
