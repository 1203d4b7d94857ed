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
  /** A unit along the way of the cut on the screen, and how many there are to its end, and half way to it. */
  along: Pixel;
  whole: number;
  half: number;
  gesture: object;
}

type Pixel = [number, number];

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
    const [middle, , ahead] = ends;
    const angle = Math.atan2(ahead[1] - middle[1], ahead[0] - middle[0]);
    this.element.style.transform = `translate(${Math.round(middle[0])}px, ${Math.round(middle[1])}px) rotate(${angle.toFixed(3)}rad)`;
    this.element.setAttribute('aria-valuenow', plane.place.toFixed(2));
    attribute(this.element, 'aria-valuetext', plane.place === 0 ? t('middle') : percent(plane.place));
  }

  /** Where the middle of the cut is drawn, and where it would be half its way further, and all of it; null where there is none. */
  #onScreen(): [Pixel, Pixel, Pixel] | null {
    const { shown, view } = this.#session;
    const plane = this.#grip.plane();
    if (!shown.value || !plane) return null;
    const { box } = shown.value.places;
    const middle = middleOf(plane, box);
    const direction = directionOf(plane);
    const reach = reachOf(direction, box);
    const [from, half, to] = [0, 0.5, 1].map((share) => view.project(moved(middle, direction, share * reach)));
    return from && half && to ? [from, half, to] : null;
  }

  #take(event: PointerEvent): Drag | null {
    const ends = this.#onScreen();
    const plane = this.#grip.plane();
    if (!ends || !plane) return null;
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    const [from, half, to] = ends;
    const whole = Math.max(LEAST_PIXELS, Math.hypot(to[0] - from[0], to[1] - from[1]));
    const along: Pixel = [(to[0] - from[0]) / whole, (to[1] - from[1]) / whole];
    const { clientX: x, clientY: y } = event;
    return { x, y, place: plane.place, along, whole, half: component(from, half, along), gesture: {} };
  }

  #move({ clientX, clientY }: PointerEvent, { x, y, place, along, whole, half, gesture }: Drag): void {
    this.#put(place + wayOf(component([x, y], [clientX, clientY], along), whole, half), gesture);
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

function component(from: Pixel, to: Pixel, [right, down]: Pixel): number {
  return (to[0] - from[0]) * right + (to[1] - from[1]) * down;
}

/**
 * How far along its way what is seen `pixels` further is, where the end of the way is `whole` pixels ahead and its middle `half`: places on
 * a line in space are seen at a · t / (1 + b · t).
 */
export function wayOf(pixels: number, whole: number, half: number): number {
  const b = whole > 2 * LEAST_PIXELS && half > 0 && half < whole ? (2 * half - whole) / (whole - half) : 0;
  const rest = whole * (1 + b) - b * pixels;
  // Beyond where all lines along the way meet.
  return rest > 0 ? pixels / rest : Math.sign(pixels) * Infinity;
}
