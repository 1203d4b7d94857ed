/** Tapes on the stage: their curves, places that can be dragged, and lengths that follow the camera and stay in pictures. */
import type { Session } from '../../session/session';
import { lengthOf, type MeasuredTape, stateOf, type Tapes } from '../../session/tapes';
import { entry } from '../../state/entry';
import type { Places } from '../../state/places';
import { type Vector, distance } from '../../state/vector';
import { isSameUnit, type LengthUnit, ofModel, unitOf } from '../../length';
import { legsOf, moved, withoutPlace } from '../../state/tapes';
import { h, say } from '../dom';
import { arrowOf, draggable, hasModifier, keyGesture } from '../gesture';
import type { MeasureInput } from './input';
import { middleOf, polylineOf, positionsOf } from './curves';
import { boxOf, labelElement, stand, standing } from './standing';
import { areaLabel, lengthWords } from './words';
import { sentences, t, type Words } from '../../texts';
import { HALO, RIM, rimmed } from '../../view/layers';
import type { PlaneContext } from '../../view/view';

/** The curve; width in CSS pixels. */
const LINE = { colour: '#ffc233', width: 2.5 };

/** What is seen at the pixel of a place is the place itself where it is no farther away than this share of the diameter. */
const SEEN_WITHIN = 0.02;

const DRAG_PX = 3;
const NUDGE_PX = 6;

/** A drag or a key that repeats comes back within; milliseconds. */
const REST_MS = 700;

/** Of the dot of a place, CSS pixels. */
const DOT = 12;

/** An element that stands where a place is seen. */
interface Anchored {
  element: HTMLElement;
  position: Vector;
}

export class TapeLabels {
  readonly #labelLayer = h('div', { class: 'tapes' });
  readonly #placeLayer = h('div', { class: 'tapes' });
  readonly #spoken = h('p', { class: 'unseen', 'aria-live': 'polite' });
  readonly element = h(
    'div',
    { role: 'group', 'aria-label': t('Tapes') },
    this.#labelLayer,
    this.#placeLayer,
    this.#spoken,
  );
  #speaking: ReturnType<typeof setTimeout> | undefined;
  readonly #session: Session;
  readonly #tapes: Tapes;
  readonly #input: MeasureInput;
  #places: Anchored[][] = [];
  #labels: Anchored[] = [];
  readonly #keys = keyGesture(this.#placeLayer);
  /** Whether lines are on the view. */
  #hasLines = false;

