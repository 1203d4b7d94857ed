/** Mouse and touch input on the stage. */
import type { MeshPoint } from '../../protocol';
import type { Session } from '../../session/session';
import { addSource, moveSource, sendWalker, setSource } from '../../state/edit';
import type { Signal } from '../../state/signal';
import { reducedMotion } from '../../view/motion';
import type { Readout } from '../overlay/readout';
import { draws, type Tool } from '../../state/tool';
import type { BrushInput } from './brush';
import type { DrawInput } from './draw';
import type { MeasureInput } from '../measure/input';
import { type Finger, listenToWheel, pinch } from './orbit';
import { type Target, targetAt } from './pick';

const CLICK_PX = 4;
const CLICK_MS = 250;
const LONG_PRESS_MS = 500;
const DOUBLE_MS = 300;
const DOUBLE_PX = 8;

type Mode = 'pressed' | 'orbit' | 'pan' | 'move' | 'corner' | 'paint' | 'pinch' | 'done';

interface Press {
  mode: Mode;
  target: Target;
  x: number;
  y: number;
  time: number;
  touch: boolean;
  /** What a drag paints with. */
  pen: BrushInput | DrawInput | null;
  /** One step of undo for a whole drag. */
  gesture: object;
}

export interface PointerOptions {
  session: Session;
  readout: Readout;
  tool: Signal<Tool>;
  brush: BrushInput;
  measure: MeasureInput;
  draw: DrawInput;
  /** The user moved the camera. */
  cameraMoved: () => void;
}

export class PointerInput {
  readonly #o: PointerOptions;
  readonly #stage: HTMLElement;
  readonly #pointers = new Map<number, Finger>();
  #press: Press | null = null;
  #longPress = 0;
  #lastClick: { x: number; y: number; time: number; placed: boolean } | null = null;
  #hover: PointerEvent | null = null;

  constructor(options: PointerOptions) {
    this.#o = options;
    this.#stage = options.session.view.stage;
  }

