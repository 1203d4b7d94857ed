/** The labels of tapes and of the girth, which keep off each other, and the lines from where they stand to what they are about. */
import type { Session } from '../../session/session';
import { entry } from '../../state/entry';
import type { Vector } from '../../state/vector';
import type { PlaneContext } from '../../view/view';
import { h } from '../dom';
import { printLabel } from '../print';
import type { Words } from '../../texts';
import { apart, type Box, outlineOf, type Pixel } from './placing';

/** What some labels are, and what none may cover. */
interface Labelled {
  labels: () => readonly HTMLElement[];
  taken: () => readonly Box[];
}

/** Directions in which the farthest vertex is one of the outline: a sphere is found but for a hundredth. */
const DIRECTIONS = 100;
/** Vertices that are looked at, at most. */
const MOST_VERTICES = 50_000;

const everywhere = new WeakMap<Session, Standing>();

/** All labels of a page. */
export function standing(session: Session): Standing {
  const made = everywhere.get(session) ?? new Standing(session);
  everywhere.set(session, made);
  return made;
}

export function labelElement(kind: string, text: Words): HTMLElement {
  const label = h('div', { class: kind }, h('span', {}, text), h('i', { hidden: true }));
  label.classList.add('label');
  return label;
}

/** Stands an element where a place is seen. A transform would keep the line of a label above the labels before it. */
export function stand({ style }: HTMLElement, [x, y]: Pixel): void {
  style.left = `${x.toFixed(1)}px`;
  style.top = `${y.toFixed(1)}px`;
}

class Standing {
  readonly #session: Session;
  readonly #all: Labelled[] = [];
  readonly #extremes = new WeakMap<Float32Array, Vector[]>();

  constructor(session: Session) {
    this.#session = session;
  }

  add(labelled: Labelled): void {
    this.#all.push(labelled);
  }

  /** Moves labels to where they can be read, once they are where their places are seen. */
  place(): void {
    // What is seen stands before what is behind the model.
    const shown = this.#all.flatMap((each) => each.labels()).filter((label) => !label.hidden);
    const labels = shown.toSorted((one, other) => depthOf(one) - depthOf(other));
    if (labels.length === 0) return;
    const spans = labels.map((label) => label.firstElementChild as HTMLElement);
    for (const { style } of spans) style.left = style.top = '0';
    const boxes = spans.map((span) => boxOf(span));
    const anchors = labels.map((label) => boxOf(label));
    const legend = document.querySelector('.legend:not([hidden])');
    const taken = this.#all.flatMap((each) => each.taken());
    if (legend) taken.push(boxOf(legend));
    const shifts = apart(boxes, { taken, room: this.#room, outline: this.#outline() });
    labels.forEach((label, i) => {
      const [[x, y], box, anchor] = [entry(shifts, i), entry(boxes, i), entry(anchors, i)];
      const { style } = entry(spans, i);
      style.left = `${x}px`;
      style.top = `${y}px`;
      lead(label.lastElementChild as HTMLElement, x !== 0 || y !== 0, [box.x + x - anchor.x, box.y + y - anchor.y]);
    });
  }

  /** Draws labels on a picture, each above the lines of all of them. */
  print(context: PlaneContext, labels: readonly Element[]): void {
    const stage = this.#session.view.stage.getBoundingClientRect();
    for (const label of labels) {
      const [span, leader] = label.children;
      if (!span || !leader?.checkVisibility()) continue;
      const [anchor, box] = [boxOf(label), boxOf(span)];
      context.beginPath();
      context.moveTo(anchor.x - stage.left, anchor.y - stage.top);
      context.lineTo(box.x - stage.left, box.y - stage.top);
      context.lineWidth = leader.clientHeight;
      context.strokeStyle = getComputedStyle(leader).backgroundColor;
      context.stroke();
    }
    for (const { firstElementChild: span } of labels) {
      if (!span) continue;
      const { left, top, width, height } = span.getBoundingClientRect();
      printLabel(context, span, { x: left - stage.left, y: top - stage.top, width, height });
    }
  }

  /** Of the window, what panel and tools leave: they reach in from the sides and from below. */
  get #room(): Box {
    const { view } = this.#session;
    const [x, y] = view.centre;
    return { x, y, width: view.free, height: 2 * (y - view.stage.getBoundingClientRect().top) };
  }

  #outline(): Pixel[] {
    const { view, shown } = this.#session;
    const positions = shown.value?.places.positions;
    if (!positions) return [];
    const places = this.#extremes.get(positions) ?? extremesOf(positions);
    this.#extremes.set(positions, places);
    const pixels = places.map((place) => view.project(place));
    return pixels.includes(null) ? [] : outlineOf(pixels.filter((pixel) => pixel !== null));
  }
}

/** The farthest of some positions, #V × 3, in directions all around. */
export function extremesOf(positions: Float32Array): Vector[] {
  const step = 3 * Math.ceil(positions.length / 3 / MOST_VERTICES);
  const found = Array.from({ length: DIRECTIONS }, (_, k) => {
    // Evenly over the sphere, by the golden angle.
    const y = 1 - (2 * k + 1) / DIRECTIONS;
    const [radius, angle] = [Math.sqrt(1 - y * y), k * Math.PI * (3 - Math.sqrt(5))];
    const [x, z] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    let [most, farthest] = [-Infinity, 0];
    for (let at = 0; at + 2 < positions.length; at += step) {
      const reach = x * (positions[at] ?? 0) + y * (positions[at + 1] ?? 0) + z * (positions[at + 2] ?? 0);
      if (reach > most) [most, farthest] = [reach, at];
    }
    return farthest;
  });
  return [...new Set(found)].map((at) => [entry(positions, at), entry(positions, at + 1), entry(positions, at + 2)]);
}

/** A line from the place of a label to so far away; none to a label that stands where it would by itself. */
function lead(leader: HTMLElement, isMoved: boolean, [x, y]: Pixel): void {
  leader.hidden = !isMoved;
  leader.style.width = `${Math.hypot(x, y).toFixed(1)}px`;
  leader.style.transform = `rotate(${Math.atan2(y, x).toFixed(4)}rad)`;
}

/** 1 behind the model, else 0. */
function depthOf(label: HTMLElement): number {
  return Number(label.hasAttribute('data-behind'));
}

/** `size`: of what is seen of it, in its middle; all of it without. */
export function boxOf(element: Element, size?: number): Box {
  const { left, top, width, height } = element.getBoundingClientRect();
  return { x: left + width / 2, y: top + height / 2, width: size ?? width, height: size ?? height };
}
