/** The scene over time: its changes, undo and redo. */
import type { SceneState } from './scene';
import { tellEach } from './signal';
import { type Undoable, undoableOf } from './link';

export type SceneListener = (state: SceneState, previous: SceneState) => void;

/** What the steps of undo may hold beside the present scene: a hundred strokes on a mesh of half a million triangles. */
const MOST_BYTES = 2 ** 26;
const MOST_STEPS = 1000;
/** About what an object or an array takes beside what is in it. */
const OBJECT_BYTES = 64;
const VALUE_BYTES = 8;

/** A state to go back to. */
interface Step {
  state: Undoable;
  /** What it alone holds: the states after it share the rest. */
  bytes: number;
}

export class Scene {
  #state: SceneState;
  #past: Step[] = [];
  #future: Step[] = [];
  #gesture: object | null = null;
  /** Whether the last step was taken back, or done again. */
  travelled: 'back' | 'forth' | null = null;
  /** How often another mesh, or the same in another way, has come. */
  loads = 0;
  readonly #listeners = new Set<SceneListener>();

  constructor(state: SceneState) {
    this.#state = state;
  }

  get state(): SceneState {
    return this.#state;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Returns the function that ends the subscription. */
  subscribe(listener: SceneListener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** A change that undo does not concern. */
  set(change: Partial<Omit<SceneState, keyof Undoable>>): void {
    this.#replace({ ...this.#state, ...change });
  }

  /** Changes what undo goes back over. Changes with the same `gesture` are one step of undo, as a drag is. */
  edit(change: Partial<Undoable> & { selected?: number }, gesture: object | null = null): void {
    const next = withValidSelection({ ...this.#state, ...change });
    if (gesture === null || gesture !== this.#gesture) this.#past = bounded([...this.#past, stepTo(this.#state, next)]);
    this.#gesture = gesture;
    this.travelled = null;
    this.#future = [];
    this.#replace(next);
  }

  /** Takes back a change that could not be done. It is no step, and one that leads to the same is none any more. */
  withdraw(change: Partial<Undoable>): void {
    const state = { ...this.#state, ...change };
    for (const steps of [this.#past, this.#future]) {
      const last = steps.at(-1);
      if (last && isThere(last.state, state)) steps.pop();
    }
    this.#gesture = null;
    this.#replace(state);
  }

  undo(): boolean {
    return this.#travel(this.#past, this.#future);
  }

  redo(): boolean {
    return this.#travel(this.#future, this.#past);
  }

  /** Another mesh, or other parts of it: places on the old one mean nothing here, so the history ends. */
  load(state: SceneState): void {
    this.#past = [];
    this.#future = [];
    this.#gesture = null;
    this.travelled = null;
    this.loads += 1;
    this.#replace(state);
  }

  #travel(from: Step[], to: Step[]): boolean {
    const step = from.pop();
    if (!step) return false;
    to.push(stepTo(this.#state, step.state));
    this.#gesture = null;
    this.travelled = from === this.#past ? 'back' : 'forth';
    this.#replace(withValidSelection({ ...this.#state, ...step.state }));
    return true;
  }

  #replace(state: SceneState): void {
    const previous = this.#state;
    this.#state = state;
    tellEach(this.#listeners, state, previous);
  }
}

function stepTo(state: SceneState, next: Undoable): Step {
  const undoable = undoableOf(state);
  return { state: undoable, bytes: bytesBeside(undoable, next) };
}

/** Without the oldest steps, where all together hold too much; the last one stays. */
function bounded(steps: readonly Step[]): Step[] {
  let bytes = 0;
  const oldest = steps.findLastIndex((step) => (bytes += step.bytes) > MOST_BYTES);
  return steps.slice(Math.max(0, Math.min(oldest + 1, steps.length - 1), steps.length - MOST_STEPS));
}

/** About how many bytes a value holds that another one does not share with it. */
function bytesBeside(value: unknown, other: unknown): number {
  if (Object.is(value, other)) return 0;
  if (ArrayBuffer.isView(value)) return OBJECT_BYTES + value.byteLength;
  if (typeof value === 'string') return 2 * value.length;
  if (typeof value !== 'object' || value === null) return VALUE_BYTES;
  const beside = new Map<string, unknown>(typeof other === 'object' && other !== null ? Object.entries(other) : []);
  const parts = Object.entries(value).map(([key, part]) => VALUE_BYTES + bytesBeside(part, beside.get(key)));
  return parts.reduce((sum, bytes) => sum + bytes, OBJECT_BYTES);
}

/** Whether a step leads to where a state is. */
function isThere(step: Undoable, state: SceneState): boolean {
  return (Object.keys(step) as (keyof Undoable)[]).every((key) => step[key] === state[key]);
}

function withValidSelection(state: SceneState): SceneState {
  return state.selected < state.sources.length + state.sets.length ? state : { ...state, selected: -1 };
}
