/** The handles of the image that is selected: its middle moves it, the middle of its right side turns and scales it. */
import '../../style/decals.css';
import type { MeshPoint } from '../../protocol';
import type { Session } from '../../session/session';
import type { Decal, LaidImage } from '../../state/decals';
import { angleOf, rightAt, uprightAt } from '../../state/decalframe';
import { entry } from '../../state/entry';
import { ofModel } from '../../length';
import type { Place } from '../../state/places';
import { cross, dot, minus, moved, type Vector, vectorAt } from '../../state/vector';
import { attribute, h } from '../dom';
import { arrowOf, draggable, hasModifier, keyGesture } from '../gesture';
import { t } from '../../texts';

/** What an arrow does: so many pixels, degrees, and times as large. */
const STEP_PX = 6;
const TURN = 5;
const GROWTH = 1.05;
/** The right side within the image: its edge itself may be cut off by rounding. */
const RIGHT = [0.98, 0.5] as const;
/** A handle behind the surface by more than this share of the diameter is hidden. */
const HIDDEN_BY = 0.05;

export class DecalHandles {
  readonly #session: Session;
  readonly #middle = h('button', { class: 'decal-handle' });
  readonly #side = h('button', { class: 'decal-handle' });
  readonly element = h(
    'section',
    { class: 'decal-layer', 'aria-label': t('Handles of the image'), hidden: true },
    this.#middle,
    this.#side,
  );

