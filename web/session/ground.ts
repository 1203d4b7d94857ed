/** Changes the ground of the scene as pointer, keyboard and panel ask for it. */
import { Failure } from '../error';
import type { OpenedMesh, MeshPoint } from '../protocol';
import { BRUSH, type Brush } from '../state/brush';
import { type Ground, LEVEL, type WallLine } from '../state/ground';
import type { Disc, Stroke, Terrain } from '../state/painting';
import { type Vector, distance } from '../state/vector';
import { Signal } from '../state/signal';
import type { Tool } from '../state/tool';
import type { PointHit } from '../view/view';
import type { Session } from './session';
import { t } from '../texts';

/** Pixels around a wall along edges within which it is meant. */
const GRIP_PX = 9;

/** Radius of the ring around the end of a wall, as a share of the diameter. */
const MARK = 0.008;

export const NO_GROUND = t('Inside of tetrahedra there is no ground.');

/** What paints: fetched when there is a brush, unless the panel has brought it. */
const fetchPainter = () => import('../state/painting');
type Painter = Awaited<ReturnType<typeof fetchPainter>>;

/** A stroke under way. */
interface Painting {
  stroke: Stroke;
  terrain: Terrain;
  /** All of it is one step of undo. */
  gesture: object;
  has: boolean;
}

export class GroundEditor {
  readonly brush = new Signal<Brush>(BRUSH);
  /** Where the wall along edges that is being drawn has come to, as a vertex of the input; null: none is. */
  readonly lineEnd = new Signal<number | null>(null);
  readonly #session: Session;
  readonly #tool: Signal<Tool>;
  #known: { opened: OpenedMesh; neighbors: Uint32Array; painter: Painter } | null = null;
  #painting: Painting | null = null;

  constructor(session: Session, tool: Signal<Tool>) {
    this.#session = session;
    this.#tool = tool;
    tool.watch(() => {
      this.endLine();
      void this.#learn();
    });
    this.brush.watch((brush, previous) => {
      if (brush.tool !== previous?.tool) this.endLine();
    });
    session.shown.watch((shown, previous) => {
      if (shown?.opened !== previous?.opened) this.endLine();
      if (this.isOn && !this.isThere) tool.value = 'source';
      void this.#learn();
    });
  }

  set(change: Partial<Brush>): void {
    this.brush.value = { ...this.brush.value, ...change };
  }

  /** The pointer paints with what is chosen. */
  take(change: Partial<Brush>): void {
    this.set(change);
    if (this.isThere) this.#tool.value = 'brush';
    else this.#session.fail(new Failure(NO_GROUND));
  }

  /** Whether the mesh on screen has a ground: tetrahedra have none. */
  get isThere(): boolean {
    return !this.#session.shown.value?.opened.interior;
  }

  /** Whether the pointer paints. */
  get isOn(): boolean {
    return this.#tool.value === 'brush';
  }

