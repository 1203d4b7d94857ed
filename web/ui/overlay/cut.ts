/** The handle in the middle of a cut: dragged, or moved by arrow keys, it takes the cut along. */
import type { Session } from '../../session/session';
import { lookInto } from '../../state/edit';
import { directionOf, INSIDE_RANGES, middleOf, reachOf } from '../../state/inside';
import type { Vector } from '../../state/places';
import { h, icon } from '../dom';
import { percent } from '../words';
import { t } from '../../texts';

const ARROWS = 'M3 10h14M6 7l-3 3 3 3M14 7l3 3-3 3';

/** How far an arrow key moves the cut, as a share of the way from the middle to the end. */
const STEP = 0.02;
const KEYS: Record<string, number> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

/** A direction that is seen shorter than this on the way to the end, in CSS pixels, is seen from its end: a drag means nothing. */
const LEAST_PIXELS = 8;

export class CutHandle {
  readonly element = h(
    'div',
    { class: 'cut-handle', role: 'slider', tabindex: 0, 'aria-label': t('Position of the cut'), hidden: true },
    icon(ARROWS),
  );
  readonly #session: Session;
  /** Where the drag began, in the window and of the cut, and what a pixel is worth along each axis. */
  #drag: { x: number; y: number; place: number; worth: [number, number]; gesture: object } | null = null;
  /** Keys in a row are one step of undo. */
  #keys: object | null = null;

  constructor(session: Session) {
    this.#session = session;
    const [least, most] = INSIDE_RANGES.place;
    this.element.setAttribute('aria-valuemin', String(least));
    this.element.setAttribute('aria-valuemax', String(most));
    this.element.addEventListener('pointerdown', (event) => this.#take(event));
    this.element.addEventListener('pointermove', (event) => this.#move(event));
    for (const end of ['pointerup', 'pointercancel'] as const) {
      this.element.addEventListener(end, () => (this.#drag = null));
    }
    this.element.addEventListener('keydown', (event) => this.#key(event));
    this.element.addEventListener('keyup', () => (this.#keys = null));
    session.scene.subscribe(() => this.follow());
    session.shown.watch(() => this.follow());
  }

  /** Goes to where the cut is drawn. */
  follow(): void {
    const ends = this.#onScreen();
    this.element.hidden = ends === null;
    if (!ends) return;
    const { inside } = this.#session.scene.state;
    const [middle, ahead] = ends;
    const angle = Math.atan2(ahead[1] - middle[1], ahead[0] - middle[0]);
    this.element.style.transform = `translate(${Math.round(middle[0])}px, ${Math.round(middle[1])}px) rotate(${angle.toFixed(3)}rad)`;
    this.element.setAttribute('aria-valuenow', inside.place.toFixed(2));
    this.element.setAttribute('aria-valuetext', inside.place === 0 ? t('middle') : percent(inside.place));
  }

  /** Where the middle of the cut is drawn, and where it would be at the end of its way; null where there is none. */
  #onScreen(): [[number, number], [number, number]] | null {
    const { scene, shown, view } = this.#session;
    const { inside } = scene.state;
    if (!shown.value?.opened.interior || inside.cut === 'none') return null;
    const { box } = shown.value.places;
    const middle = middleOf(inside, box);
    const direction = directionOf(inside);
    const reach = reachOf(direction, box);
    const ahead = middle.map((along, axis) => along + reach * direction[axis]) as Vector;
    const [from, to] = [view.project(middle), view.project(ahead)];
    return from && to && [from, to];
  }

  #take(event: PointerEvent): void {
    const ends = this.#onScreen();
    if (!ends) return;
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    const [[x, y], [toX, toY]] = ends;
    const pixels = Math.max(LEAST_PIXELS, Math.hypot(toX - x, toY - y));
    const worth: [number, number] = [(toX - x) / pixels ** 2, (toY - y) / pixels ** 2];
    const { place } = this.#session.scene.state.inside;
    this.#drag = { x: event.clientX, y: event.clientY, place, worth, gesture: {} };
  }

  #move(event: PointerEvent): void {
    if (!this.#drag) return;
    const { x, y, place, worth, gesture } = this.#drag;
    this.#put(place + (event.clientX - x) * worth[0] + (event.clientY - y) * worth[1], gesture);
  }

  #key(event: KeyboardEvent): void {
    const side = KEYS[event.key];
    if (side === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.#keys ??= {};
    this.#put(this.#session.scene.state.inside.place + side * STEP, this.#keys);
  }

  #put(place: number, gesture: object): void {
    const [least, most] = INSIDE_RANGES.place;
    lookInto(this.#session.scene, { place: Math.min(most, Math.max(least, place)) }, gesture);
  }
}
