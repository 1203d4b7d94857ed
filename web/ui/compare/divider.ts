/** The line between two settings: dragged, or moved by arrow keys; with what is on either side of it. */
import type { Comparison } from '../../session/comparison';
import type { Session } from '../../session/session';
import { differing, MIDDLE, SPLITS } from '../../state/compared';
import { attribute, h, icon, say } from '../dom';
import { draggable, hasModifier, keyGesture } from '../gesture';
import { printLabel } from '../print';
import { percent } from '../words';
import { settingsWords } from './words';
import { t } from '../../texts';
import type { PlaneContext } from '../../view/view';

const NAME = t('Divider between the two settings');
const ARROWS = 'M3 10h14M6 7l-3 3 3 3M14 7l3 3-3 3';
/** From the middle of what panels leave free, where the handle of a cut stands, to the top of the grip; CSS pixels. */
const GRIP_BELOW = 30;
/** How far an arrow key moves it, as a share of the width. */
const STEP = 0.02;
const KEYS: Record<string, (split: number) => number> = {
  ArrowLeft: (split) => split - STEP,
  ArrowDown: (split) => split - STEP,
  ArrowRight: (split) => split + STEP,
  ArrowUp: (split) => split + STEP,
  Home: () => SPLITS[0],
  End: () => SPLITS[1],
};

export class Divider {
  readonly #left = h('span', { class: 'compare-left' });
  readonly #right = h('span', { class: 'compare-right' });
  readonly #grip = h('div', { class: 'compare-grip', role: 'slider', tabindex: 0, 'aria-label': NAME }, icon(ARROWS));
  readonly element = h('div', { class: 'compare', hidden: true }, this.#left, this.#right, this.#grip);
  readonly #session: Session;
  readonly #comparison: Comparison;
  readonly #keys = keyGesture(this.#grip);

  constructor(session: Session, comparison: Comparison) {
    this.#session = session;
    this.#comparison = comparison;
    const [least, most] = SPLITS;
    this.#grip.setAttribute('aria-valuemin', String(least));
    this.#grip.setAttribute('aria-valuemax', String(most));
    draggable(this.#grip, {
      begin: (event) => this.#take(event),
      move: ({ clientX }, { offset, gesture }) =>
        this.#put((clientX + offset - this.#start) / session.view.free, gesture),
    });
    this.#grip.addEventListener('dblclick', () => this.#put(MIDDLE, {}));
    this.#grip.addEventListener('keydown', (event) => this.#key(event));
    session.view.overprints.push((context) => this.#print(context));
    session.scene.subscribe(() => this.#show());
    comparison.answer.watch(() => this.#show());
    comparison.working.watch((working) => this.element.toggleAttribute('data-working', working));
    this.#show();
  }

  /** Goes to where the halves meet. */
  follow(): void {
    const { compared } = this.#session.scene.state;
    if (!compared || this.element.hidden) return;
    const { stage, free, centre } = this.#session.view;
    const { left, top, height } = stage.getBoundingClientRect();
    const x = this.#start + compared.split * free;
    this.#grip.style.top = `${Math.round(centre[1] - top + GRIP_BELOW)}px`;
    this.element.style.transform = `translate(${Math.round(x - left) + left}px, ${top}px)`;
    this.element.style.height = `${height}px`;
  }

  /** Where the width that panels leave free begins. */
  get #start(): number {
    const { view } = this.#session;
    return view.centre[0] - view.free / 2;
  }

  #show(): void {
    const { compared, ...own } = this.#session.scene.state;
    this.element.hidden = !compared || this.#comparison.answer.value === null;
    if (!compared) return;
    const keys = differing(own, compared);
    say(this.#left, settingsWords(own, keys));
    say(this.#right, settingsWords(compared, keys));
    this.#grip.setAttribute('aria-valuenow', compared.split.toFixed(2));
    attribute(this.#grip, 'aria-valuetext', t`${percent(compared.split)} ${settingsWords(own, keys)}`);
    this.follow();
  }

  /** `offset`: from the pointer to the line. */
  #take(event: PointerEvent): { offset: number; gesture: object } | null {
    const { compared } = this.#session.scene.state;
    if (!compared) return null;
    event.preventDefault();
    this.#grip.focus({ preventScroll: true });
    return { offset: this.#start + compared.split * this.#session.view.free - event.clientX, gesture: {} };
  }

  #key(event: KeyboardEvent): void {
    const { compared } = this.#session.scene.state;
    const move = KEYS[event.key];
    if (!compared || !move || hasModifier(event)) return;
    event.preventDefault();
    event.stopPropagation();
    this.#put(move(compared.split), this.#keys());
  }

  #put(split: number, gesture: object): void {
    const { scene } = this.#session;
    const { compared } = scene.state;
    const [least, most] = SPLITS;
    if (compared) scene.edit({ compared: { ...compared, split: Math.min(most, Math.max(least, split)) } }, gesture);
  }

  /** The line and its words, in a saved picture. */
  #print(context: PlaneContext): void {
    if (this.element.hidden) return;
    const stage = this.#session.view.stage.getBoundingClientRect();
    const line = this.element.getBoundingClientRect();
    context.fillStyle = '#fff';
    // Pictures are moved by less than their height.
    context.fillRect(line.left - stage.left, -stage.height, 2, 3 * stage.height);
    for (const label of [this.#left, this.#right]) {
      const { left, top, width, height } = label.getBoundingClientRect();
      printLabel(context, label, { x: left - stage.left, y: top - stage.top, width, height });
    }
  }
}