  /** The radius of the brush as it is drawn. */
  get radius(): number {
    return this.brush.value.radius * (this.#session.shown.value?.places.drawnDiameter ?? 1);
  }

  /** A ring around where the wall along edges has come to, as it is drawn. */
  get lineMark(): { center: Vector; radius: number } | null {
    const places = this.#session.shown.value?.places;
    const vertex = this.lineEnd.value;
    const center = vertex === null ? undefined : places?.at({ vertex })?.position;
    return places && center ? { center, radius: MARK * places.drawnDiameter } : null;
  }

  /** Begins a stroke; false where it cannot be painted yet. */
  begin(hit: PointHit): boolean {
    const canvas = this.#canvas;
    if (!canvas) return false;
    const { terrain, painter } = canvas;
    const session = this.#session;
    const stroke = new painter.Stroke(session.scene.state.ground, terrain.triangles.length / 3, this.brush.value);
    this.#painting = { stroke, terrain, gesture: {}, has: false };
    session.painting = true;
    this.paint([hit]);
    return true;
  }

  /** Goes on with the stroke, over all these places. */
  paint(hits: readonly PointHit[]): void {
    const painting = this.#painting;
    if (!painting) return;
    const { scene } = this.#session;
    const { radius } = this;
    let { ground } = scene.state;
    const before = ground;
    for (const { point, position } of hits) {
      if (!('face' in point)) continue;
      const disc = { face: point.face, center: position, radius };
      ground = painting.stroke.paint(ground, painting.terrain, disc);
      if (this.brush.value.material === 'eraser') ground = this.#withoutLines(ground, disc);
    }
    if (ground === before) return;
    painting.has = true;
    scene.edit({ ground }, painting.gesture);
  }

  end(): void {
    if (!this.#painting) return;
    this.#painting = null;
    this.#session.painting = false;
  }

  /** Ends the stroke as if it had never begun. */
  abandon(): void {
    const has = this.#painting?.has ?? false;
    this.end();
    if (has) this.#session.scene.undo();
  }

  /** What a click does with the tools that do not paint by dragging. */
  async click(point: MeshPoint, x: number, y: number): Promise<void> {
    const { tool } = this.brush.value;
    if (tool === 'line') await this.#extendLine(point);
    else if (tool === 'toggle') this.#toggle(point, x, y);
    else if (tool === 'fill' && 'face' in point) this.#fill(point.face);
  }

  /** Takes away all that is painted, and all walls. */
  clear(): void {
    const { scene } = this.#session;
    scene.edit({ ground: { ...scene.state.ground, faces: LEVEL.faces, lines: [] } });
  }

  /** What slopes and height cost; changes of one gesture are one step of undo. */
  setRelief(change: Partial<Pick<Ground, 'slope' | 'highest'>>, gesture: object | null = null): void {
    const { scene } = this.#session;
    scene.edit({ ground: { ...scene.state.ground, ...change } }, gesture);
  }

  endLine(): boolean {
    const has = this.lineEnd.value !== null;
    this.lineEnd.value = null;
    return has;
  }

  #fill(face: number): void {
    const canvas = this.#canvas;
    if (!canvas) return;
    const { areaOf, codeOfMaterial, filled } = canvas.painter;
    const { scene } = this.#session;
    const { ground } = scene.state;
    const area = areaOf(canvas.terrain.neighbors, ground.faces, face);
    scene.edit({ ground: filled(ground, this.#triangles, area, codeOfMaterial(this.brush.value)) });
  }

  /** Opens a gate, or closes it; any wall can be one. */
  #toggle(point: MeshPoint, x: number, y: number): void {
    const { scene } = this.#session;
    const { ground } = scene.state;
    const index = this.#lineAt(x, y);
    const line = ground.lines[index];
    if (line) {
      scene.edit({ ground: { ...ground, lines: ground.lines.with(index, { ...line, open: !line.open }) } });
      return;
    }
    const canvas = this.#canvas;
    if (!canvas || !('face' in point)) return;
    const changed = canvas.painter.toggled(ground, canvas.terrain.neighbors, point.face);
    if (changed) scene.edit({ ground: changed });
  }

  async #extendLine(point: MeshPoint): Promise<void> {
    const session = this.#session;
    const { engine, shown } = session;
    const places = shown.value?.places;
    if (!engine || !places) return;
    const from = this.lineEnd.value;
    const to = places.nearestVertex(point);
    if (from === to) {
      this.endLine();
      return;
    }
    this.lineEnd.value = to;
    if (from === null) return;
    try {
      const vertices = [...(await engine.queries.line(from, to))];
      if (engine !== session.engine) return;
      const { ground } = session.scene.state;
      const last = ground.lines.at(-1);
      const goesOn = last !== undefined && !last.open && last.vertices.at(-1) === vertices[0];
      const line: WallLine = { vertices: goesOn ? [...last.vertices, ...vertices.slice(1)] : vertices, open: false };
      session.scene.edit({
        ground: { ...ground, lines: [...(goesOn ? ground.lines.slice(0, -1) : ground.lines), line] },
      });
    } catch (error) {
      this.endLine();
      session.fail(error);
    }
  }

  /** The wall along edges that is seen at a pixel; −1 for none. */
  #lineAt(x: number, y: number): number {
    const { scene, shown, view } = this.#session;
    const places = shown.value?.places;
    const pixels = (line: WallLine) =>
      line.vertices.map((vertex) => {
        const position = places?.at({ vertex })?.position;
        return position ? view.project(position) : null;
      });
    return scene.state.ground.lines.findIndex((line) => {
      const points = pixels(line);
      return points.some((end, i) => {
        const start = points[i - 1];
        return start && end ? awayFrom([x, y], start, end) < GRIP_PX : false;
      });
    });
  }

  #withoutLines(ground: Ground, { center, radius }: Disc): Ground {
    const places = this.#session.shown.value?.places;
    const isNear = (vertex: number) => {
      const position = places?.at({ vertex })?.position;
      return position !== undefined && distance(position, center) < radius;
    };
    const lines = ground.lines.filter(({ vertices }) => !vertices.some(isNear));
    return lines.length < ground.lines.length ? { ...ground, lines } : ground;
  }

  get #triangles(): number {
    return (this.#session.shown.value?.opened.surface.triangles.length ?? 0) / 3;
  }

  /** What is painted, and by what; null until both are there. */
  get #canvas(): { terrain: Terrain; painter: Painter } | null {
    const shown = this.#session.shown.value;
    if (!shown || this.#known?.opened !== shown.opened) return null;
    const { triangles } = shown.opened.surface;
    const { neighbors, painter } = this.#known;
    return { terrain: { positions: shown.places.positions, triangles, neighbors }, painter };
  }

  /** Asks what lies beside each triangle, where there is a brush and that is not known, and fetches what paints. */
  async #learn(): Promise<void> {
    const { engine, shown } = this.#session;
    const opened = shown.value?.opened;
    if (!this.isOn || !engine || !opened || this.#known?.opened === opened) return;
    try {
      const [neighbors, painter] = await Promise.all([engine.queries.neighbors(), fetchPainter()]);
      if (shown.value?.opened === opened) this.#known = { opened, neighbors, painter };
    } catch (error) {
      this.#session.fail(error);
    }
  }
}

type Pixel = readonly [number, number];

/** From a pixel to a segment. */
function awayFrom([x, y]: Pixel, [x0, y0]: Pixel, [x1, y1]: Pixel): number {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const share = Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - x0 - share * dx, y - y0 - share * dy);
}
