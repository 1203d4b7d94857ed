/** The pointer as a brush. */
import type { GroundEditor } from '../../session/ground';
import type { Session } from '../../session/session';
import type { Signal } from '../../state/signal';
import type { Tool } from '../../state/tool';
import type { PointHit } from '../../view/view';
import type { Target } from './pick';

/** Places of a stroke are at most this share of the radius apart on the screen, where there are not too many of them. */
const SPACING = 0.4;
const LEAST_SPACING_PX = 3;
const MOST_PLACES = 12;

export class BrushInput {
  readonly #session: Session;
  readonly #editor: GroundEditor;
  #last: readonly [number, number] = [0, 0];

  constructor(session: Session, editor: GroundEditor, tool: Signal<Tool>) {
    this.#session = session;
    this.#editor = editor;
    tool.watch(() => {
      if (!editor.isOn) this.leave();
    });
  }

  /** Whether a plain click or drag changes the ground. With a modifier or another button, the pointer does what it does without. */
  takes(event: PointerEvent, target: Target): boolean {
    const hasModifier = event.ctrlKey || event.metaKey || event.shiftKey || event.altKey;
    return this.#editor.isOn && target.kind === 'surface' && event.button === 0 && !hasModifier;
  }

  /** Begins a stroke where the tool paints by dragging; true if it did. */
  begin(x: number, y: number): boolean {
    const hit = this.#editor.brush.value.tool === 'brush' ? this.#hover(x, y) : null;
    this.#last = [x, y];
    return hit !== null && this.#editor.begin(hit);
  }

  drag(x: number, y: number): void {
    const here = this.#hover(x, y);
    const [x0, y0] = this.#last;
    this.#last = [x, y];
    if (!here) return;
    const spacing = Math.max(LEAST_SPACING_PX, SPACING * this.#pixels(here));
    const count = Math.min(MOST_PLACES, Math.ceil(Math.hypot(x - x0, y - y0) / spacing));
    const between = Array.from({ length: Math.max(0, count - 1) }, (_, i) => {
      const share = (i + 1) / count;
      return this.#session.view.pick(x0 + share * (x - x0), y0 + share * (y - y0));
    });
    this.#editor.paint([...between.filter((hit) => hit !== null), here]);
  }

  end(): void {
    this.#editor.end();
  }

  /** Another finger has come: the stroke was none. */
  abandon(): void {
    this.#editor.abandon();
    this.leave();
  }

  /** True if the click was for the ground. */
  click(event: PointerEvent, target: Target): boolean {
    if (!this.takes(event, target) || target.kind !== 'surface') return false;
    void this.#editor.click(target.point, event.clientX, event.clientY);
    return true;
  }

  /** Shows the brush where the pointer is. */
  hover(x: number, y: number): void {
    if (this.#editor.isOn) this.#hover(x, y);
  }

  leave(): void {
    this.#session.view.setBrush(null);
  }

  #hover(x: number, y: number): PointHit | null {
    const { view } = this.#session;
    const hit = view.pick(x, y);
    const paints = hit && this.#editor.brush.value.tool === 'brush';
    const brush = paints ? { center: hit.position, radius: this.#editor.radius } : this.#editor.lineMark;
    view.setBrush(brush);
    return hit;
  }

  /** The radius of the brush on the screen. */
  #pixels({ position }: PointHit): number {
    const { view } = this.#session;
    const middle = view.project(position);
    const [x, y, z] = position;
    const { radius } = this.#editor;
    const away = ([px, py, pz]: readonly [number, number, number]) => {
      const end = view.project([x + px * radius, y + py * radius, z + pz * radius]);
      return middle && end ? Math.hypot(end[0] - middle[0], end[1] - middle[1]) : 0;
    };
    return Math.max(away([1, 0, 0]), away([0, 1, 0]), away([0, 0, 1]));
  }
}
