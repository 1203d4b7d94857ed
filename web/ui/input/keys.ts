/** The keyboard, and the reticle at the centre of the view that stands in for a pointer. */
import type { MeshPoint } from '../../protocol';
import type { GroundEditor } from '../../session/ground';
import type { Session } from '../../session/session';
import { addSource, moveSource, removeSelected, sendWalker, setSource } from '../../state/edit';
import type { Signal } from '../../state/signal';
import type { PointHit } from '../../view/view';
import type { Command } from '../commands';
import { h } from '../dom';
import { arrowOf, hasModifier, keyGesture } from '../gesture';
import { keyOf } from '../keys';
import type { Readout } from '../overlay/readout';
import { draws, type Tool } from '../../state/tool';
import type { DrawInput } from './draw';
import type { MeasureInput } from '../measure/input';
import { isHeard } from '../shortcuts';
import { isTyping } from './typing';

const ORBIT_PX = 24;
/** How far an arrow moves the selected source on the screen. */
const NUDGE_PX = 6;

export interface KeysOptions {
  session: Session;
  readout: Readout;
  tool: Signal<Tool>;
  ground: GroundEditor;
  measure: MeasureInput;
  draw: DrawInput;
  commands: readonly Command[];
  /** Closes the newest message; false if there was none. */
  closeMessage: () => boolean;
  cameraMoved: () => void;
}

export class Keys {
  readonly reticle = h('div', { class: 'reticle', hidden: true, 'aria-hidden': 'true' });
  readonly #o: KeysOptions;
  readonly #gesture = keyGesture(window);

  constructor(options: KeysOptions) {
    this.#o = options;
    addEventListener('keydown', (event) => this.#key(event));
    const { stage } = options.session.view;
    stage.addEventListener('pointerdown', () => this.#hideReticle());
    stage.addEventListener('blur', () => this.#hideReticle());
    options.session.shown.watch(() => this.#showReading());
  }

  #key(event: KeyboardEvent): void {
    if (isTyping(event)) return;
    const element = event.target instanceof HTMLElement ? event.target : document.body;
    // What is open in front of the page has keys of its own.
    if (element.closest('dialog')) return;
    if (!isHeard(event, element === this.#o.session.view.stage || element === document.body)) return;
    const used = this.#command(event) || this.#orbit(event) || this.#backOut(event) || this.#place(event);
    if (used) event.preventDefault();
  }

  #command(event: KeyboardEvent): boolean {
    const key = keyOf(event);
    const command = this.#o.commands.find(({ keys }) => key !== null && keys.includes(key));
    command?.run(this.#gesture());
    return command !== undefined;
  }

  #orbit(event: KeyboardEvent): boolean {
    const arrow = arrowOf(event);
    if (!arrow) return false;
    const { session, cameraMoved } = this.#o;
    const { view, scene } = session;
    const [x, y] = arrow;
    this.#showReticle();
    if (event.ctrlKey || event.metaKey) view.pan(-x * ORBIT_PX, -y * ORBIT_PX);
    else if (scene.state.selected in scene.state.sources) this.#nudge(x, y);
    else view.orbit(-x * ORBIT_PX, -y * ORBIT_PX);
    cameraMoved();
    return true;
  }

  #backOut(event: KeyboardEvent): boolean {
    if (hasModifier(event)) return false;
    if (event.key === 'Delete' || event.key === 'Backspace') return removeSelected(this.#o.session.scene);
    // The browser closes a menu that is open.
    if (event.key !== 'Escape' || document.querySelector(':popover-open')) return false;
    this.#escape(this.#o.closeMessage);
    return true;
  }

  /** Backs out of one thing at a time. */
  #escape(closeMessage: () => boolean): void {
    const { session } = this.#o;
    if (session.loading.value) session.cancelOpening();
    else if (this.#o.ground.endLine() || this.#o.measure.end()) return;
    else if (this.#o.ground.isOn) this.#o.tool.value = 'source';
    else if (session.scene.state.selected >= 0) session.scene.set({ selected: -1 });
    else if (draws(this.#o.tool.value)) this.#o.tool.value = 'source';
    else if (!closeMessage()) this.#hideReticle();
  }

  #place(event: KeyboardEvent): boolean {
    const walker = event.key.toLowerCase() === 'w';
    if (event.key !== 'Enter' && !walker) return false;
    const { session } = this.#o;
    this.#showReticle();
    const [x, y] = session.view.centre;
    const hit = session.view.pick(x, y);
    if (!hit) return true;
    const { point } = hit;
    if (this.#o.ground.isOn && !walker && !event.shiftKey) this.#paint(hit, x, y);
    else if (walker) sendWalker(session.scene, point);
    else if (!event.shiftKey && this.#o.measure.add(point)) return true;
    else if (event.shiftKey) addSource(session.scene, point);
    else if (!this.#o.draw.click(point)) setSource(session.scene, point);
    return true;
  }

  /** What a click there would do. */
  #paint(hit: PointHit, x: number, y: number): void {
    const { ground } = this.#o;
    if (ground.brush.value.tool !== 'brush') void ground.click(hit.point, x, y);
    else if (ground.begin(hit)) ground.end();
  }

  #nudge(x: number, y: number): void {
    const { scene, shown, view } = this.#o.session;
    const { sources, selected } = scene.state;
    const source = sources[selected];
    const position = source && shown.value?.places.at(source)?.position;
    const pixel = position && view.project(position);
    const hit = pixel && view.pick(pixel[0] + x * NUDGE_PX, pixel[1] + y * NUDGE_PX);
    if (!hit) return;
    moveSource(scene, selected, hit.point, this.#gesture());
  }

  #underReticle(): MeshPoint | null {
    return this.#o.session.view.pick(...this.#o.session.view.centre)?.point ?? null;
  }

  #showReticle(): void {
    const [x, y] = this.#o.session.view.centre;
    this.reticle.style.left = `${x}px`;
    this.reticle.style.top = `${y}px`;
    this.reticle.hidden = false;
    // The camera moves with the next frame.
    requestAnimationFrame(() => this.#showReading());
  }

  #showReading(): void {
    if (this.reticle.hidden) return;
    const point = this.#underReticle();
    if (point) this.#o.readout.show(point, ...this.#o.session.view.centre);
    else this.#o.readout.hide();
  }

  #hideReticle(): void {
    if (this.reticle.hidden) return;
    this.reticle.hidden = true;
    this.#o.readout.hide();
  }
}
