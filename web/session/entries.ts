/**
 * Keeps the address in step with the scene, so that it can be shared and reloaded, and follows a link that is pasted. Each opening of a
 * mesh, and each comparison, is an entry of the browser's history: back and forward restore them. Fetched after the first picture.
 */
import { titleOf } from '../state/presets';
import type { SceneState } from '../state/scene';
import type { Scene } from '../state/history';
import type { Address } from './address';
import type { Opener } from './opener';

/** The address is written after a pause; browsers limit how often it may change. */
const REST_MS = 300;

/** What the browser keeps of an entry. */
interface EntryState {
  heatwalk: number;
}

export class Entries {
  readonly #scene: Scene;
  readonly #opener: Opener;
  readonly #address: Address;
  /** A frame has its history in common with the page that holds it, which has one of its own. */
  readonly #isFrame = window.parent !== window;
  readonly #states = new Map<number, SceneState>();
  #timer = 0;
  /** The entry that is shown. */
  #at = numberOf(history.state) ?? 0;
  /** The openings that the entries are of. */
  #loads: number;
  /** The fragment as it was read or written last. Another one is a link whose event is still to come. */
  #known: string;
  /** Links and entries that are on their way: until they are there, the address is theirs. */
  #following = 0;

  /** `known`: the fragment that was followed first. */
  constructor(scene: Scene, opener: Opener, address: Address, known: string) {
    this.#scene = scene;
    this.#opener = opener;
    this.#address = address;
    this.#known = known;
    this.#loads = scene.loads;
    scene.subscribe((state, previous) => {
      if (state !== previous) this.#changed(state, previous);
    });
    address.workspace.watch((open, previous) => {
      if (open !== previous) this.#rest();
    });
    addEventListener('popstate', ({ state }) => {
      const entry = numberOf(state);
      if (entry === null) return;
      this.#keepState();
      this.#follow(entry);
    });
    // A link that cannot be opened gives way to the scene that stays.
    addEventListener('hashchange', () => {
      if (location.hash === this.#known) return;
      this.#keepState();
      this.#follow(null);
    });
    // Who was faster than this module has gone to an entry, or followed a link, already; of which entry the scene is, nobody knows.
    if (location.hash !== this.#known) this.#follow(numberOf(history.state));
    this.#rest();
  }

  #changed(state: SceneState, previous: SceneState): void {
    const isOpened = this.#scene.loads !== this.#loads && !isAwaited(state, this.#opener.awaited);
    const isCompared = (state.compared === null) !== (previous.compared === null);
    this.#loads = this.#scene.loads;
    if (!(isOpened || isCompared) || this.#isFrame || this.#following > 0) {
      this.#rest();
      return;
    }
    clearTimeout(this.#timer);
    if (!this.#opener.awaited) this.#states.set(this.#at, previous);
    this.#at += 1;
    history.pushState({ heatwalk: this.#at } satisfies EntryState, '', this.#address.whole());
    this.#known = location.hash;
  }

  #rest(): void {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.#write(), REST_MS);
  }

  /** What was changed since the entry was made is there on the way back to it. */
  #keepState(): void {
    if (this.#following === 0 && !this.#opener.awaited) this.#states.set(this.#at, this.#scene.state);
  }

  /** Goes to what the address names, as an entry or as a new one. */
  #follow(entry: number | null): void {
    clearTimeout(this.#timer);
    this.#at = entry ?? this.#at + 1;
    this.#known = location.hash;
    this.#address.followWorkspace();
    const state = entry === null ? undefined : this.#states.get(entry);
    this.#following += 1;
    void (state ? this.#opener.restore(state) : this.#opener.link(location.hash)).finally(() => {
      this.#following -= 1;
      if (this.#following > 0) return;
      this.#write();
    });
  }

  #write(): void {
    // A link that still waits for its mesh must survive a reload.
    if (this.#opener.awaited || this.#following > 0 || location.hash !== this.#known) return;
    history.replaceState({ heatwalk: this.#at } satisfies EntryState, '', this.#address.whole());
    this.#known = location.hash;
  }
}

function numberOf(state: unknown): number | null {
  const { heatwalk } = (state ?? {}) as Partial<EntryState>;
  return typeof heatwalk === 'number' ? heatwalk : null;
}

/** Whether it is what a link waited for, which has its entry. */
function isAwaited({ mesh }: SceneState, awaited: SceneState | null): boolean {
  return awaited !== null && titleOf(mesh) === titleOf(awaited.mesh);
}
