/** One mesh at a time: asks the solver what the scene wants to know and shows the answers. */
import { Failure, isUnsolved, toError } from '../error';
import type { CurveDistances, FoundPaths, Moment, OpenedMesh, PathCurves, Posed, ProgressListener } from '../protocol';
import { SolverClient } from '../solver/client';
import { type Answer, type Engine, isFieldOf, isSameMoment, type Question } from '../solver/engine';
import { Refiner } from '../solver/refiner';
import { Cancelled, WorkerLost } from '../solver/remote';
import { isOutOfMemory } from '../solver/trap';
import { ofModel, unitOf } from '../length';
import type { ShownCells } from '../state/cells';
import type { LaidImage } from '../state/decals';
import { measure } from '../state/measures';
import { Places } from '../state/places';
import type { Scene } from '../state/history';
import { type SceneState, upOf } from '../state/scene';
import { Signal } from '../state/signal';
import type { View } from '../view/view';
import type { Walk } from '../view/walk';
import type { Method } from '../wasm/contract';
import { Animator } from './animator';
import { pageHidden } from './hidden';
import { type Loading, type LoadingListener, whileLoading } from './loading';
import { type OpenRequest, prepare, questionOf, type Shown, suited, wantedOf } from './prepare';
import { Presenter } from './presenter';
import { t, type Words } from '../texts';

/** A path that takes longer is traced only when the pointer rests. */
const LIVE_PATH_MS = 8;
/** A field that takes longer, a frame at 60 a second, is solved with less accuracy while the pointer drags. */
const LIVE_FIELD_MS = 16;

/** Triangles of a mesh whose first answer takes many frames, so that it is drawn before. */
const LEAST_PREVIEWED = 100_000;

/** Until the worker of the next opening is started. */
const WARM_UP_MS = 1500;

/** Radians a second: a turn in sixteen seconds. */
const TURNTABLE_SPEED = Math.PI / 8;

/** A mesh without an answer. */
export interface Preview {
  title: Words;
  opened: OpenedMesh;
}

/** Another worker that is made ready for the mesh on screen, turned or with the factors of the heat method. */
interface Preparing {
  kind: 'turned' | 'factored';
  /** The method by which the worker in use is asked until then; null: that of the scene. */
  meanwhile: Method | null;
}

interface OnScreen {
  /** What the mesh was opened by. */
  readonly request: OpenRequest;
  preparing: Preparing | null;
}

/** Before the first mesh; while a worker answers for the one on screen; while that worker is lost. */
type Phase =
  | { readonly kind: 'empty' }
  | (OnScreen & {
      readonly kind: 'answering';
      readonly engine: Engine;
      /** What was asked last, while it is under way. */
      asked: Question | null;
      /** Whether another pose is under way that distance is not measured in. */
      posing: boolean;
    })
  | (OnScreen & { readonly kind: 'lost'; readonly lost: WorkerLost });

/** A drag under way. */
interface Drag {
  readonly paints: boolean;
  /** Whether fields are solved with less accuracy: decided once, since quick fields soon take less than a frame. */
  readonly quick: boolean;
}

export class Session {
  readonly scene: Scene;
  readonly view: View;
  readonly loading = new Signal<Loading | null>(null);
  readonly shown = new Signal<Shown | null>(null);
  /** The mesh that is drawn in place of the scene until its first answer has come. */
  readonly preview = new Signal<Preview | null>(null);
  /** A question to the solver failed, or the worker that holds the mesh was lost. */
  readonly failure = new Signal<Error | null>(null);
  /** What is nearest to each source, where that is shown. */
  readonly cells = new Signal<ShownCells | null>(null);
  /** The distance from curves, where that is shown. */
  readonly offsets = new Signal<CurveDistances | null>(null);
  /** Curves of paths, where they are shown. */
  readonly paths: Readonly<Record<PathCurves, Signal<FoundPaths | null>>> = {
    loops: new Signal<FoundPaths | null>(null),
    loop: new Signal<FoundPaths | null>(null),
    bezier: new Signal<FoundPaths | null>(null),
  };
  /** Images as they lie on the surface, and which of the scene's is selected; −1 for none. */
  readonly decals = new Signal<readonly LaidImage[]>([]);
  readonly decal = new Signal(-1);
  /** The pose that the mesh on screen is shown in; null: that of its file. */
  readonly pose = new Signal<Moment | null>(null);
  readonly animator: Animator;
  readonly paused = new Signal(false);
  /** Whether the model turns by itself. */
  readonly turntable = new Signal(false);
  /** Distance fields solved and shown since the page was opened; refinement steps are not counted. */
  solves = 0;
  readonly isHidden = pageHidden();
  readonly refiner = new Refiner(
    (answer) => this.#refined(answer),
    (error) => this.fail(error),
    this.isHidden,
  );
  readonly #client = new SolverClient();
  readonly #presenter: Presenter;
  #phase: Phase = { kind: 'empty' };
  #drag: Drag | null = null;
  /** What was asked when a worker was lost last, as text. */
  #fatal = '';

