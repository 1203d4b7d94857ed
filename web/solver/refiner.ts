/** Refinement: when the user pauses, the answer that is shown is made exact step by step. */
import type { DistanceField } from '../protocol';
import { isRefined, type SceneState } from '../state/scene';
import { isWeighted } from '../state/ground';
import { Signal, until } from '../state/signal';
import type { Answer, Engine } from './engine';
import { WorkerLost } from './remote';
import { isOutOfMemory } from './trap';

/**
 * What is being done about exactness. `solving`: a question is under way; `resting`: answered, and nobody asks;
 * `refining`; `hidden`: stopped until the page is seen again. The others are ends. `exact`: everything is; `off`: not wanted; `costs`: not possible where costs differ; `inside`: nor in tetrahedra; `idle`: no field; `memory`, `late` and
 * `stuck`: given up, for want of memory or time, or because a few steps made no progress; `failed`: the query or a step
 * failed.
 */
export type Phase =
  | 'solving'
  | 'resting'
  | 'refining'
  | 'hidden'
  | 'exact'
  | 'off'
  | 'costs'
  | 'inside'
  | 'idle'
  | 'memory'
  | 'late'
  | 'stuck'
  | 'failed';

/**
 * Pause before refinement begins, of a field by windows and of one by heat: each step of the second ends with a solve, by
 * which the next answer would be late. A key that repeats comes back within the first.
 */
const REST_MS = { windows: 50, heat: 300 };
/** Time and memory of exact distances grow faster than the mesh. */
export const MOST_SECONDS = 60;
/** Steps without progress after which refinement stops. */
const PATIENCE = 3;

export class Refiner {
  readonly phase = new Signal<Phase>('solving');
  readonly #show: (answer: Answer) => void;
  readonly #fail: (error: unknown) => void;
  /** Whether the page is hidden, so that nobody sees what is refined. */
  readonly #isHidden: Signal<boolean>;
  /** What is under way; another object, and it ends. */
  #turn = {};
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The field that the last step has given, or the one before any. */
  #reached: DistanceField | null = null;
  /** One that memory did not suffice to refine further. */
  #full: DistanceField | null = null;
  /** Whether a worker was lost for want of memory: what is exact is not asked for any more. */
  #hasLostWorker = false;

  constructor(show: (answer: Answer) => void, fail: (error: unknown) => void, isHidden: Signal<boolean>) {
    this.#show = show;
    this.#fail = fail;
    this.#isHidden = isHidden;
  }

  /** Nothing is under way, and nothing will be until the next answer, or until the page is seen. */
  get settled(): boolean {
    return !['solving', 'resting', 'refining'].includes(this.phase.value);
  }

  /** Whether refining the mesh on screen has cost a worker. */
  get hasLostWorker(): boolean {
    return this.#hasLostWorker;
  }

  /** Another mesh is on screen. */
  reset(): void {
    this.#full = null;
    this.#hasLostWorker = false;
  }

  /** A query is sent, or something is dragged. */
  interrupt(): void {
    this.#turn = {};
    clearTimeout(this.#timer);
    this.phase.value = 'solving';
  }

  /** The question failed. */
  giveUp(): void {
    this.interrupt();
    this.phase.value = 'failed';
  }

  /** The answer is shown; its refinement begins unless somebody asks before. */
  rest(engine: Engine, answer: Answer, state: Pick<SceneState, 'method' | 'refine' | 'pathKind'>): void {
    this.interrupt();
    const turn = this.#turn;
    const isWanted = state.pathKind === 'exact' && answer.path !== null && answer.pathKind !== 'exact';
    const traces = isWanted && !this.#hasLostWorker && !isWeighted(answer.question.ground) && !answer.field?.inner;
    const end = this.#endOf(answer, isRefined(state));
    if (end && !traces) {
      this.phase.value = end;
      return;
    }
    this.phase.value = 'resting';
    const pause = answer.field?.windows === undefined ? REST_MS.heat : REST_MS.windows;
    this.#timer = setTimeout(() => void this.#begin(engine, answer, turn, traces, end), pause);
  }

  async #begin(engine: Engine, answer: Answer, turn: object, traces: boolean, end: Phase | null): Promise<void> {
    this.phase.value = 'refining';
    this.#reached = answer.field;
    try {
      const traced = traces ? await this.#trace(engine, answer, turn) : answer;
      const reached = end ?? (traced && (await this.#refine(engine, traced, turn)));
      if (turn === this.#turn && reached) this.phase.value = reached;
    } catch (error) {
      const isFull = error instanceof Error && isOutOfMemory(error);
      if (isFull && error instanceof WorkerLost) this.#hasLostWorker = true;
      if (turn !== this.#turn) return;
      if (isFull && !this.#hasLostWorker) {
        this.#full = this.#reached;
        this.phase.value = 'memory';
        return;
      }
      this.giveUp();
      this.#fail(error);
    }
  }

  async #trace(engine: Engine, answer: Answer, turn: object): Promise<Answer | null> {
    const isLate = deadline();
    let traced: Answer | null = answer;
    while (traced === answer && turn === this.#turn && !isLate(await this.#seen(turn))) {
      traced = await engine.traceExactly(answer);
    }
    if (turn !== this.#turn || !traced) return null;
    // Where there is no exact path, the straightened one stays.
    if (traced === answer || !traced.path) return answer;
    this.#show(traced);
    return traced;
  }

  /** The end that was reached; null when a question came in between. */
  async #refine(engine: Engine, answer: Answer, turn: object): Promise<Phase | null> {
    const isLate = deadline();
    let shown = answer;
    let reached = Number.NEGATIVE_INFINITY;
    let idle = 0;
    while (!isExact(shown)) {
      const isOver = isLate(await this.#seen(turn));
      if (turn !== this.#turn) return null;
      if (isOver) return 'late';
      const next = await engine.refine(shown);
      if (turn !== this.#turn || !next?.field) return null;
      this.#reached = next.field;
      idle = next.field.exactBelow > reached ? 0 : idle + 1;
      if (idle === PATIENCE) return 'stuck';
      reached = next.field.exactBelow;
      // The first steps may not yet reach as far as the exact region of the first answer.
      if (!shown.field || reached <= shown.field.exactBelow) continue;
      shown = next;
      this.#show(next);
    }
    return 'exact';
  }

  /** Waits until the page is seen, or something else is asked; the milliseconds that it took. */
  async #seen(turn: object): Promise<number> {
    if (!this.#isHidden.value || turn !== this.#turn) return 0;
    const began = performance.now();
    this.phase.value = 'hidden';
    await until(() => !this.#isHidden.value || turn !== this.#turn, this.#isHidden, this.phase);
    if (turn === this.#turn) this.phase.value = 'refining';
    return performance.now() - began;
  }

  /** Where an answer is to stay as it is. */
  #endOf(answer: Answer, refines: boolean): Phase | null {
    if (!answer.field) return 'idle';
    if (isExact(answer)) return 'exact';
    if (answer.field.inner) return 'inside';
    if (isWeighted(answer.question.ground)) return 'costs';
    if (!refines) return 'off';
    return this.#hasLostWorker || answer.field === this.#full ? 'memory' : null;
  }
}

/** Whether the most time that anything may take has passed since; idle time does not count. */
function deadline(): (idleMs: number) => boolean {
  let began = performance.now();
  return (idleMs) => {
    began += idleMs;
    return performance.now() - began > 1000 * MOST_SECONDS;
  };
}

function isExact({ field }: Answer): boolean {
  return field?.exactBelow === Infinity;
}
