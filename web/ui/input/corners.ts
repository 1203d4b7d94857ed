/** The corners of the line along edges that is selected, for the keyboard: each has the focus in turn, and arrows move it. */
import type { Session } from '../../session/session';
import { selectedSet } from '../../state/edit';
import { entry } from '../../state/entry';
import type { SourceSet } from '../../state/sources';
import type { MeshPoint } from '../../protocol';
import { attribute, h, say } from '../dom';
import { arrowOf, hasModifier, keyGesture } from '../gesture';
import type { DrawInput } from './draw';
import { t } from '../../texts';

/** A corner goes to the first vertex in the direction of the arrow: it is looked for in at most `MOST_STEPS` steps of `STEP_PX` CSS pixels. */
const STEP_PX = 4;
const MOST_STEPS = 60;

export class LineCorners {
  readonly #announced = h('p', { class: 'unseen', 'aria-live': 'polite' });
  readonly #layer = h('div', {});
  readonly element = h(
    'section',
    { class: 'corner-layer', 'aria-label': t('Corners of the line'), hidden: true },
    this.#layer,
    this.#announced,
  );
  readonly #session: Session;
  readonly #draw: DrawInput;
  #corners: readonly number[] = [];
  readonly #keys = keyGesture(this.#layer);

  constructor(session: Session, draw: DrawInput) {
    this.#session = session;
    this.#draw = draw;
    session.scene.subscribe((state, previous) => {
      if (state.sets !== previous.sets || state.selected !== previous.selected) this.#show();
    });
    session.shown.watch(() => this.#show());
  }

  /** Goes to where they are seen now. */
  follow(): void {
    if (this.element.hidden) return;
    this.#corners.forEach((vertex, place) => {
      const button = this.#layer.children[place];
      const pixel = this.#pixelOf(vertex);
      if (!(button instanceof HTMLElement)) return;
      button.hidden = pixel === null;
      if (pixel) button.style.transform = `translate(${pixel[0].toFixed(1)}px, ${pixel[1].toFixed(1)}px)`;
    });
  }

  get #line(): SourceSet | null {
    const set = selectedSet(this.#session.scene);
    return set?.shape.kind === 'line' ? set : null;
  }

  /** Elements stay as long as the count does, and with them the focus. */
  #show(): void {
    const shape = this.#line?.shape;
    const corners = shape?.kind === 'line' ? shape.corners : [];
    const before = this.#corners;
    this.#corners = corners;
    if (corners.length !== before.length) {
      this.#layer.replaceChildren(...corners.map((_, place) => this.#button(place)));
    }
    this.element.hidden = corners.length === 0;
    corners.forEach((vertex, place) => {
      const words = t`Corner ${place + 1} of ${corners.length}, vertex ${vertex}`;
      const button = entry(this.#layer.children, place);
      attribute(button, 'aria-label', words);
      const isMoved = vertex !== before[place] && button === document.activeElement;
      if (isMoved) say(this.#announced, words);
    });
    this.follow();
  }

  #button(place: number): HTMLElement {
    const button = h('button', { class: 'corner' });
    button.addEventListener('keydown', (event) => this.#key(place, event));
    return button;
  }

  #key(place: number, event: KeyboardEvent): void {
    const arrow = arrowOf(event);
    const set = this.#line;
    if (!arrow || !set || hasModifier(event)) return;
    event.preventDefault();
    event.stopPropagation();
    const vertex = entry(this.#corners, place);
    const there = this.#towards(vertex, arrow);
    if (!there) return;
    this.#draw.hold({ set, place, vertex }, this.#keys());
    this.#draw.moveHeld(there);
  }

  /** The next vertex that is seen in a direction and is no corner yet; null where the surface ends before. */
  #towards(vertex: number, [x, y]: readonly [number, number]): MeshPoint | null {
    const { shown, view } = this.#session;
    const start = this.#pixelOf(vertex);
    if (!start || !shown.value) return null;
    for (let step = 1; step <= MOST_STEPS; step++) {
      const hit = view.pick(start[0] + x * step * STEP_PX, start[1] + y * step * STEP_PX);
      if (!hit) return null;
      const next = shown.value.places.nearestVertex(hit.point);
      if (!this.#corners.includes(next)) return { vertex: next };
    }
    return null;
  }

  #pixelOf(vertex: number): [number, number] | null {
    const { shown, view } = this.#session;
    const place = shown.value?.places.at({ vertex });
    return place ? view.project(place.position) : null;
  }
}