  constructor(scene: Scene, view: View) {
    this.scene = scene;
    this.view = view;
    this.#presenter = new Presenter(scene, view);
    this.animator = new Animator(scene);
    scene.subscribe((state, previous) => this.#follow(state, previous));
    this.paused.watch((paused) => {
      this.walk.paused = paused;
      // What was measured in passing is measured well where it stops.
      const answer = this.shown.value?.answer;
      if (paused && answer && !this.#isAnswered(answer)) void this.#solve();
    });
    this.turntable.watch(() => this.showTurntable());
  }

  get walk(): Walk {
    return this.#presenter.walk;
  }

  /** What the mesh on screen was opened by; null before the first. */
  get request(): OpenRequest | null {
    return this.#phase.kind === 'empty' ? null : this.#phase.request;
  }

  /** Where the mesh on screen can be asked; null before the first, and while its worker is lost. */
  get engine(): Engine | null {
    return this.#phase.kind === 'answering' ? this.#phase.engine : null;
  }

  /** Shows another mesh once it is solved, a large one ahead of that; if this rejects, everything is as it was. */
  open(request: OpenRequest): Promise<Shown> {
    return this.#open(request, false);
  }

  /** `keeps`: the scene stays as it is by then, and only the mesh is another. */
  #open(request: OpenRequest, keeps: boolean): Promise<Shown> {
    return whileLoading(this.loading, request.title, async (progress, signal) => {
      try {
        const built = (opened: OpenedMesh) => this.#preview(opened, request);
        const engine = await this.#start(request, request.state, progress, signal, built);
        try {
          const wanted = suited(request, engine.opened);
          const { state, shown } = await prepare(engine, wanted);
          signal.throwIfAborted();
          this.#adopt(engine, keeps ? null : state, shown, wanted);
          return shown;
        } catch (error) {
          engine.dispose();
          throw error;
        }
      } finally {
        this.#presenter.endPreview();
        this.preview.value = null;
      }
    });
  }

  /** Does what an opening has to wait for, which `work` ends with; it is cancelled as an opening is, by another one too. */
  gather(title: Words, work: (progress: LoadingListener, signal: AbortSignal) => Promise<void>): Promise<void> {
    this.cancelOpening();
    return whileLoading(this.loading, title, work);
  }

  cancelOpening(): void {
    this.loading.value = null;
    this.#client.cancel();
  }

  /** During a drag a small exact region, or the values of vertices may do, and the path may wait until the pointer rests. */
  set dragging(dragging: boolean) {
    this.#setDrag(dragging, false);
  }

  /** While the ground is painted, fields follow by a window, also where they are by heat: that has to be factored anew. */
  set painting(painting: boolean) {
    this.#setDrag(painting, true);
  }

  get dragging(): boolean {
    return this.#drag !== null;
  }

  #setDrag(begins: boolean, paints: boolean): void {
    const answer = this.shown.value?.answer;
    if (begins) {
      this.#drag = { paints, quick: paints || (answer?.field?.solveMs ?? 0) > LIVE_FIELD_MS };
      this.refiner.interrupt();
      return;
    }
    this.#drag = null;
    if (!answer) return;
    if (this.#isAnswered(answer)) this.#rest();
    else void this.#solve();
  }

  /** Nothing is being opened, solved or refined, and no source is dragged. */
  get settled(): boolean {
    if (this.loading.value !== null) return false;
    const isPosed = this.animator.plays || isSameMoment(this.pose.value, this.animator.moment.value);
    return this.engine === null || (this.refiner.settled && isPosed);
  }

  /** Whether what is shown is an older answer, since what the scene asks could not be answered. */
  get isOutdated(): boolean {
    const { value: shown } = this.shown;
    return this.failure.value !== null && shown !== null && !this.#isAnswered(shown.answer);
  }

  /** Paints another field in the place of distance, with periods as shares of `whole`; null for distance itself. */
  paint(instead: Parameters<Presenter['paint']>[0]): void {
    this.#presenter.paint(instead);
  }

  /** The surface as it is painted; null without a field. */
  get painted(): Presenter['painted'] {
    return this.#presenter.painted;
  }

  /** Takes what moves by itself further. */
  animate(seconds: number): void {
    if (!this.paused.value) this.animator.advance(seconds);
    void this.#pose();
    this.#presenter.animate(seconds);
  }

  /** Shows the pose that is wanted, unless one is under way. */
  async #pose(): Promise<void> {
    const phase = this.#phase;
    const moment = this.animator.moment.value;
    if (phase.kind !== 'answering' || phase.posing || !this.shown.value) return;
    if (isSameMoment(moment, this.pose.value)) return;
    if (this.scene.state.animation.live) {
      // The answer brings the pose.
      if (!this.#isAnswered(this.shown.value.answer)) void this.#solve();
      return;
    }
    phase.posing = true;
    try {
      const posed = await phase.engine.pose(moment);
      if (posed && phase === this.#phase) this.#showPose(posed, moment);
    } catch (error) {
      this.fail(error);
    } finally {
      phase.posing = false;
    }
  }

  /** Shows the pose that a field was measured in. */
  #showMeasured({ posed, question }: Answer): void {
    if (posed && question.moment) this.#showPose(posed, question.moment);
  }

  #showPose(posed: Posed, moment: Moment | null): void {
    this.#presenter.pose(posed);
    this.pose.value = moment;
  }