  listen(): void {
    const stage = this.#stage;
    const { session, readout, cameraMoved } = this.#o;
    stage.addEventListener('pointerdown', (event) => this.#down(event));
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#up(event));
    stage.addEventListener('pointercancel', (event) => this.#cancel(event));
    stage.addEventListener('pointerleave', () => {
      this.#hover = null;
      readout.hide();
      this.#o.brush.leave();
    });
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    listenToWheel(stage, session.view, cameraMoved);
    // A field that arrives under a resting pointer changes the readout.
    session.shown.watch(() => this.look());
  }

  #down(event: PointerEvent): void {
    const { clientX: x, clientY: y } = event;
    this.#stage.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x, y });
    clearTimeout(this.#longPress);
    if (this.#pointers.size > 1) {
      if (this.#press) {
        if (this.#press.mode === 'paint') this.#press.pen?.abandon();
        this.#endMove(this.#press);
        this.#press.mode = this.#pointers.size === 2 ? 'pinch' : 'done';
      }
      return;
    }
    const touch = event.pointerType === 'touch';
    const target = targetAt(this.#o.session, x, y, touch);
    const pen = [this.#o.draw, this.#o.brush].find((one) => one.takes(event, target)) ?? null;
    this.#press = { mode: 'pressed', target, x, y, time: event.timeStamp, touch, pen, gesture: {} };
    if (pen) {
      if (!pen.begin(x, y)) return;
      this.#press.mode = 'paint';
      this.#o.readout.hide();
      return;
    }
    if (touch && target.kind === 'surface') {
      const { point } = target;
      this.#longPress = window.setTimeout(() => this.#holdStill(point, x, y), LONG_PRESS_MS);
    }
  }

  #holdStill(point: MeshPoint, x: number, y: number): void {
    if (this.#press?.mode !== 'pressed') return;
    this.#press.mode = 'done';
    sendWalker(this.#o.session.scene, point);
    this.#o.readout.show(point, x, y);
  }

  #move(event: PointerEvent): void {
    const { clientX: x, clientY: y } = event;
    const before = this.#pointers.get(event.pointerId);
    if (!before || !this.#press) {
      this.#hover = event;
      this.look();
      return;
    }
    const press = this.#press;
    if (press.mode === 'pinch') this.#pinch(event);
    this.#pointers.set(event.pointerId, { x, y });
    if (press.mode === 'pressed') {
      const away = Math.hypot(x - press.x, y - press.y);
      const slow = event.timeStamp - press.time > CLICK_MS;
      if (away <= (slow ? 1 : CLICK_PX) || (press.touch && away <= 2 * CLICK_PX)) return;
      clearTimeout(this.#longPress);
      this.#beginDrag(press, event);
    }
    const { view } = this.#o.session;
    const [dx, dy] = [x - before.x, y - before.y];
    if (press.mode === 'orbit') view.orbit(dx, dy);
    if (press.mode === 'pan') view.pan(dx, dy);
    if (press.mode === 'orbit' || press.mode === 'pan') this.#o.cameraMoved();
    if (press.mode === 'move') this.#moveSource(press, x, y);
    if (press.mode === 'corner') this.#moveCorner(x, y);
    if (press.mode === 'paint') press.pen?.drag(x, y);
  }

  #beginDrag(press: Press, event: PointerEvent): void {
    const { session, readout } = this.#o;
    const plain = (event.buttons & 1) === 1 && !event.shiftKey;
    const corner = press.target.kind === 'surface' ? press.target.corner : null;
    press.mode = !plain ? 'pan' : press.target.kind === 'source' ? 'move' : corner ? 'corner' : 'orbit';
    const isMoving = press.mode === 'move' || press.mode === 'corner';
    if (isMoving) session.dragging = true;
    if (press.mode === 'corner' && corner) this.#o.draw.hold(corner, press.gesture);
    if (press.mode === 'orbit') session.view.hold();
    this.#stage.dataset.cursor = isMoving ? 'grabbing' : 'moving';
    readout.hide();
  }

  #moveSource(press: Press, x: number, y: number): void {
    const { scene, view } = this.#o.session;
    if (press.target.kind !== 'source') return;
    const { index, foot } = press.target;
    const hit = view.pick(x + foot[0], y + foot[1]);
    if (hit) moveSource(scene, index, hit.point, press.gesture);
  }

  #moveCorner(x: number, y: number): void {
    const hit = this.#o.session.view.pick(x, y);
    if (hit) this.#o.draw.moveHeld(hit.point);
  }

  #pinch(event: PointerEvent): void {
    const [one, other] = this.#pointers.entries();
    if (!one || !other) return;
    const moved = ([id, finger]: [number, Finger]) =>
      id === event.pointerId ? { x: event.clientX, y: event.clientY } : finger;
    pinch(this.#o.session.view, [one[1], other[1]], [moved(one), moved(other)]);
    this.#o.cameraMoved();
  }

  #up(event: PointerEvent): void {
    clearTimeout(this.#longPress);
    this.#pointers.delete(event.pointerId);
    const press = this.#press;
    if (!press || this.#pointers.size > 0) {
      if (press) press.mode = 'done';
      return;
    }
    this.#press = null;
    if (!press.touch) this.#hover = event;
    this.#stage.dataset.cursor = '';
    this.#endMove(press);
    if (press.mode === 'pressed' && event.button === 0) this.#click(press, event);
    if (press.touch) this.#o.readout.hide();
  }

  #cancel(event: PointerEvent): void {
    clearTimeout(this.#longPress);
    this.#pointers.delete(event.pointerId);
    if (this.#press) this.#endMove(this.#press);
    if (this.#pointers.size === 0) this.#press = null;
  }

  #endMove(press: Press): void {
    const { session, cameraMoved } = this.#o;
    if (press.mode === 'move' || press.mode === 'corner') session.dragging = false;
    if (press.mode === 'paint') press.pen?.end();
    if (press.mode === 'orbit') {
      session.view.letGo(!reducedMotion());
      cameraMoved();
    }
  }

  #click(press: Press, event: PointerEvent): void {
    const { session } = this.#o;
    const { x, y, target } = press;
    if (this.#o.brush.click(event, target)) return;
    if (this.#o.measure.click(event)) return;
    const last = this.#lastClick;
    // A line is ended by clicking its end once more.
    const isSeparate = event.shiftKey || draws(this.#o.tool.value);
    const isNear = last && event.timeStamp - last.time < DOUBLE_MS && Math.hypot(x - last.x, y - last.y) < DOUBLE_PX;
    const double = isNear && !isSeparate;
    if (double) {
      // The first click of the two was not meant to move anything.
      if (last.placed) session.scene.undo();
      this.#lastClick = null;
      const hit = session.view.pick(x, y);
      if (hit) session.view.focus(hit.position);
      else session.view.frame();
      this.#o.cameraMoved();
      return;
    }
    this.#lastClick = { x, y, time: event.timeStamp, placed: this.#act(target, event) };
  }

  /** True if sources or walker were moved. */
  #act(target: Target, event: PointerEvent): boolean {
    const { scene } = this.#o.session;
    if (target.kind !== 'surface') {
      scene.set({ selected: target.kind === 'source' ? target.index : -1 });
      return false;
    }
    const tool = this.#o.tool.value;
    if (event.altKey) sendWalker(scene, target.point);
    else if (event.shiftKey) {
      this.#o.draw.line(target.point);
      return false;
    } else if (event.ctrlKey || event.metaKey || tool === 'add') addSource(scene, target.point);
    else if (this.#o.draw.click(target.point)) return false;
    else if (tool === 'walker') sendWalker(scene, target.point);
    else setSource(scene, target.point);
    return true;
  }

  /** Says anew what is under a resting pointer: something else, or seen from elsewhere. */
  look(): void {
    const event = this.#hover;
    if (!event || this.#press || event.pointerType === 'touch') return;
    const { session, readout } = this.#o;
    const { clientX: x, clientY: y } = event;
    this.#o.brush.hover(x, y);
    const target = targetAt(session, x, y, false);
    this.#stage.dataset.cursor = target.kind === 'surface' && target.corner ? 'source' : target.kind;
    const point = target.kind === 'source' ? session.scene.state.sources[target.index] : null;
    if (target.kind === 'empty') readout.hide();
    else readout.show(point ?? (target.kind === 'surface' ? target.point : { vertex: 0 }), x, y);
  }
}
