/** Refinement: when the user pauses, the answer that is shown is made exact step by step. */
import type { SceneState } from '../state/scene';
import { Signal } from '../state/signal';
import type { Answer, Engine } from './engine';

/**
 * What is being done about exactness. `solving`: a question is under way; `resting`: answered, and nobody asks;
 * `refining`. The others are ends. `exact`: everything is; `off`: not wanted; `idle`: no field; `large`, `late` and
 * `stuck`: given up, for the size of the mesh, the time, or because a few steps made no progress; `failed`: the query
 * or a step failed.
 */
export type Phase =
  'solving' | 'resting' | 'refining' | 'exact' | 'off' | 'idle' | 'large' | 'late' | 'stuck' | 'failed';

/** Pause before refinement begins. */
const REST_MS = 300;
/** Exact distances and exact paths need memory and time that grow faster than the mesh. */
export const MOST_TRIANGLES = 200_000;
export const MOST_SECONDS = 60;
/** Steps without progress after which refinement stops. */
const PATIENCE = 3;

export class Refiner {
  readonly phase = new Signal<Phase>('solving');
  readonly #show: (answer: Answer) => void;
  readonly #fail: (error: unknown) => void;
  /** What is under way; another object, and it ends. */
  #turn = {};
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(show: (answer: Answer) => void, fail: (error: unknown) => void) {
    this.#show = show;
    this.#fail = fail;
  }

  /** Nothing is under way, and nothing will be until the next answer. */
  get settled(): boolean {
    return !['solving', 'resting', 'refining'].includes(this.phase.value);
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
  rest(engine: Engine, answer: Answer, { refine, pathKind }: SceneState): void {
    this.interrupt();
    const turn = this.#turn;
    const large = engine.opened.report.faces > MOST_TRIANGLES;
    const traces = pathKind === 'exact' && answer.path !== null && answer.pathKind !== 'exact' && !large;
    const end = endOf(answer, refine, large);
    if (end && !traces) {
      this.phase.value = end;
      return;
    }
    this.phase.value = 'resting';
    this.#timer = setTimeout(() => void this.#begin(engine, answer, turn, traces, end), REST_MS);
  }

  async #begin(engine: Engine, answer: Answer, turn: object, traces: boolean, end: Phase | null): Promise<void> {
    this.phase.value = 'refining';
    try {
      const traced = traces ? await this.#trace(engine, answer, turn) : answer;
      const reached = end ?? (traced && (await this.#refine(engine, traced, turn)));
      if (turn === this.#turn && reached) this.phase.value = reached;
    } catch (error) {
      if (turn !== this.#turn) return;
      this.giveUp();
      this.#fail(error);
    }
  }

  async #trace(engine: Engine, answer: Answer, turn: object): Promise<Answer | null> {
    const traced = await engine.traceExactly(answer);
    if (turn !== this.#turn || !traced) return null;
    // Where there is no exact path, the straightened one stays.
    if (!traced.path) return answer;
    this.#show(traced);
    return traced;
  }

  /** The end that was reached; null when a question came in between. */
  async #refine(engine: Engine, answer: Answer, turn: object): Promise<Phase | null> {
    const began = performance.now();
    let shown = answer;
    let reached = Number.NEGATIVE_INFINITY;
    let idle = 0;
    while (!isExact(shown)) {
      if (performance.now() - began > 1000 * MOST_SECONDS) return 'late';
      const next = await engine.refine(shown);
      if (turn !== this.#turn || !next?.field) return null;
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
}

/** Where an answer is to stay as it is. */
function endOf(answer: Answer, refine: boolean, large: boolean): Phase | null {
  if (!answer.field) return 'idle';
  if (isExact(answer)) return 'exact';
  if (!refine) return 'off';
  return large ? 'large' : null;
}

function isExact({ field }: Answer): boolean {
  return field?.exactBelow === Infinity;
}
