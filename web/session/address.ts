/** Keeps the address in step with the scene, so that it can be shared and reloaded, and follows a link that is pasted. */
import { encodeLink } from '../state/link';
import type { Scene } from '../state/history';
import { Signal } from '../state/signal';
import { FIRST_WORKSPACE, isWorkspace, type Workspace } from '../state/workspace';
import { type Opener, startOf } from './opener';

/** The address is written after a pause; browsers limit how often it may change. */
const REST_MS = 300;

export class Address {
  readonly #scene: Scene;
  readonly #opener: Opener;
  readonly kiosk: boolean;
  /** The one that is open. */
  readonly workspace: Signal<Workspace>;
  #timer = 0;
  /** The fragment as it was read or written last. Another one is a link whose event is still to come. */
  #known = location.hash;

  constructor(scene: Scene, opener: Opener) {
    this.#scene = scene;
    this.#opener = opener;
    this.kiosk = new URLSearchParams(location.hash.slice(1)).get('kiosk') === '1';
    this.workspace = new Signal(workspaceOf(location.hash));
    const rest = () => {
      clearTimeout(this.#timer);
      this.#timer = window.setTimeout(() => this.#write(), REST_MS);
    };
    scene.subscribe((state, previous) => {
      if (state !== previous) rest();
    });
    this.workspace.watch((open, previous) => {
      if (previous !== undefined && open !== previous) rest();
    });
    // A link that cannot be opened gives way to the scene that stays.
    addEventListener('hashchange', () => {
      this.#known = location.hash;
      this.workspace.value = workspaceOf(location.hash);
      void opener.link(location.hash).then(() => this.#write());
    });
  }

  /** The whole address of the present scene. */
  link(): string {
    const { state } = this.#scene;
    const start = startOf(state.mesh) ?? state;
    const open = this.workspace.value === FIRST_WORKSPACE ? '' : `&open=${this.workspace.value}`;
    return new URL(`#${encodeLink(state, start)}${open}`, location.href).href;
  }

  #write(): void {
    // A link that still waits for its mesh must survive a reload.
    if (this.#opener.waiting || location.hash !== this.#known) return;
    history.replaceState(null, '', this.link() + (this.kiosk ? '&kiosk=1' : ''));
    this.#known = location.hash;
  }
}

/** Where the author of a link was; the settings of a comparison are where it is. */
function workspaceOf(fragment: string): Workspace {
  const keys = new URLSearchParams(fragment.slice(1));
  const open = keys.get('open');
  return isWorkspace(open) ? open : keys.has('vs') ? 'solve' : FIRST_WORKSPACE;
}
