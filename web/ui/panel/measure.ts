/** The section of tapes, and the labels on the stage. What measures and shows them is loaded with the first tape. */
import type { Session } from '../../session/session';
import type { MeasuredTape, TapeFigures } from '../../session/tapes';
import { Signal } from '../../state/signal';
import { h } from '../dom';
import { KEYS, withKey } from '../keys';
import type { MeasureInput } from '../measure/input';
import type { Measuring } from '../measure/loaded';
import { byHand } from '../words';
import type { Tool } from '../../state/tool';
import { t } from '../../texts';

export class MeasureSection {
  readonly element: HTMLElement;
  /** Over the stage. */
  readonly labels = h('section', { class: 'tape-layer', 'aria-label': t('Tapes') });
  readonly #session: Session;
  readonly #input: MeasureInput;
  #loading: Promise<Measuring> | null = null;
  #loaded: Measuring | null = null;
  readonly measured = new Signal<readonly MeasuredTape[]>([]);

  constructor(session: Session, input: MeasureInput, tool: Signal<Tool>) {
    this.#session = session;
    this.#input = input;
    const choose = h(
      'button',
      { class: 'wide', title: withKey(t('Mark places to measure between them'), KEYS.measure) },
      t('Measure'),
    );
    choose.addEventListener('click', () => {
      tool.value = tool.value === 'measure' ? 'source' : 'measure';
    });
    tool.watch((value) => choose.setAttribute('aria-pressed', String(value === 'measure')));
    const help = h(
      'p',
      { class: 'quiet' },
      byHand(
        t(
          'Mark two places or more. The last one again, or Esc, ends the tape; the first one, or a double click, closes it.',
        ),
        t('Mark two places or more. The last one again ends the tape; the first one closes it.'),
      ),
    );
    this.element = h('div', { class: 'stack' }, choose, help);
    const isWanted = () => tool.value === 'measure' || session.scene.state.tapes.length > 0;
    const look = () => {
      if (isWanted()) void this.#load();
    };
    tool.watch(look);
    session.scene.subscribe(look);
  }

  /** What is measured. */
  get figures(): readonly TapeFigures[] {
    return this.#loaded?.figures() ?? [];
  }

  /** Labels go to where places are seen now. */
  follow(): void {
    this.#loaded?.labels.follow();
  }

  /** Resolves when all is measured. */
  async settled(): Promise<void> {
    // What could not be loaded measures nothing.
    await (await this.#loading?.catch(() => null))?.tapes.settled();
  }

  async #load(): Promise<void> {
    if (this.#loading) return;
    this.#loading = import('../measure/loaded').then(({ measuring }) => measuring(this.#session, this.#input));
    try {
      this.#loaded = await this.#loading;
      this.#loaded.tapes.measured.watch((measured) => (this.measured.value = measured));
      this.labels.append(this.#loaded.labels.element);
      this.element.append(this.#loaded.table);
      this.#loaded.labels.follow();
    } catch (error) {
      // The next tape tries again.
      this.#loading = null;
      this.#session.fail(error);
    }
  }
}
