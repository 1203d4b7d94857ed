/** What clicks, taps and keys do to tapes. */
import type { MeshPoint } from '../../protocol';
import type { Session } from '../../session/session';
import type { Signal } from '../../state/signal';
import { isSamePlace } from '../../state/sources';
import { canClose, close, extended } from '../../state/tapes';
import type { Tool } from '../../state/tool';
import { entry } from '../../state/entry';

const DOUBLE_MS = 300;
const DOUBLE_PX = 8;

export class MeasureInput {
  readonly #session: Session;
  readonly #tool: Signal<Tool>;
  /** The tape that the next place belongs to; −1: a new one. */
  #open = -1;
  /** The click that added a place last. */
  #last: { x: number; y: number; time: number } | null = null;

  constructor(session: Session, tool: Signal<Tool>) {
    this.#session = session;
    this.#tool = tool;
    tool.watch((value) => {
      if (value !== 'measure') this.#open = -1;
    });
    session.scene.subscribe(({ tapes }, previous) => {
      // Undo may have taken it away, or closed it again.
      if (tapes !== previous.tapes && (this.#open >= tapes.length || tapes.at(this.#open)?.closed)) this.#open = -1;
    });
  }

  /** True if a click without modifiers was for a tape. */
  click(event: PointerEvent): boolean {
    const hasModifier = event.ctrlKey || event.metaKey || event.shiftKey || event.altKey;
    if (this.#tool.value !== 'measure' || hasModifier) return false;
    const { clientX: x, clientY: y, timeStamp: time } = event;
    const last = this.#last;
    if (last && time - last.time < DOUBLE_MS && Math.hypot(x - last.x, y - last.y) < DOUBLE_PX) {
      this.#close();
      return true;
    }
    const hit = this.#session.view.pick(x, y);
    if (hit) this.add(hit.point);
    this.#last = hit && { x, y, time };
    return true;
  }

  /** Adds a place to the tape that is being laid, or does what a click on it does where it has that place. True if the tool is this one. */
  add(point: MeshPoint): boolean {
    if (this.#tool.value !== 'measure') return false;
    const { scene } = this.#session;
    const place = scene.state.tapes[this.#open]?.points.findLastIndex((laid) => isSamePlace(laid, point)) ?? -1;
    if (place >= 0) {
      this.clickPlace(this.#open, place, Infinity);
      return true;
    }
    const tapes = extended(scene.state.tapes, this.#open, point);
    const index = this.#open < 0 ? tapes.length - 1 : this.#open;
    scene.edit({ tapes });
    this.#open = index;
    return true;
  }

  /** A click on a place of the tape that is being laid: the last one ends it, the first one closes it, and so does a double click. */
  clickPlace(tape: number, place: number, time: number): void {
    if (tape !== this.#open) return;
    const { points } = entry(this.#session.scene.state.tapes, tape);
    if (points.length < 2) return;
    const isLast = place === points.length - 1;
    const isDouble = isLast && this.#last !== null && time - this.#last.time < DOUBLE_MS;
    if (isDouble || place === 0) this.#close();
    else if (isLast) this.end();
  }

  /** Ends the tape that is being laid; false if there is none. */
  end(): boolean {
    const wasOpen = this.#open >= 0;
    this.#open = -1;
    return wasOpen;
  }

  /** Closes the tape where it has places enough, and ends it. */
  #close(): void {
    this.#last = null;
    const { scene } = this.#session;
    if (canClose(scene.state.tapes.at(this.#open))) scene.edit({ tapes: close(scene.state.tapes, this.#open) });
    this.#open = -1;
  }
}
