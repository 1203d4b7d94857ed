/** The pointer draws sources: lines along edges, strokes; and picks whole boundaries and parts. */
import type { MeshPoint } from '../../protocol';
import type { Session } from '../../session/session';
import { addSet, replaceSet, selectedSet } from '../../state/edit';
import type { Signal } from '../../state/signal';
import type { Corner, SourceSet } from '../../state/sources';
import { type Vector, distance } from '../../state/vector';
import type { PointHit } from '../../view/view';
import type { Tool } from '../../state/tool';
import type { Target } from './pick';

/** Least and greatest number of places of a stroke in a diameter; between these, they are a mean edge apart. */
const PLACES = [100, 1000] as const;
/** Places of a stroke at most, and those that are looked for at once. */
const LONGEST = 10_000;
const MOST_AT_ONCE = 64;
/** Pixels from its beginning within which a stroke ends as a closed curve. */
const CLOSES_PX = 14;

const OPEN_STROKE = { kind: 'stroke', closed: false } as const;

interface Drawing {
  gesture: object;
  set: SourceSet | null;
  /** Where it has come to, in pixels and as it is drawn. */
  x: number;
  y: number;
  last: Vector;
  /** Where it began, and whether it has been away from there. */
  start: readonly [number, number];
  hasLeft: boolean;
}

/** A corner of a line that is dragged. */
interface Held {
  corner: Corner;
  gesture: object;
  /** Where it is to go next. */
  wanted: MeshPoint | null;
  isMoving: boolean;
}

export class DrawInput {
  readonly #session: Session;
  readonly #tool: Signal<Tool>;
  #drawing: Drawing | null = null;
  #held: Held | null = null;
  /** Ends with the set that was asked for last: each may go on with the one before. */
  #latest: Promise<void> = Promise.resolve();

  constructor(session: Session, tool: Signal<Tool>) {
    this.#session = session;
    this.#tool = tool;
  }

  /** Whether a plain drag draws. With a modifier or another button, the pointer does what it does without. */
  takes(event: PointerEvent, target: Target): boolean {
    const hasModifier = event.ctrlKey || event.metaKey || event.shiftKey || event.altKey;
    return this.#tool.value === 'stroke' && target.kind === 'surface' && event.button === 0 && !hasModifier;
  }

  /** Begins a stroke; true if it did. */
  begin(x: number, y: number): boolean {
    const hit = this.#session.view.pick(x, y);
    if (!hit) return false;
    this.#drawing = { gesture: {}, set: null, x, y, last: hit.position, start: [x, y], hasLeft: false };
    this.#session.dragging = true;
    this.#add([hit]);
    return true;
  }

