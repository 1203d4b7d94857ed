/** The handle in the middle of a plane that cuts: dragged, or moved by arrow keys, it takes the cut along. */
import type { Session } from '../session/session';
import { lookInto } from '../state/edit';
import { type CutPlane, directionOf, INSIDE_RANGES, middleOf, reachOf } from '../state/inside';
import { moved } from '../state/vector';
import { attribute, h, icon } from './dom';
import { arrowOf, draggable, hasModifier, keyGesture } from './gesture';
import { percent } from './words';
import { t, type Words } from '../texts';

const ARROWS = 'M3 10h14M6 7l-3 3 3 3M14 7l3 3-3 3';

/** How far an arrow key moves the cut, as a share of the way from the middle to the end. */
const STEP = 0.02;

/** A direction that is seen shorter than this on the way to the end, in CSS pixels, is seen from its end: a drag means nothing. */
const LEAST_PIXELS = 8;

/** What a handle moves. */
export interface Grip {
  label: Words;
  /** Null where there is none. */
  plane: () => CutPlane | null;
  /** Puts the plane at another place. */
  put: (place: number, gesture: object) => void;
}

/** The cut through tetrahedra. */
export function cutOf({ scene, shown }: Session): Grip {
  return {
    label: t('Position of the cut'),
    plane: () => (shown.value?.opened.interior && scene.state.inside.cut !== 'none' ? scene.state.inside : null),
    put: (place, gesture) => lookInto(scene, { place }, gesture),
  };
}

interface Drag {
  /** Where it began, in the window and of the cut. */
  x: number;
  y: number;
  place: number;
  /** How far the cut moves by a pixel along each axis. */
  worth: readonly [number, number];
  gesture: object;
}

export class CutHandle {
  readonly element = h('div', { class: 'cut-handle', role: 'slider', tabindex: 0, hidden: true }, icon(ARROWS));
  readonly #session: Session;
  readonly #grip: Grip;
  readonly #keys = keyGesture(this.element);

  constructor(session: Session, grip: Grip) {
    this.#session = session;
    this.#grip = grip;
    attribute(this.element, 'aria-label', grip.label);
    const [least, most] = INSIDE_RANGES.place;
    this.element.setAttribute('aria-valuemin', String(least));
    this.element.setAttribute('aria-valuemax', String(most));
    draggable(this.element, { begin: (event) => this.#take(event), move: (event, drag) => this.#move(event, drag) });
    this.element.addEventListener('keydown', (event) => this.#key(event));
    session.scene.subscribe(() => this.follow());
    session.shown.watch(() => this.follow());
  }

  /** Goes to where the cut is drawn. */
  follow(): void {
    const ends = this.#onScreen();
    const plane = this.#grip.plane();
    this.element.hidden = ends === null;
    if (!ends || !plane) return;
    const [middle, ahead] = ends;
    const angle = Math.atan2(ahead[1] - middle[1], ahead[0] - middle[0]);
    this.element.style.transform = `translate(${Math.round(middle[0])}px, ${Math.round(middle[1])}px) rotate(${angle.toFixed(3)}rad)`;
    this.element.setAttribute('aria-valuenow', plane.place.toFixed(2));
    attribute(this.element, 'aria-valuetext', plane.place === 0 ? t('middle') : percent(plane.place));
  }

  /** Where the middle of the cut is drawn, and where it would be at the end of its way; null where there is none. */
  #onScreen(): [[number, number], [number, number]] | null {
    const { shown, view } = this.#session;
    const plane = this.#grip.plane();
    if (!shown.value || !plane) return null;
    const { box } = shown.value.places;
    const middle = middleOf(plane, box);
    const direction = directionOf(plane);
    const reach = reachOf(direction, box);
    const ahead = moved(middle, direction, reach);
    const [from, to] = [view.project(middle), view.project(ahead)];
    return from && to && [from, to];
  }

  #take(event: PointerEvent): Drag | null {
    const ends = this.#onScreen();
    const plane = this.#grip.plane();
    if (!ends || !plane) return null;
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    const [[x, y], [toX, toY]] = ends;
    const pixels = Math.max(LEAST_PIXELS, Math.hypot(toX - x, toY - y));
    const worth: [number, number] = [(toX - x) / pixels ** 2, (toY - y) / pixels ** 2];
    return { x: event.clientX, y: event.clientY, place: plane.place, worth, gesture: {} };
  }

  #move({ clientX, clientY }: PointerEvent, { x, y, place, worth: [right, down], gesture }: Drag): void {
    this.#put(place + (clientX - x) * right + (clientY - y) * down, gesture);
  }

  #key(event: KeyboardEvent): void {
    const [right, down] = arrowOf(event) ?? [0, 0];
    if (right === down || hasModifier(event)) return;
    event.preventDefault();
    event.stopPropagation();
    this.#put((this.#grip.plane()?.place ?? 0) + (right - down) * STEP, this.#keys());
  }

  #put(place: number, gesture: object): void {
    const [least, most] = INSIDE_RANGES.place;
    this.#grip.put(Math.min(most, Math.max(least, place)), gesture);
  }
}
