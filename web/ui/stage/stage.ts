/** What lies over the model and the first picture does not wait for: loaded after it, or with what asks for it first. */
import type { Session } from '../../session/session';
import { Signal } from '../../state/signal';
import { remember, remembered } from '../memory';
import type { Legend } from './legend';

const MEMORY = 'heatwalk.legend';

export class Stage {
  /** Whether there is a legend. */
  readonly legend = new Signal(remembered(MEMORY) !== 'off');
  readonly #session: Session;
  #loading: Promise<void> | null = null;
  #shown: Legend | null = null;

  constructor(session: Session) {
    this.#session = session;
    this.legend.watch((on) => remember(MEMORY, on ? 'on' : 'off'));
  }

  /** Resolves when the legend is there. */
  load(): Promise<void> {
    return (this.#loading ??= import('./legend').then(
      ({ Legend }) => {
        this.#shown = new Legend(this.#session, this.legend);
        this.#session.view.stage.after(this.#shown.element);
        this.#shown.follow();
      },
      (error: unknown) => {
        // The next one who asks tries again.
        this.#loading = null;
        this.#session.fail(error);
      },
    ));
  }

  follow(): void {
    this.#shown?.follow();
  }

  /** Whether it is a key of the stage. */
  key(key: string): boolean {
    if (key.toLowerCase() !== 'l') return false;
    this.legend.value = !this.legend.value;
    return true;
  }
}
