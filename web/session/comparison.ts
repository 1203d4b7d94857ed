/** The scene by other settings, beside it: asks a worker of its own what the scene asks, and shows the answer right of the split. */
import { Failure, messageOf } from '../error';
import type { OpenedMesh, DrawPath } from '../protocol';
import { SolverClient } from '../solver/client';
import { type Answer, type Engine, isSameField, type Question } from '../solver/engine';
import { Refiner } from '../solver/refiner';
import { Cancelled } from '../solver/remote';
import { type Compared, settingsOf } from '../state/compared';
import { isRefined, type SceneState } from '../state/scene';
import { Signal } from '../state/signal';
import type { Edges } from '../view/layers';
import { available, instead } from './overlays';
import { wantedOf } from './prepare';
import type { Session } from './session';
import { t } from '../texts';

/** Of the other path; that of the scene is green. */
export const OTHER_PATH = { colour: '#1f7fff', width: 4 } as const;

export class Comparison {
  /** To the scene's question by the other settings; null while there is none. */
  readonly answer = new Signal<Answer | null>(null);
  /** Whether the other field is not yet that of what is asked. */
  readonly working = new Signal(false);
  readonly refiner: Refiner;
  readonly #session: Session;
  readonly #client = new SolverClient();
  /** The mesh on screen that the other worker holds too, or is opening. */
  #mesh: OpenedMesh | null = null;
  /** Null while it is opening it. */
  #engine: Engine | null = null;
  #isFactored = false;
  #asked: Question | null = null;
  /** Counts what was shown: a field that was overtaken while it was fetched is dropped. */
  #wish = 0;

  constructor(session: Session) {
    this.#session = session;
    this.refiner = new Refiner(
      (answer) => void this.#show(answer),
      (error) => session.fail(error),
      session.isHidden,
    );
    session.scene.subscribe((state, previous) => this.#change(state, previous));
    session.shown.watch(() => this.#follow());
  }

  #change(state: SceneState, previous: SceneState): void {
    if (state.colorBy !== previous.colorBy && this.answer.value) void this.#show(this.answer.value);
    if (state.compared !== previous.compared) this.#follow();
  }

  #follow(): void {
    const { scene, shown, view } = this.#session;
    const { compared } = scene.state;
    const opened = shown.value?.opened ?? null;
    if (!compared || !opened) {
      this.#end();
      return;
    }
    view.split = compared.split;
    if (opened !== this.#mesh || (compared.method === 'heat' && !this.#isFactored)) void this.#open(opened, compared);
    else if (this.#engine) void this.#ask(this.#engine);
  }

  /** There is one field again. */
  #end(): void {
    if (!this.#mesh) return;
    this.#leave();
    this.#mesh = null;
    this.#session.view.setOther(null, null);
    this.#session.view.setEdges('path', []);
  }

  #leave(): void {
    this.#client.cancel();
    this.#engine?.dispose();
    this.refiner.interrupt();
    this.#wish += 1;
    [this.#engine, this.#asked, this.answer.value, this.working.value] = [null, null, null, false];
  }

  async #open(opened: OpenedMesh, compared: Compared): Promise<void> {
    const { request, scene } = this.#session;
    if (!request) return;
    this.#leave();
    this.#mesh = opened;
    this.#isFactored = compared.method === 'heat';
    this.working.value = true;
    try {
      const wanted = wantedOf({ ...scene.state, ...settingsOf(compared) });
      const engine = await this.#client.open(request.load, wanted, () => undefined);
      this.#engine = engine;
      void engine.lost.then((lost) => {
        if (engine === this.#engine) this.#giveUp(lost);
      });
      await this.#ask(engine);
    } catch (error) {
      if (!(error instanceof Cancelled)) this.#giveUp(error);
    }
  }

  /** The scene stays; what it cannot be compared with goes. */
  #giveUp(error: unknown): void {
    this.#session.fail(new Failure(t`The other settings cannot be shown: ${messageOf(error)}`, { cause: error }));
    this.#session.scene.withdraw({ compared: null });
  }

  async #ask(engine: Engine): Promise<void> {
    const { scene, shown } = this.#session;
    const { compared, pathKind } = scene.state;
    const theirs = shown.value?.answer.question;
    if (!compared || !theirs) return;
    const { method, windows, parameters, refine } = compared;
    const question = { ...theirs, method, windows, parameters, refines: isRefined(compared) };
    if (this.#asked && isSame(this.#asked, question)) return;
    this.#asked = question;
    this.refiner.interrupt();
    this.working.value = true;
    try {
      const answer = await engine.ask(question);
      if (!answer || engine !== this.#engine || this.#asked !== question) return;
      this.working.value = false;
      await this.#show(answer);
      if (!question.quick && this.#asked === question) this.refiner.rest(engine, answer, { method, refine, pathKind });
    } catch (error) {
      if (engine === this.#engine && !(error instanceof Cancelled)) this.#giveUp(error);
    }
  }

  async #show(answer: Answer): Promise<void> {
    const { scene, view } = this.#session;
    const wish = ++this.#wish;
    this.answer.value = answer;
    view.setEdges('path', edgesOf(answer.path));
    const { colorBy } = available(scene.state, answer.question.method);
    const { field, inside } = answer;
    if (colorBy === 'distance' || !field || !this.#engine) {
      view.setOther(field, inside);
      return;
    }
    try {
      const painted = await instead(this.#engine, colorBy, field);
      if (wish === this.#wish) view.setOther(painted?.field ?? null, inside);
    } catch (error) {
      if (wish === this.#wish) this.#session.fail(error);
    }
  }
}

/** Whether what was asked is asked again. */
function isSame(asked: Question, question: Question): boolean {
  return (
    isSameField(asked, question) &&
    asked.refines === question.refines &&
    asked.method === question.method &&
    asked.from === question.from &&
    asked.inside === question.inside &&
    asked.pathKind === question.pathKind
  );
}

/** A path as segments. */
function edgesOf(path: DrawPath | null): Edges[] {
  const points = path?.points ?? new Float32Array();
  const ends: number[] = [];
  for (let end = 3; end < points.length; end += 3) ends.push(...points.subarray(end - 3, end + 3));
  return ends.length > 0 ? [{ ...OTHER_PATH, ends: Float32Array.from(ends) }] : [];
}