  constructor(session: Session) {
    this.#session = session;
    attribute(this.#middle, 'aria-label', t('Middle of the image; arrows move it, Delete removes it'));
    attribute(this.#side, 'aria-label', t('Right side of the image; arrows turn and scale it'));
    this.#side.dataset.side = 'right';
    session.decal.watch(() => this.follow());
    session.decals.watch(() => this.follow());
    session.scene.subscribe(() => this.follow());
    this.#listen();
  }

  #listen(): void {
    const session = this.#session;
    draggable(this.#middle, {
      begin: ({ clientX, clientY }) => {
        const pixel = this.#pixelOf(this.#place?.position);
        if (!pixel) return null;
        session.dragging = true;
        return { gesture: {}, foot: [pixel[0] - clientX, pixel[1] - clientY] as const };
      },
      move: ({ clientX, clientY }, { gesture, foot }) => {
        const hit = session.view.pick(clientX + foot[0], clientY + foot[1]);
        if (hit) this.#move(hit.point, gesture);
      },
      end: () => (session.dragging = false),
    });
    draggable(this.#side, {
      begin: () => {
        const [place, side] = [this.#place, this.#sidePlace];
        if (!place || !side || !this.#decal) return null;
        session.dragging = true;
        const away = minus(side, place.position);
        const turned = angleOf(place.normal, away) - this.#decal.angle;
        return { gesture: {}, reach: Math.hypot(...away), size: this.#decal.size, turned };
      },
      move: ({ clientX, clientY }, { gesture, reach, size, turned }) => {
        const place = this.#place;
        const position = place && this.#under(clientX, clientY, place);
        if (!position) return;
        const away = minus(position, place.position);
        const angle = angleOf(place.normal, away) - turned;
        const grown = Math.max(this.#least, (size * Math.hypot(...away)) / reach);
        this.#change({ angle: within(angle), size: ofModel(grown) }, gesture);
      },
      end: () => (session.dragging = false),
    });
    const keys = keyGesture(this.element);
    this.element.addEventListener('keydown', (event) => {
      if (hasModifier(event) || !this.#decal) return;
      const isDone = this.#key(event, keys);
      if (!isDone) return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  #key(event: KeyboardEvent, keys: () => object): boolean {
    const { scene, decal, view } = this.#session;
    const current = this.#decal;
    const arrow = arrowOf(event);
    if (!current) return false;
    if (event.key === 'Escape') decal.value = -1;
    else if (event.key === 'Delete' || event.key === 'Backspace') {
      scene.edit({ decals: scene.state.decals.toSpliced(decal.value, 1) });
      view.stage.focus();
    } else if (arrow && event.target === this.#side) {
      const [turn, grow] = arrow;
      const size = ofModel(Math.max(this.#least, current.size * GROWTH ** -grow));
      this.#change({ angle: within(current.angle - TURN * turn), size }, keys());
    } else if (arrow) {
      const pixel = this.#pixelOf(this.#place?.position);
      const hit = pixel && view.pick(pixel[0] + STEP_PX * arrow[0], pixel[1] + STEP_PX * arrow[1]);
      if (hit) this.#move(hit.point, keys());
    } else return false;
    return true;
  }

  /** Goes to where they are seen now. */
  follow(): void {
    const place = this.#place;
    this.element.hidden = !place;
    if (!place) return;
    this.#put(this.#middle, place.position);
    this.#put(this.#side, this.#sidePlace);
  }

  #put(handle: HTMLElement, position: Vector | null): void {
    const pixel = this.#pixelOf(position);
    const isSeen = pixel !== null && position !== null && !this.#isBehind(position, pixel);
    handle.style.visibility = isSeen ? '' : 'hidden';
    if (pixel) handle.style.transform = `translate(${pixel[0].toFixed(1)}px, ${pixel[1].toFixed(1)}px)`;
  }

  #isBehind(position: Vector, pixel: readonly [number, number]): boolean {
    const { view, shown } = this.#session;
    const hit = view.pick(...pixel);
    const most = HIDDEN_BY * (shown.value?.places.drawnDiameter ?? 0);
    return hit !== null && Math.hypot(...minus(position, hit.position)) > most;
  }

  get #decal(): Decal | undefined {
    const { scene, decal } = this.#session;
    return scene.state.decals[decal.value];
  }

  /** Where its middle is drawn. */
  get #place(): Place | null {
    const decal = this.#decal;
    return (decal && this.#session.shown.value?.places.at(decal.place)) ?? null;
  }

  /** The least size. */
  get #least(): number {
    return 0.002 * (this.#session.shown.value?.places.diameter ?? 0);
  }

  /** Where the middle of the right side is drawn; where the surface ends before, in the plane of the middle. */
  get #sidePlace(): Vector | null {
    const { decals, shown, decal: selected } = this.#session;
    const [place, decal] = [this.#place, this.#decal];
    if (!place || !decal || !shown.value) return null;
    const lying = decals.value.find(({ index }) => index === selected.value);
    const laid = lying && placeIn(lying, RIGHT);
    if (laid) return shown.value.places.at(laid)?.position ?? null;
    const { scale } = shown.value.opened.drawTransform;
    return moved(place.position, rightAt(place.normal, decal.angle), scale * decal.size);
  }

  /** The place of the surface under the pointer; beside it, that of the plane of the middle. */
  #under(x: number, y: number, { position, normal }: Place): Vector | null {
    const hit = this.#session.view.pick(x, y);
    if (hit) return hit.position;
    const middle = this.#pixelOf(position);
    const { right, up } = uprightAt(normal);
    const [along, upward] = [right, up].map((axis) => this.#pixelOf(moved(position, axis, 1e-2)));
    if (!middle || !along || !upward) return null;
    // The pixels of the plane, nearly.
    const [a, b] = [along[0] - middle[0], along[1] - middle[1]];
    const [c, d] = [upward[0] - middle[0], upward[1] - middle[1]];
    const whole = a * d - b * c;
    if (whole === 0) return null;
    const [dx, dy] = [x - middle[0], y - middle[1]];
    const [u, v] = [(dx * d - dy * c) / whole, (dy * a - dx * b) / whole];
    return moved(moved(position, right, 1e-2 * u), up, 1e-2 * v);
  }

  #pixelOf(position: Vector | null | undefined): [number, number] | null {
    return position ? this.#session.view.project(position) : null;
  }

  /** Slides it to another place: its right side stays where it points. */
  #move(point: MeshPoint, gesture: object): void {
    const [decal, from] = [this.#decal, this.#place];
    const to = this.#session.shown.value?.places.at(point);
    if (!decal || !from || !to) return;
    const right = rightAt(from.normal, decal.angle);
    // Turned as the normal turns, about the axis that is square to both.
    const [axis, cosine] = [cross(from.normal, to.normal), dot(from.normal, to.normal)];
    const along =
      cosine > -0.999
        ? moved(moved(scaledBy(right, cosine), cross(axis, right), 1), axis, dot(axis, right) / (1 + cosine))
        : right;
    this.#change({ place: point, angle: within(angleOf(to.normal, along)) }, gesture);
  }

  #change(part: Partial<Decal>, gesture: object): void {
    const { scene, decal } = this.#session;
    const { decals } = scene.state;
    const current = decals[decal.value];
    if (current) scene.edit({ decals: decals.with(decal.value, { ...current, ...part }) }, gesture);
  }
}

function scaledBy([x, y, z]: Vector, factor: number): Vector {
  return [factor * x, factor * y, factor * z];
}

/** From −180 to 180. */
function within(angle: number): number {
  return angle - 360 * Math.round(angle / 360);
}

/** The place of the surface where a place of the image lies; null where it lies nowhere. */
function placeIn(
  { laid: { triangles, corners, image } }: LaidImage,
  [x, y]: readonly [number, number],
): MeshPoint | null {
  for (let part = 0; part < triangles.length; part++) {
    const [a, b, c, d, e, f] = [0, 1, 2, 3, 4, 5].map((k) => entry(image, 6 * part + k)) as [
      number,
      number,
      number,
      number,
      number,
      number,
    ];
    const whole = (c - a) * (f - b) - (e - a) * (d - b);
    const second = ((x - a) * (f - b) - (e - a) * (y - b)) / whole;
    const third = ((c - a) * (y - b) - (x - a) * (d - b)) / whole;
    const first = 1 - second - third;
    if (!(first >= 0 && second >= 0 && third >= 0)) continue;
    const [p, q, r] = [0, 1, 2].map((k) => vectorAt(corners, 3 * part + k)) as [Vector, Vector, Vector];
    const weights: Vector = [0, 1, 2].map(
      (k) => first * entry(p, k) + second * entry(q, k) + third * entry(r, k),
    ) as Vector;
    return { face: entry(triangles, part), weights };
  }
  return null;
}
