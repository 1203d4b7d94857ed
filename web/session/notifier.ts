/** What the page tells the user, and what it offers to do. */
import type { SceneState } from '../state/scene';
import type { Shown } from './prepare';
import type { Words } from '../texts';

export interface Action {
  name: Words;
  run: () => void;
}

export interface Notifier {
  /** A mesh is shown. */
  opened(title: Words, shown: Shown, state: SceneState): void;
  /** With an `action`, which closes it. */
  notice(text: Words, action?: Action): void;
  /** The same of the mesh on screen: it goes with that, and when there is another one. */
  remark(text: Words, action?: Action): void;
  /** What of a link cannot be used, all together: takes the place of what was told so before. */
  refused(values: readonly string[]): void;
  /** Tells which of the meshes that came together is shown, and offers the others. */
  choice(shown: string, meshes: readonly string[], open: (mesh: string) => void): void;
  fail(text: Words, details: string, remedy?: Action): void;
  /** Stays until the file is there. */
  askForFile(name: string): void;
  /** Stays until it is opened: nothing is fetched unasked. */
  offer(address: string, open: () => void): void;
  /** What was asked for or offered is no longer wanted. */
  forget(): void;
}
