import type { MeshPoint } from '../../protocol';
import type { Session } from '../../session/session';
import { unitOf } from '../../state/scene';
import { h } from '../dom';
import { measure, percent } from '../words';
import { t } from '../../texts';

/** Distance and nearest input vertex under the pointer or the reticle; ≈ where distance is between those of vertices. */
export class Readout {
  readonly element = h('output', { class: 'readout', hidden: true });
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  show(point: MeshPoint, x: number, y: number): void {
    const text = readoutText(this.#session, point);
    if (text === null) {
      this.hide();
      return;
    }
    this.element.hidden = false;
    this.element.textContent = text;
    const { offsetWidth, offsetHeight } = this.element;
    const { centre, free } = this.#session.view;
    // Panels lie over it.
    const left = Math.max(8, Math.min(x + 16, centre[0] + free / 2 - offsetWidth - 8));
    const top = y + 20 + offsetHeight > innerHeight ? y - offsetHeight - 12 : y + 20;
    this.element.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
  }

  hide(): void {
    this.element.hidden = true;
  }
}

function readoutText({ scene, shown }: Session, point: MeshPoint): string | null {
  if (!shown.value) return null;
  const { opened, places, answer } = shown.value;
  const vertex = t`vertex ${places.nearestVertex(point)}`;
  if (!answer.field) return vertex;
  const distance = places.valueAt(point, answer.field);
  if (!Number.isFinite(distance)) return t`unreachable · ${vertex}`;
  const about = places.isBetween(point) ? '≈ ' : '';
  return t`${about + measure(distance, unitOf(scene.state, opened))} · ${percent(distance / places.diameter)} of the diameter · ${vertex}`;
}
