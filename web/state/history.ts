/** The scene over time: its changes, undo and redo. */
import type { SceneState } from './scene';
import { tellEach } from './signal';
import { type Undoable, undoableOf } from './link';

export type SceneListener = (state: SceneState, previous: SceneState) => void;

export class Scene {
  #state: SceneState;
  #past: Undoable[] = [];
  #future: Undoable[] = [];
  #gesture: object | null = null;
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

  /** Changes what undo goes back over. All changes that carry the same `gesture` are one step of undo, as a drag is. */
  edit(change: Partial<Undoable> & { selected?: number }, gesture: object | null = null): void {
    if (gesture === null || gesture !== this.#gesture) {
      this.#past.push(undoableOf(this.#state));
    }
    this.#gesture = gesture;
    this.#future = [];
    this.#replace(withValidSelection({ ...this.#state, ...change }));
  }

  /** Takes back a change that could not be done. It is no step, and one that leads to the same is none any more. */
  withdraw(change: Partial<Undoable>): void {
    const state = { ...this.#state, ...change };
    for (const steps of [this.#past, this.#future]) {
      const last = steps.at(-1);
      if (last && isThere(last, state)) steps.pop();
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
    this.#replace(state);
  }

  #travel(from: Undoable[], to: Undoable[]): boolean {
    const step = from.pop();
    if (!step) return false;
    to.push(undoableOf(this.#state));
    this.#gesture = null;
    this.#replace(withValidSelection({ ...this.#state, ...step }));
    return true;
  }

  #replace(state: SceneState): void {
    const previous = this.#state;
    this.#state = state;
    tellEach(this.#listeners, state, previous);
  }
}

/** Whether a step leads to where a state is. */
function isThere(step: Undoable, state: SceneState): boolean {
  return (Object.keys(step) as (keyof Undoable)[]).every((key) => step[key] === state[key]);
}

function withValidSelection(state: SceneState): SceneState {
  return state.selected < state.sources.length + state.sets.length ? state : { ...state, selected: -1 };
}
