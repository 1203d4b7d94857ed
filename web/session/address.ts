/** The address of the scene on screen, and what it says of how the page looks. */
import { encodeLink } from '../state/link';
import type { Scene } from '../state/history';
import { Signal } from '../state/signal';
import { startOf } from '../state/start';
import { FIRST_WORKSPACE, isWorkspace, type Workspace } from '../state/workspace';

export class Address {
  readonly #scene: Scene;
  readonly kiosk: boolean;
  /** The one that is open. */
  readonly workspace: Signal<Workspace>;

  constructor(scene: Scene) {
    this.#scene = scene;
    this.kiosk = new URLSearchParams(location.hash.slice(1)).get('kiosk') === '1';
    this.workspace = new Signal(workspaceOf(location.hash));
  }

  /** The whole address of the present scene. */
  link(): string {
    const { state } = this.#scene;
    const start = startOf(state.mesh) ?? state;
    const open = this.workspace.value === FIRST_WORKSPACE ? '' : `&open=${this.workspace.value}`;
    return new URL(`#${encodeLink(state, start)}${open}`, location.href).href;
  }

  /** The same, as the address bar has it. */
  whole(): string {
    return this.link() + (this.kiosk ? '&kiosk=1' : '');
  }

  /** Opens the workspace that the address names. */
  followWorkspace(): void {
    this.workspace.value = workspaceOf(location.hash);
  }
}

/** Where the author of a link was; the settings of a comparison are where it is. */
function workspaceOf(fragment: string): Workspace {
  const keys = new URLSearchParams(fragment.slice(1));
  const open = keys.get('open');
  const compares = keys.has('vs') && (keys.has('m') || keys.has('model'));
  return isWorkspace(open) ? open : compares ? 'solve' : FIRST_WORKSPACE;
}