  showTurntable(): void {
    this.view.spin = this.turntable.value ? TURNTABLE_SPEED : 0;
  }

  /**
   * Tells that a question failed. What a worker that has ended leaves unanswered is no failure of its own, nor is what is asked beside
   * a field while the worker holds none: the next one is on its way, or its failure is told.
   */
  fail(error: unknown): void {
    if (error instanceof Cancelled || error instanceof WorkerLost) return;
    if (isUnsolved(error) && this.shown.value?.answer.field) return;
    this.failure.value = toError(error);
  }

  /** A worker that has opened a mesh for a state. Unless it answers for the mesh on screen by then, it ends with `signal`. */
  async #start(
    { load }: OpenRequest,
    state: SceneState,
    progress: ProgressListener,
    signal: AbortSignal,
    built?: (opened: OpenedMesh) => void,
  ): Promise<Engine> {
    const engine = await this.#client.open(load, wantedOf(state), progress, built);
    const end = () => {
      if (engine !== this.engine) engine.dispose();
    };
    signal.addEventListener('abort', end);
    if (signal.aborted) end();
    const { finer, discs } = engine.opened.surface;
    if (finer) this.view.drawBy((await import('../view/finer')).drawingFiner);
    if (discs) this.view.drawBy((await import('../view/discs')).drawingDiscs);
    return engine;
  }

  #preview(opened: OpenedMesh, request: OpenRequest): void {
    const triangles = opened.report.faces;
    if (triangles < LEAST_PREVIEWED) return;
    this.#presenter.preview(opened, suited(request, opened));
    this.preview.value = { title: request.title, opened };
  }

  /**
   * Without a state the scene stays as it is. The view comes first: it is the last that can fail, and then the mesh before is
   * still whole.
   */
  #adopt(engine: Engine, state: SceneState | null, shown: Shown, request: OpenRequest): void {
    const before = this.shown.value;
    try {
      this.#presenter.replace(shown, state ?? this.scene.state, request.view);
    } catch (error) {
      // As if it were another mesh, so that what is shown beside the field comes back too.
      if (before) this.shown.value = { ...before, opened: { ...before.opened } };
      throw error;
    }
    // What was placed is in the scene from now on.
    const { transfer: _transfer, ...kept } = request;
    this.#use(engine, kept);
    this.refiner.reset();
    this.failure.value = null;
    this.#count(shown.answer);
    this.animator.clips = shown.opened.clips;
    this.shown.value = shown;
    if (state) {
      this.scene.load(state);
      this.animator.restart();
    }
    this.#showMeasured(shown.answer);
    this.#rest();
  }

  /**
   * Opens the mesh on screen anew with another axis upward, in a worker of its own; until then it is shown as it was. What
   * undo goes back over stays, and so does what is changed meanwhile.
   */
  #turn(meanwhile: Method | null): Promise<void> {
    const { state } = this.scene;
    return this.#prepare({ kind: 'turned', meanwhile }, async (request) => {
      await this.#open({ ...request, state, choosePlaces: false, view: null }, true);
      if (this.shown.value && !this.#isAnswered(this.shown.value.answer)) void this.#solve();
    });
  }

  /** Factors the mesh on screen in a worker of its own; until that is done, the one in use answers by the method before. */
  #factor(before: Method): Promise<void> {
    return this.#prepare({ kind: 'factored', meanwhile: before }, async (request) => {
      this.#use(await this.#startAgain(request, this.scene.state), request);
      await this.#solve();
    });
  }

  /** Makes another worker ready, in the place of one that was being made ready; takes back what could not be done. */
  async #prepare(mine: Preparing, work: (request: OpenRequest) => Promise<void>): Promise<void> {
    if (this.#phase.kind === 'empty') return;
    this.#phase.preparing = mine;
    try {
      await work(this.#phase.request);
    } catch (error) {
      if (!this.#endPreparing(mine)) return;
      if (!(error instanceof Cancelled)) this.failure.value = toError(error);
      const { opened } = this.shown.value ?? {};
      const { up } = opened?.drawTransform ?? {};
      if (opened && up && upOf(this.scene.state, opened.upright) !== up) this.scene.withdraw({ up });
      if (mine.meanwhile) this.scene.withdraw({ method: mine.meanwhile });
    }
  }

  /** Whether it was not over yet. */
  #endPreparing(mine: Preparing): boolean {
    if (this.#phase.kind === 'empty' || this.#phase.preparing !== mine) return false;
    this.#phase.preparing = null;
    return true;
  }

  get #preparing(): Preparing | null {
    return this.#phase.kind === 'empty' ? null : this.#phase.preparing;
  }

  /** Has a mesh on screen answered by a worker, in the place of the one before. */
  #use(engine: Engine, request: OpenRequest): void {
    this.engine?.dispose();
    this.#phase = { kind: 'answering', request, preparing: null, engine, asked: null, posing: false };
    // It shows the mesh as its file has it.
    this.pose.value = null;
    void engine.lost.then((lost) => {
      if (engine !== this.engine) return;
      this.#phase = { kind: 'lost', request, preparing: this.#preparing, lost };
      return this.#revive(request, lost);
    });
    // The next opening finds its worker compiled, and the first picture does not wait for it.
    setTimeout(() => this.#client.warmUp(), WARM_UP_MS);
  }

  /** Gives the scene a fresh worker, once: what has ended two workers would end a third. */
  async #revive(request: OpenRequest, lost: WorkerLost): Promise<void> {
    this.refiner.giveUp();
    const { state } = this.scene;
    const asked = asText(state);
    if (this.loading.value || asked === this.#fatal) {
      this.failure.value = lost;
      return;
    }
    this.#fatal = asked;
    const before = this.shown.value;
    try {
      this.#use(await this.#startAgain(request, state), request);
    } catch (error) {
      this.failure.value = error instanceof Cancelled ? lost : toError(error);
      return;
    }
    if (await this.#solve()) {
      const isForMemory = this.refiner.hasLostWorker && isOutOfMemory(lost);
      const what = isForMemory && before ? outOfMemory(before, state) : lost.words;
      this.failure.value = new Failure(t`${what} The solver was restarted; the scene is unchanged.`, { cause: lost });
    }
  }

  /** Another worker for the mesh on screen, which is to be asked next. */
  #startAgain(request: OpenRequest, state: SceneState): Promise<Engine> {
    return whileLoading(this.loading, request.title, async (progress, signal) => {
      const engine = await this.#start(request, state, progress, signal);
      signal.throwIfAborted();
      this.refiner.interrupt();
      return engine;
    });
  }

  /** Another method: heat needs factors, and others do not wait for them. */
  #choose(before: Method): void {
    const preparing = this.#preparing;
    if (this.scene.state.method === 'heat' && this.engine?.isFactored === false) {
      if (preparing?.kind === 'turned') void this.#turn(before);
      else void this.#factor(before);
    } else if (preparing?.kind === 'factored') {
      this.#endPreparing(preparing);
      this.cancelOpening();
    } else if (preparing) preparing.meanwhile = null;
  }

  #follow(state: SceneState, previous: SceneState): void {
    const { value: shown } = this.shown;
    if (!shown) return;
    if (state.up !== previous.up) {
      if (upOf(state, shown.opened.upright) !== shown.opened.drawTransform.up) {
        void this.#turn(this.#preparing?.meanwhile ?? null);
        return;
      }
      if (this.#preparing?.kind === 'turned') this.cancelOpening();
    }
    if (state.method !== previous.method) this.#choose(previous.method);
    if (this.#phase.kind === 'lost' || !this.#isAnswered(shown.answer)) void this.#solve();
    else if (state.refine !== previous.refine) this.#rest();
  }

  /** Whether the scene's question was answered and shown. */
  async #solve(): Promise<boolean> {
    const phase = this.#phase;
    const { value: before } = this.shown;
    if (phase.kind === 'lost' && !this.loading.value) void this.#revive(phase.request, phase.lost);
    if (phase.kind !== 'answering' || !before) return false;
    const { engine } = phase;
    const question = this.#question;
    const wait = this.dragging && before.answer.pathMs > LIVE_PATH_MS;
    const isOver = () => {
      if (phase.asked === question) phase.asked = null;
    };
    this.refiner.interrupt();
    phase.asked = question;
    try {
      const answer = await engine.ask({ ...question, from: wait ? null : question.from });
      isOver();
      if (!answer || phase !== this.#phase) return false;
      const moved = answer.question.from !== before.answer.question.from && !this.dragging;
      const pathMs = wait ? before.answer.pathMs : answer.pathMs;
      this.#show({ ...this.#meshOf(engine, before), answer: { ...answer, pathMs } }, moved);
      this.#showMeasured(answer);
      this.failure.value = null;
      if (!this.dragging) this.#rest();
      return true;
    } catch (error) {
      isOver();
      if (error instanceof Cancelled || error instanceof WorkerLost) return false;
      this.refiner.giveUp();
      this.fail(error);
      return false;
    }
  }

  /** A fresh worker has opened the mesh anew. */
  #meshOf({ opened }: Engine, before: Shown): Omit<Shown, 'answer'> {
    return opened === before.opened ? before : { opened, places: new Places(opened) };
  }

  /** Begins the refinement of what is shown, unless a newer question is already asked. */
  #rest(): void {
    const { value: shown } = this.shown;
    const { state } = this.scene;
    if (!this.engine || !shown || !this.#isAnswered(shown.answer) || this.#isLive) return;
    this.refiner.rest(this.engine, shown.answer, { ...state, method: shown.answer.question.method });
  }

  /** What the scene asks now. */
  get #question(): Question {
    const { state } = this.scene;
    const moment = state.animation.live ? this.animator.moment.value : null;
    const quick = this.#drag?.quick === true || this.#isLive;
    const method = this.#drag?.paints && state.method === 'heat' ? 'auto' : state.method;
    return { ...questionOf(state, this.#preparing?.meanwhile ?? method), moment, quick };
  }

  /** Whether distance is measured in one pose after the other. */
  get #isLive(): boolean {
    return this.scene.state.animation.live && this.animator.plays && !this.paused.value;
  }

  /** Whether an answer is to what the scene asks, and no other is on its way: undo may come back to it before that. */
  #isAnswered({ field, question }: Answer): boolean {
    const asked = this.#question;
    return (
      (this.#phase.kind !== 'answering' || this.#phase.asked === null) &&
      isFieldOf(field, question, asked) &&
      question.method === asked.method &&
      question.from === asked.from &&
      question.pathKind === asked.pathKind &&
      question.inside === asked.inside
    );
  }

  #refined(answer: Answer): void {
    const { value: shown } = this.shown;
    if (shown) this.#show({ ...shown, answer }, false);
  }

  #show(shown: Shown, fromStart: boolean): void {
    this.#presenter.answer(shown, fromStart, shown.answer.question.from !== null || !this.dragging);
    this.#count(shown.answer);
    this.shown.value = shown;
  }

  #count({ field }: Answer): void {
    if (field?.refineMs === 0 && field !== this.shown.value?.answer.field) this.solves += 1;
  }
}

/** What the solver is asked about, as text. */
function asText({
  camera: _camera,
  orthographic: _orthographic,
  style: _style,
  hidden: _hidden,
  selected: _selected,
  ...asked
}: SceneState): string {
  return JSON.stringify(asked);
}

/** Where refinement has ended a worker. */
function outOfMemory({ opened, answer: { field } }: Shown, state: SceneState): Words {
  const exactBelow = measure(field?.exactBelow ?? ofModel(0), unitOf(state, opened));
  return t`Refinement needed more memory than the browser gives; distances were exact below ${exactBelow}.`;
}
