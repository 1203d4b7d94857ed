/** The section of comparisons and the divider on the stage. What compares is loaded with the first of them. */
import type { Session } from '../../session/session';
import { until } from '../../state/signal';
import type { Comparing } from '../compare/loaded';
import { h } from '../dom';
import { t } from '../../texts';

export class CompareSection {
  /** Over the stage. */
  readonly layer = h('section', { class: 'compare-layer', 'aria-label': t('Comparison') });
  readonly #session: Session;
  #loading: Promise<Comparing> | null = null;
  #loaded: Comparing | null = null;

  constructor(session: Session) {
    this.#session = session;
    session.scene.subscribe(({ compared }) => {
      if (compared) this.#load().catch((error: unknown) => session.fail(error));
    });
  }

  /** Its content, once it is loaded. */
  async element(): Promise<HTMLElement> {
    return (await this.#load()).section;
  }

  /** The divider goes to where the halves meet now. */
  follow(): void {
    this.#loaded?.divider.follow();
  }

  /** Resolves when both sides are shown. */
  async settled(): Promise<void> {
    const loaded = await this.#loading;
    if (!loaded) return;
    const { comparison } = loaded;
    const isShown = () => this.#session.scene.state.compared === null || comparison.answer.value?.field === null;
    const isDone = () => comparison.answer.value !== null && !comparison.working.value && comparison.refiner.settled;
    await until(() => isShown() || isDone(), comparison.answer, comparison.working, comparison.refiner.phase);
  }

  #load(): Promise<Comparing> {
    this.#loading ??= import('../compare/loaded').then(
      ({ comparing }) => {
        this.#loaded = comparing(this.#session);
        this.layer.append(this.#loaded.divider.element);
        return this.#loaded;
      },
      (error: unknown) => {
        // The next comparison tries again.
        this.#loading = null;
        throw error;
      },
    );
    return this.#loading;
  }
}
