import type { MeshPoint } from '../../protocol';
import { bestDistanceAt } from '../../session/distances';
import type { Session } from '../../session/session';
import { isSameUnit, type ModelLength, ofModel, unitOf } from '../../length';
import { h, say } from '../dom';
import { hasCosts } from '../../state/ground';
import { measure } from '../../state/measures';
import { hikingWords, percent } from '../words';
import { t, type Words } from '../../texts';

/** Shares of the diameter below are rounding: places come from the graphics card in single precision. */
const LEAST = 1e-7;

/** What is read, and where on the screen. */
interface Reading {
  point: MeshPoint;
  x: number;
  y: number;
  /** From where it was seen. */
  camera: string;
}

/** Distance and nearest input vertex under the pointer or the reticle; ≈ where it is not exact. */
export class Readout {
  readonly element = h('output', { class: 'readout', hidden: true });
  readonly #session: Session;
  /** Null while nothing is shown. */
  #reading: Reading | null = null;
  #isAsking = false;

  constructor(session: Session) {
    this.#session = session;
    session.scene.subscribe((state, previous) => {
      if (this.#reading && !isSameUnit(state, previous))
        this.show(this.#reading.point, this.#reading.x, this.#reading.y);
    });
  }

  show(point: MeshPoint, x: number, y: number): void {
    const text = readoutText(this.#session, point, null);
    if (text === null) {
      this.hide();
      return;
    }
    this.#reading = { point, x, y, camera: this.#camera };
    this.#draw(this.#reading, text);
    void this.#improve();
  }

  /** Under the place on the screen there is another one once the camera has moved. */
  follow(): void {
    if (this.#reading && this.#reading.camera !== this.#camera) this.hide();
  }

  hide(): void {
    this.#reading = null;
    this.element.hidden = true;
  }

  get #camera(): string {
    return String(this.#session.view.camera);
  }

  /** Asks for the best distance of what is read, one question at a time, and shows it if that is read still. */
  async #improve(): Promise<void> {
    if (this.#isAsking) return;
    this.#isAsking = true;
    try {
      let asked: Reading | null = null;
      while (this.#reading && this.#reading !== asked) {
        asked = this.#reading;
        const answer = this.#session.shown.value?.answer;
        const distance = await bestDistanceAt(this.#session, asked.point);
        const isCurrent = asked === this.#reading && answer === this.#session.shown.value?.answer;
        const text = isCurrent && distance !== null ? readoutText(this.#session, asked.point, distance) : null;
        if (text !== null) this.#draw(asked, text);
      }
    } catch {
      // Another mesh was opened, or the worker failed and says so itself: what is between vertices stays.
    } finally {
      this.#isAsking = false;
    }
  }

  #draw({ x, y }: Reading, text: Words): void {
    this.element.hidden = false;
    say(this.element, text);
    const { offsetWidth, offsetHeight } = this.element;
    const { centre, free } = this.#session.view;
    // Panels lie over it.
    const left = Math.max(8, Math.min(x + 16, centre[0] + free / 2 - offsetWidth - 8));
    const top = y + 20 + offsetHeight > innerHeight ? y - offsetHeight - 12 : y + 20;
    this.element.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
  }
}

/** The distance from curves where that is shown, linear between corners; null: it is not, or is not known there. */
function sideAt({ offsets }: Session, point: MeshPoint): number | null {
  if (!offsets.value || !('face' in point)) return null;
  const { values } = offsets.value;
  const sum = point.weights.reduce((total, weight, k) => total + weight * (values[3 * point.face + k] ?? NaN), 0);
  return Number.isFinite(sum) ? sum : null;
}

/** `best`: the distance; null where it is taken from those of vertices for now. */
function readoutText(session: Session, point: MeshPoint, best: ModelLength | null): Words | null {
  const { scene, shown } = session;
  if (!shown.value) return null;
  const { opened, places, answer } = shown.value;
  const vertex = t`vertex ${places.nearestVertex(point)}`;
  const side = sideAt(session, point);
  if (side !== null) {
    const length = measure(ofModel(Math.abs(side)), unitOf(scene.state, opened));
    const about = places.isBetween(point) ? t`≈ ${length}` : length;
    return side < 0 ? t`${about} inside of the curve · ${vertex}` : t`${about} from the curve · ${vertex}`;
  }
  if (!answer.field || session.isOutdated) return vertex;
  const distance = best ?? places.valueAt(point, answer.field);
  if (!Number.isFinite(distance)) return t`unreachable · ${vertex}`;
  // Rounding of places is no length.
  const shownDistance = distance < LEAST * places.diameter ? ofModel(0) : distance;
  const length = measure(shownDistance, unitOf(scene.state, opened));
  const { exactBelow } = answer.field;
  const isBetween = places.isBetween(point) && !(best !== null && exactBelow === Infinity);
  const about = isBetween || distance > exactBelow ? t`≈ ${length}` : length;
  const { ground } = answer.question;
  if (hasCosts(ground)) {
    const time = ground.slope ? hikingWords(shownDistance, unitOf(scene.state, opened)) : null;
    return time ? t`costs ${about}, ${time} · ${vertex}` : t`costs ${about} · ${vertex}`;
  }
  return t`${about} · ${percent(distance / places.diameter)} of the diagonal · ${vertex}`;
}