  drag(x: number, y: number): void {
    const drawing = this.#drawing;
    if (!drawing) return;
    const { view } = this.#session;
    const [x0, y0] = [drawing.x, drawing.y];
    const there = view.pick(x, y);
    const away = there ? distance(there.position, drawing.last) : 0;
    const count = Math.min(MOST_AT_ONCE, Math.ceil(away / this.#spacing));
    const between = Array.from({ length: Math.max(0, count - 1) }, (_, i) => {
      const share = (i + 1) / count;
      return view.pick(x0 + share * (x - x0), y0 + share * (y - y0));
    });
    [drawing.x, drawing.y] = [x, y];
    drawing.hasLeft ||= Math.hypot(x - drawing.start[0], y - drawing.start[1]) > 2 * CLOSES_PX;
    this.#add([...between, there].filter((hit) => hit !== null));
  }

  /** Ends the stroke, where it began as a closed curve. */
  end(): void {
    const drawing = this.#drawing;
    if (!drawing) return;
    const [x, y] = drawing.start;
    const isClosed = drawing.hasLeft && Math.hypot(drawing.x - x, drawing.y - y) < CLOSES_PX;
    if (isClosed) this.drag(x, y);
    const { set, gesture } = drawing;
    if (set && isClosed) {
      replaceSet(this.#session.scene, set, { ...set, shape: { kind: 'stroke', closed: true } }, gesture);
    }
    this.#drawing = null;
    this.#session.dragging = false;
  }

  /** Ends the stroke as if it had never begun. */
  abandon(): void {
    const has = this.#drawing?.set;
    this.#drawing = null;
    this.#session.dragging = false;
    if (has) this.#session.scene.undo();
  }

  /** Takes hold of a corner of a line, which follows the pointer from then on. */
  hold(corner: Corner, gesture: object): void {
    this.#held = { corner, gesture, wanted: null, isMoving: false };
  }

  /** The corner that is held goes to a place; one that comes while it is on its way takes the place of those that wait. */
  moveHeld(point: MeshPoint): void {
    const held = this.#held;
    if (!held) return;
    held.wanted = point;
    if (!held.isMoving) this.#later(() => this.#follow(held));
  }

  async #follow(held: Held): Promise<void> {
    held.isMoving = true;
    for (let point = held.wanted; point; point = held.wanted) {
      held.wanted = null;
      const corner = await (await lazily()).moveCorner(this.#session, held.corner, point, held.gesture);
      if (!corner) return;
      held.corner = corner;
    }
    held.isMoving = false;
  }

  /** What a click or Enter does with the tool that is chosen; false for tools that draw nothing. */
  click(point: MeshPoint): boolean {
    const session = this.#session;
    switch (this.#tool.value) {
      case 'line':
        this.#later(async () => (await lazily()).extendLine(session, point, false));
        return true;
      case 'boundary':
        this.#later(async () => (await lazily()).addBoundary(session, point));
        return true;
      case 'part':
        this.#later(async () => (await lazily()).addPart(session, point));
        return true;
      case 'stroke':
        this.#addPlace(point);
        return true;
      case 'source':
      case 'add':
      case 'walker':
      case 'measure':
      case 'brush':
        return false;
    }
  }

  /** Goes on with the stroke that is selected, else begins one. */
  #addPlace(point: MeshPoint): void {
    const { scene } = this.#session;
    const stroke = selectedSet(scene);
    if (stroke?.shape.kind === 'stroke' && !stroke.shape.closed) {
      replaceSet(scene, stroke, { ...stroke, points: [...stroke.points, point] });
    } else addSet(scene, { shape: OPEN_STROKE, points: [point], offset: 0 });
  }

  /** A line along edges from the last source, or from the end of the line that is selected, whatever the tool. */
  line(point: MeshPoint): void {
    this.#later(async () => (await lazily()).extendLine(this.#session, point, true));
  }

  #later(work: () => Promise<void>): void {
    this.#latest = this.#latest.then(work).catch((error: unknown) => this.#session.fail(error));
  }

  /** Adds places to the stroke that are not too near to the last one. */
  #add(hits: readonly PointHit[]): void {
    const drawing = this.#drawing;
    if (!drawing) return;
    const { scene } = this.#session;
    const points = [...(drawing.set?.points ?? [])];
    for (const { point, position } of hits) {
      const isFirst = points.length === 0;
      if (points.length >= LONGEST || (!isFirst && distance(position, drawing.last) < this.#spacing / 2)) continue;
      points.push(point);
      drawing.last = position;
    }
    if (points.length === (drawing.set?.points.length ?? 0)) return;
    const set: SourceSet = { shape: OPEN_STROKE, points, offset: 0 };
    if (drawing.set) replaceSet(scene, drawing.set, set, drawing.gesture);
    else addSet(scene, set, drawing.gesture);
    drawing.set = set;
  }

  /** From one place of a stroke to the next, as they are drawn. */
  get #spacing(): number {
    const shown = this.#session.shown.value;
    if (!shown) return Infinity;
    const { opened, places } = shown;
    const edge = opened.meanEdge * opened.drawTransform.scale;
    const [least, most] = PLACES;
    return Math.min(places.drawnDiameter / least, Math.max(places.drawnDiameter / most, edge));
  }
}

function lazily() {
  return import('../../session/sets');
}
