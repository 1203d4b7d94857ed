/** What lies over the model and the first picture does not wait for: loaded after it, or with what asks for it first. */
import type { Session } from '../../session/session';
import { Signal } from '../../state/signal';
import { remember, remembered } from '../memory';
import type { GirthTool } from '../measure/girth';
import type { Legend } from './legend';
import type { ViewName } from './views';

const MEMORY = 'heatwalk.legend';

export class Stage {
  /** Whether there is a legend. */
  readonly legend = new Signal(remembered(MEMORY) !== 'off');
  readonly #session: Session;
  readonly #moved: () => void;
  #loading: Promise<void> | null = null;
  #shown: Legend | null = null;
  #girth: Promise<GirthTool> | null = null;
  #girthShown: GirthTool | null = null;

  /** `moved`: called where the camera moves. */
  constructor(session: Session, moved: () => void) {
    this.#session = session;
    this.#moved = moved;
    this.legend.watch((on) => remember(MEMORY, on ? 'on' : 'off'));
    session.shown.watch(() => this.#measure());
    session.scene.subscribe(() => this.#measure());
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

  /** Loads what measures girths where one is wanted. */
  #measure(): void {
    if (this.#session.scene.state.girth && this.#session.shown.value) {
      this.girth().catch((error: unknown) => this.#session.fail(error));
    }
  }

  /** What measures girths. */
  girth(): Promise<GirthTool> {
    return (this.#girth ??= import('../measure/girth').then(
      ({ GirthTool }) => {
        this.#girthShown = new GirthTool(this.#session);
        this.#session.view.stage.after(this.#girthShown.element);
        return this.#girthShown;
      },
      (error: unknown) => {
        this.#girth = null;
        throw error;
      },
    ));
  }

  /** Resolves when a girth that is wanted is measured. */
  async settled(): Promise<void> {
    await (await this.#girth)?.settled();
  }

  follow(): void {
    this.#girthShown?.follow();
    this.#shown?.follow();
  }

  readonly show = (name: ViewName): void => {
    this.#views(({ show }) => show(name, this.#session, this.#moved));
  };

  /** Opens the menu of views at its button, or closes it. */
  readonly menu = (button: HTMLElement): void => {
    this.#views(({ toggleMenu }) => toggleMenu(button, this.#session, this.show));
  };

  #views(use: (views: typeof import('./views')) => void | Promise<void>): void {
    import('./views').then(use).catch((error: unknown) => this.#session.fail(error));
  }
}
