/** The keyboard, and the reticle at the centre of the view that stands in for a pointer. */
import type { MeshPoint } from '../../protocol';
import type { GroundEditor } from '../../session/ground';
import type { Session } from '../../session/session';
import { RADII } from '../../state/brush';
import { INSIDE_RANGES } from '../../state/inside';
import { addSource, lookInto, moveSource, removeSelected, sendWalker, setSource, turnUp } from '../../state/edit';
import type { Signal } from '../../state/signal';
import type { PointHit } from '../../view/view';
import { h } from '../dom';
import { arrowOf, hasModifier, keyGesture } from '../gesture';
import type { Readout } from '../overlay/readout';
import { draws, type Tool } from '../../state/tool';
import type { DrawInput } from './draw';
import type { MeasureInput } from '../measure/input';
import { isHeard } from '../shortcuts';
import type { Stage } from '../stage/stage';
import { isTyping } from './typing';

const ORBIT_PX = 24;
/** How far an arrow moves the selected source on the screen. */
const NUDGE_PX = 6;
const ZOOM_STEP = 1.15;
const BRUSH_STEP = 1.2;
/** How far a key moves the cut, as a share of the way from the middle to the end. */
const CUT_STEP = 0.02;

const TOOL_KEYS: Record<string, Tool> = {
  '1': 'source',
  '2': 'add',
  '3': 'walker',
  '4': 'line',
  '5': 'stroke',
  '6': 'boundary',
  '7': 'part',
  m: 'measure',
};

export interface KeysOptions {
  session: Session;
  readout: Readout;
  tool: Signal<Tool>;
  ground: GroundEditor;
  measure: MeasureInput;
  draw: DrawInput;
  stage: Pick<Stage, 'key'>;
  chooseFile: () => void;
  help: () => void;
  /** Fills the surface. */
  fill: () => void;
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
    const used = this.#command(event) || this.#camera(event) || this.#view(event) || this.#place(event);
    if (used) event.preventDefault();
  }

  #command(event: KeyboardEvent): boolean {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
    const { scene } = this.#o.session;
    const key = event.key.toLowerCase();
    if (key === 'z' && event.shiftKey) scene.redo();
    else if (key === 'z') scene.undo();
    else if (key === 'y') scene.redo();
    else return false;
    return true;
  }

  #camera(event: KeyboardEvent): boolean {
    const { session, cameraMoved } = this.#o;
    const { view, scene } = session;
    const arrow = arrowOf(event);
    if (arrow) {
      const [x, y] = arrow;
      this.#showReticle();
      if (event.ctrlKey || event.metaKey) view.pan(-x * ORBIT_PX, -y * ORBIT_PX);
      else if (scene.state.selected in scene.state.sources) this.#nudge(x, y);
      else view.orbit(-x * ORBIT_PX, -y * ORBIT_PX);
    } else if (hasModifier(event)) return false;
    else if (event.key === '+' || event.key === '=') view.zoom(ZOOM_STEP);
    else if (event.key === '-') view.zoom(1 / ZOOM_STEP);
    else if (event.key.toLowerCase() === 'f') view.frame();
    else return false;
    cameraMoved();
    return true;
  }

  #view(event: KeyboardEvent): boolean {
    if (hasModifier(event)) return false;
    const { session, tool, chooseFile, help, closeMessage } = this.#o;
    const chosen = TOOL_KEYS[event.key.toLowerCase()];
    if (chosen) tool.value = chosen;
    else if (event.key.toLowerCase() === 'p') session.paused.value = !session.paused.value;
    else if (event.key.toLowerCase() === 'a') session.animator.toggle();
    else if (event.key.toLowerCase() === 't') session.turntable.value = !session.turntable.value;
    else if (event.key.toLowerCase() === 'o') chooseFile();
    else if (event.key === '?') help();
    else if (event.key.toLowerCase() === 'b') this.#toggleBrush();
    else if (event.key === '[') this.#resizeBrush(1 / BRUSH_STEP);
    else if (event.key === ']') this.#resizeBrush(BRUSH_STEP);
    else if (event.key.toLowerCase() === 'u') this.#turn();
    else if (event.key.toLowerCase() === 'i') this.#openUp();
    else if (this.#o.stage.key(event.key)) return true;
    else if (event.key === ',') this.#moveCut(-CUT_STEP);
    else if (event.key === '.') this.#moveCut(CUT_STEP);
    else if (event.key === 'Delete' || event.key === 'Backspace') return removeSelected(session.scene);
    else if (event.key === 'Escape') this.#escape(closeMessage);
    else return false;
    return true;
  }

  #toggleBrush(): void {
    const { ground } = this.#o;
    ground.set({ on: !ground.brush.value.on });
  }

  #resizeBrush(factor: number): void {
    const { ground } = this.#o;
    const radius = ground.brush.value.radius * factor;
    ground.set({ radius: Math.min(RADII[1], Math.max(RADII[0], radius)) });
  }

  /** Cuts tetrahedra open, or closes them; a surface is filled. */
  #openUp(): void {
    const { session, fill } = this.#o;
    const { scene, shown } = session;
    if (shown.value?.opened.interior === null) fill();
    else lookInto(scene, { cut: scene.state.inside.cut === 'none' ? 'plane' : 'none' }, {});
  }

  #moveCut(step: number): void {
    const { scene, shown } = this.#o.session;
    const { inside } = scene.state;
    if (!shown.value?.opened.interior || inside.cut === 'none') return;
    const [least, most] = INSIDE_RANGES.place;
    lookInto(scene, { place: Math.min(most, Math.max(least, inside.place + step)) }, this.#gesture());
  }

  #turn(): void {
    const { scene, shown } = this.#o.session;
    if (shown.value) turnUp(scene, shown.value.opened.upright);
  }

  /** Backs out of one thing at a time. */
  #escape(closeMessage: () => boolean): void {
    const { session } = this.#o;
    if (session.loading.value) session.cancelOpening();
    else if (this.#o.ground.endLine() || this.#o.measure.end()) return;
    else if (this.#o.ground.brush.value.on) this.#o.ground.set({ on: false });
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
    if (this.#o.ground.brush.value.on && !walker && !event.shiftKey) this.#paint(hit, x, y);
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