  constructor(session: Session, tapes: Tapes, input: MeasureInput) {
    this.#session = session;
    this.#tapes = tapes;
    this.#input = input;
    standing(session).add({
      labels: () => this.#labels.map(({ element }) => element),
      taken: () =>
        this.#places
          .flat()
          .filter(isSeen)
          .map(({ element }) => boxOf(element, DOT)),
    });
    session.view.overprints.push((context) => this.#print(context));
    tapes.measured.watch(() => this.#show());
    session.pose.watch(() => this.#show());
    session.scene.subscribe((state, previous) => {
      if (!isSameUnit(state, previous)) this.#show();
    });
  }

  /** Goes to where everything is seen now. */
  follow(): void {
    const { view, shown } = this.#session;
    const diameter = shown.value?.places.drawnDiameter ?? 1;
    for (const { element, position } of [...this.#places.flat(), ...this.#labels]) {
      const pixel = view.project(position);
      element.hidden = pixel === null;
      if (!pixel) continue;
      stand(element, pixel);
      const seen = view.pick(...pixel)?.position;
      const isBehind = seen !== undefined && distance(seen, position) > SEEN_WITHIN * diameter;
      element.toggleAttribute('data-behind', isBehind);
    }
    standing(this.#session).place();
  }

  /** Tells screen readers what tapes measure, once that is at rest. */
  #speak(unit: LengthUnit): void {
    clearTimeout(this.#speaking);
    this.#speaking = setTimeout(() => {
      if (this.#session.dragging) return;
      say(this.#spoken, sentences(...this.#tapes.measured.value.map((each, index) => sentenceOf(each, index, unit))));
    }, REST_MS);
  }

  #show(): void {
    const { scene, shown, view } = this.#session;
    if (!shown.value) return;
    const { places, opened } = shown.value;
    const unit = unitOf(scene.state, opened);
    const measured = this.#tapes.measured.value;
    const curves = measured.map((each) => curvesOf(each, places));
    const ends = Float32Array.from(curves.flat().flatMap((curve) => segmentsOf(curve)));
    if (ends.length > 0 || this.#hasLines) {
      view.setEdges('tapes', ends.length > 0 ? rimmed({ ends, ...LINE }) : []);
      this.#hasLines = ends.length > 0;
    }
    this.#placeAll(measured, places);
    this.#labels = measured.flatMap((each, index) => labelsOf(each, entry(curves, index), unit, places));
    this.#labelLayer.replaceChildren(...this.#labels.map(({ element }) => element));
    this.follow();
    this.#speak(unit);
  }

  /** Elements stay as long as the counts do: a drag and the focus go on. */
  #placeAll(measured: readonly MeasuredTape[], places: Places): void {
    const isSame =
      measured.length === this.#places.length &&
      measured.every(({ tape }, index) => tape.points.length === this.#places[index]?.length);
    this.#places = measured.map(({ tape }, index) =>
      tape.points.map((point, place) => {
        const position = places.at(point)?.position ?? [0, 0, 0];
        const former = isSame ? this.#places[index]?.[place]?.element : undefined;
        return { element: former ?? this.#place(index, place), position };
      }),
    );
    if (!isSame) this.#placeLayer.replaceChildren(...this.#places.flat().map(({ element }) => element));
  }

  #place(tape: number, place: number): HTMLElement {
    const button = h('button', {
      class: 'tape-place',
      'aria-label': t`Tape ${tape + 1}, place ${place + 1}`,
      title: t('Drag to move, Delete to remove'),
    });
    draggable(button, {
      begin: ({ button: pressed, clientX: x, clientY: y }) =>
        pressed === 0 ? { x, y, isMoving: false, gesture: {} } : null,
      move: ({ clientX: x, clientY: y }, drag) => {
        drag.isMoving ||= Math.hypot(x - drag.x, y - drag.y) > DRAG_PX;
        if (drag.isMoving) this.#move(tape, place, x, y, drag.gesture);
      },
      end: ({ type, timeStamp }, { isMoving }) => {
        if (!isMoving && type === 'pointerup') this.#input.clickPlace(tape, place, timeStamp);
      },
    });
    // By the keyboard alone: a pointer has ended above.
    button.addEventListener('click', (event) => {
      if (event.detail === 0) this.#input.clickPlace(tape, place, event.timeStamp);
    });
    button.addEventListener('wheel', (event) => this.#session.view.stage.dispatchEvent(new WheelEvent('wheel', event)));
    button.addEventListener('keydown', (event) => this.#key(tape, place, event));
    return button;
  }

  #key(tape: number, place: number, event: KeyboardEvent): void {
    const arrow = arrowOf(event);
    const removes = event.key === 'Delete' || event.key === 'Backspace';
    if ((!arrow && !removes) || hasModifier(event)) return;
    event.preventDefault();
    event.stopPropagation();
    const { scene, view } = this.#session;
    if (!arrow) {
      scene.edit({ tapes: withoutPlace(scene.state.tapes, tape, place) });
      return;
    }
    const position = this.#places[tape]?.[place]?.position;
    const pixel = position && view.project(position);
    if (!pixel) return;
    this.#move(tape, place, pixel[0] + arrow[0] * NUDGE_PX, pixel[1] + arrow[1] * NUDGE_PX, this.#keys());
  }

  #move(tape: number, place: number, x: number, y: number, gesture: object): void {
    const { scene, view } = this.#session;
    const hit = view.pick(x, y);
    if (hit) scene.edit({ tapes: moved(scene.state.tapes, tape, place, hit.point) }, gesture);
  }

  /** What is seen of labels and places, drawn on a picture. */
  #print(context: PlaneContext): void {
    const stage = this.#session.view.stage.getBoundingClientRect();
    const at = ({ position }: Anchored): [number, number] | null => {
      const pixel = this.#session.view.project(position);
      return pixel && [pixel[0] - stage.left, pixel[1] - stage.top];
    };
    for (const each of this.#places.flat().filter(isSeen)) {
      const pixel = at(each);
      if (!pixel) continue;
      context.beginPath();
      context.arc(...pixel, 4, 0, 2 * Math.PI);
      for (const [colour, width] of [
        [HALO, 4.5],
        [RIM, 1.5],
      ] as const) {
        context.lineWidth = width;
        context.strokeStyle = colour;
        context.stroke();
      }
      context.fillStyle = LINE.colour;
      context.fill();
    }
    const labels = this.#labels.filter(isSeen).map(({ element }) => element);
    standing(this.#session).print(context, labels);
  }
}

function isSeen({ element }: Anchored): boolean {
  return !element.hidden && !element.hasAttribute('data-behind');
}

/** Null while a tape has one place. */
function sentenceOf(measured: MeasuredTape, index: number, unit: LengthUnit): Words | null {
  if (measured.legs.length === 0) return null;
  const sum = lengthWords(lengthOf(measured), stateOf(measured), unit);
  const within = areaLabel(measured, unit);
  return within ? t`Tape ${index + 1}: ${sum}, ${within}.` : t`Tape ${index + 1}: ${sum}.`;
}

/** The curve of each leg as it is drawn; empty where there is none. */
function curvesOf({ legs }: MeasuredTape, places: Places): Vector[][] {
  return legs.map(({ leg }) => (leg ? polylineOf(leg, places) : []));
}

function segmentsOf(curve: readonly Vector[]): number[] {
  return curve.slice(1).flatMap((point, index) => entry(curve, index).concat(point));
}

/** The length of each leg in its middle; the sum, and the area, at the last place. */
function labelsOf(measured: MeasuredTape, curves: readonly Vector[][], unit: LengthUnit, places: Places): Anchored[] {
  const { tape, legs } = measured;
  const labels = legs.flatMap(({ leg, state }, index) => {
    const curve = entry(curves, index);
    const position = middleOf(curve.length > 1 ? curve : positionsOf(entry(legsOf(tape), index), places));
    return position ? [label(lengthWords(leg?.length ?? ofModel(NaN), state, unit), position, 'leg')] : [];
  });
  const end = tape.points.at(tape.closed ? 0 : -1);
  const last = end && places.at(end);
  if (legs.length < 2 || !last) return labels;
  const sum = lengthWords(lengthOf(measured), stateOf(measured), unit);
  const within = areaLabel(measured, unit);
  return [...labels, label(within ? t`Σ ${sum} · ${within}` : t`Σ ${sum}`, last.position, 'sum')];
}

function label(text: Words, position: Vector, kind: 'leg' | 'sum'): Anchored {
  return { element: labelElement(`tape-label ${kind}`, text), position };
}
