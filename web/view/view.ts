/** The canvas and the renderer on it. What is shown is kept: a lost renderer is made again with the scene intact. */
import type { Appearance, DrawMesh, DrawPose, InnerView, MeshPoint, Shade, SurfacePath } from '../protocol';
import { parseColour, rampBytes, WIDEST_LINE, type Finish, type Style, type MapName } from '../state/styles';
import type { Place, Vector } from '../state/places';
import { isTrap } from '../solver/trap';
import { CROWD_HEIGHT } from '../state/scene';
import { Signal } from '../state/signal';
import {
  CLEARED_BY_SURFACE,
  COMMON,
  EDGE_GROUPS,
  type EdgeGroup,
  type Edges,
  emptyPicture,
  type Fields,
  type Layer,
  NO_APPEARANCE,
  NO_EDGES,
  NO_FIELD,
  NO_FIELDS,
  NO_INSIDE,
  NO_MESH,
  ORDER,
  type Picture,
  type ShownField,
  THIN,
} from './layers';
import { type Build, hasWebGpu, WEBGL2, WEBGPU } from './builds';
import { Traps } from './traps';
import type { Viewer } from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';
import { t } from '../texts';

export interface PointHit {
  point: MeshPoint;
  /** As it is drawn: see `DrawTransform`. */
  position: Vector;
}

/** How far panels reach in from the edges of the stage; CSS pixels. */
export interface Insets {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** A renderer that fails again within this time fails for a reason that is still there. */
const RELAPSE_MS = 10_000;

/** A picture that takes longer never comes. */
const CAPTURE_MS = 30_000;

/** Of a shell of equal distance that is seen straight on. */
const SHELL_OPACITY = 0.35;

const NO_INSETS: Insets = { left: 0, top: 0, right: 0, bottom: 0 };

/** Where labels are drawn over a picture. */
export type PlaneContext = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

export class View {
  readonly stage: HTMLElement;
  /** Asked for, or because WebGPU failed repeatedly. */
  #forceWebgl: boolean;
  readonly #traps = new Traps();
  #canvas: HTMLCanvasElement;
  #viewer: Viewer | null = null;
  /** What calls change. */
  #picture: Picture = emptyPicture();
  /** What is on the canvas: that, or a preview in its place. */
  #drawn = this.#picture;
  #camera: Float64Array | null = null;
  #frameFirst = false;
  /** Of the stage, in device pixels and in CSS pixels. */
  #stage = { width: 1, height: 1, cssWidth: 1 };
  /** Pixels that are drawn for one CSS pixel. */
  #ratio = 1;
  #insets: Insets = NO_INSETS;
  /** Of two fields: see `split`. */
  #split = 0.5;
  /** When the renderer failed last. */
  #failed = Number.NEGATIVE_INFINITY;
  /** "WebGPU", "WebGL2", or null while there is none. */
  readonly backend = new Signal<string | null>(null);
  /** What saved pictures and videos have over the model, in CSS pixels of the stage. */
  readonly overprints: ((context: PlaneContext) => void)[] = [];
  /** Called after each frame, while the canvas can still be read; null: nobody looks. */
  looker: (() => void) | null = null;
  /** Why nothing can be drawn. */
  readonly trouble = new Signal<string | null>(null);
  /** What went wrong while drawing goes on. */
  readonly failure = new Signal<Error | null>(null);
  /** All pixels are drawn, however long a frame takes. */
  drawsAllPixels = false;
  /** Share of the device's pixels along an edge that are drawn. */
  readonly resolution = new Signal(1);

  constructor(stage: HTMLElement, forceWebgl: boolean) {
    this.stage = stage;
    this.#forceWebgl = forceWebgl;
    this.#canvas = this.#freshCanvas();
    const observer = new ResizeObserver(([entry]) => this.#resize(entry));
    try {
      observer.observe(stage, { box: 'device-pixel-content-box' });
    } catch {
      observer.observe(stage);
    }
    this.resolution.watch(() => this.#use((viewer) => this.#fit(viewer)));
  }

  /** Makes a renderer: on WebGPU where the browser has it and it works, else on WebGL2. */
  async start(): Promise<void> {
    this.#viewer = null;
    this.backend.value = null;
    try {
      const viewer = await this.#open();
      this.#fit(viewer);
      if (!this.#replay(viewer)) return await this.start();
      if (this.#camera) viewer.set_camera(this.#camera);
      if (this.#frameFirst) viewer.frame();
      this.#frameFirst = false;
      this.#viewer = viewer;
      this.trouble.value = null;
      this.backend.value = viewer.backend();
    } catch (error) {
      this.trouble.value = error instanceof Error ? error.message : String(error);
    }
  }

  async #open(): Promise<Viewer> {
    if (!this.#forceWebgl && (await hasWebGpu())) {
      try {
        return await this.#create(WEBGPU);
      } catch {
        // WebGL2 may work all the same. If not, its error is told.
      }
    }
    return this.#create(WEBGL2);
  }

  /**
   * A renderer on a fresh canvas, since a canvas whose context was lost gives no other, and in a fresh instance of the
   * module, since one that trapped cannot be called again.
   */
  async #create(build: Build): Promise<Viewer> {
    const Viewer = await build.fresh();
    const fresh = this.#freshCanvas();
    this.#canvas.replaceWith(fresh);
    this.#canvas = fresh;
    return this.#traps.during(Viewer.create(fresh));
  }

  /** Shows everything again. What the renderer refuses is left out from now on. False: the instance trapped on it. */
  #replay(viewer: Viewer): boolean {
    for (const layer of ORDER) {
      try {
        this.#drawn.layers.get(layer)?.(viewer);
      } catch (error) {
        this.#drawn.layers.delete(layer);
        this.failure.value = asError(error);
        if (isUnusable(this.failure.value)) return false;
      }
    }
    return true;
  }

  /** Calls the renderer, if there is one. Where that breaks it, another one takes its place, and an error says so. */
  #use<T>(call: (viewer: Viewer) => T): T | undefined {
    if (!this.#viewer) return undefined;
    try {
      return call(this.#viewer);
    } catch (cause) {
      const error = asError(cause);
      if (!isUnusable(error)) throw error;
      if (this.#recovers()) void this.start();
      else this.#giveUp(t`The renderer failed repeatedly: ${error.message}`);
      throw new Error(t('The renderer failed and was restarted; the scene is unchanged.'), { cause });
    }
  }

  /**
   * Notes that the renderer failed. Whether another one may do better: not where it failed a short while before, unless
   * that was on WebGPU, which is given up then.
   */
  #recovers(): boolean {
    const now = performance.now();
    const relapsed = now - this.#failed < RELAPSE_MS;
    this.#failed = now;
    if (!relapsed) return true;
    if (this.#forceWebgl || this.backend.value !== 'WebGPU') return false;
    this.#forceWebgl = true;
    return true;
  }

  #giveUp(trouble: string): void {
    this.#viewer = null;
    this.backend.value = null;
    this.trouble.value = trouble;
  }

  setBackground(top: string, bottom: string): void {
    this.#show('background', (viewer) => viewer.set_background(unitColour(top), unitColour(bottom)));
  }

  /** `shade`: of the surface alone. If this throws, everything is shown as before. */
  setMesh(surface: DrawMesh, shade: Shade | null, scenery: readonly DrawMesh[], appearance: Appearance | null): void {
    const picture = this.#picture;
    const before = new Map(picture.layers);
    const { materials, images } = appearance ?? NO_APPEARANCE;
    try {
      this.#show('materials', (viewer) => viewer.set_materials([...materials], images));
      this.#show('surface', (viewer) => viewer.set_surface(surface, shade));
      for (const layer of CLEARED_BY_SURFACE) picture.layers.delete(layer);
      [picture.edges, picture.fields, picture.inside] = [NO_EDGES, NO_FIELDS, null];
      this.setScenery(scenery);
    } catch (error) {
      picture.layers = before;
      this.#redraw();
      throw error;
    }
  }

  /**
   * Moves the vertices of the surface, and of the scenery by its indices. `rests`: for a while, so that ambient occlusion is
   * worth its time.
   */
  setPose(surface: DrawPose, scenery: readonly (readonly [number, DrawPose])[], rests: boolean): void {
    this.#show('pose', (viewer) => {
      viewer.set_pose(surface.positions, surface.normals, rests);
      for (const [index, { positions, normals }] of scenery) viewer.set_scenery_pose(index, positions, normals, rests);
    });
  }

  setScenery(parts: readonly DrawMesh[]): void {
    this.#show('scenery', (viewer) => viewer.set_scenery([...parts]));
  }

  /**
   * Puts what `draw` shows in the place of all else, which is kept, and changed by further calls, until `endPreview`. If
   * this throws, everything is shown as before.
   */
  preview(draw: () => void): void {
    const scene = this.#picture;
    const common = [...scene.layers].filter(([layer]) => COMMON.has(layer));
    this.#picture = this.#drawn = { ...emptyPicture(), layers: new Map(common) };
    try {
      draw();
      this.#picture = scene;
    } catch (error) {
      this.#picture = scene;
      this.endPreview();
      throw error;
    }
  }

  /** Further calls change what the preview shows; what was kept is forgotten. */
  adoptPreview(): void {
    this.#picture = this.#drawn;
  }

  /** Shows again what was kept. */
  endPreview(): void {
    this.#drawn = this.#picture;
    if (!this.#picture.layers.has('surface')) this.#use((viewer) => viewer.set_surface(NO_MESH, null));
    this.#redraw();
  }

  get #isPreview(): boolean {
    return this.#drawn !== this.#picture;
  }

  #redraw(): void {
    if (this.#viewer) this.#replay(this.#viewer);
  }

  /** Null where there is none. */
  setField(field: ShownField | null): void {
    this.#showFields({ ...this.#picture.fields, field });
  }

  /** Another field of the same mesh, right of the split; null: none. */
  setOtherField(other: ShownField | null): void {
    if (other !== this.#picture.fields.other) this.#showFields({ ...this.#picture.fields, other });
  }

  /** Both in colors up to the larger of their largest values. */
  #showFields(fields: Fields): void {
    this.#picture.fields = fields;
    const field = fields.field ?? NO_FIELD;
    const other = (fields.field && fields.other) ?? NO_FIELD;
    const most = Math.max(field.maxDistance, other.maxDistance);
    this.#show('field', (viewer) => {
      viewer.set_field(field.distance, field.tangents, most, field.byCorner);
      viewer.set_other_field(other.distance, other.tangents, other.byCorner);
    });
  }

  /** Where the other field begins: share of the width that insets leave free, from the left. */
  set split(split: number) {
    this.#split = split;
    this.#use((viewer) => viewer.set_split(this.#splitOffset));
  }

  /** From the middle of what is free, as a share of the stage's width. */
  get #splitOffset(): number {
    return ((this.#split - 0.5) * this.free) / this.#stage.cssWidth;
  }

  /** Width that the insets leave free; CSS pixels. */
  get free(): number {
    return Math.max(0, this.#stage.cssWidth - this.#insets.left - this.#insets.right);
  }

  /** What is seen of the inside of tetrahedra, where planes of four numbers each cut them open; null: nothing. */
  setInside(inside: InnerView | null, planes: readonly number[]): void {
    if (!inside && !this.#picture.inside) return;
    this.#picture.inside = inside;
    const { positions, normals, values, tangents, triangles, hidesSurface } = inside ?? NO_INSIDE;
    const { shellPositions, shellNormals, shellValues, shellTriangles, arrowPlaces, arrowVectors } =
      inside ?? NO_INSIDE;
    const section = triangles.length > 0 ? { positions, normals, values, tangents, triangles } : null;
    const shells = { positions: shellPositions, normals: shellNormals, values: shellValues, triangles: shellTriangles };
    const cut = Float32Array.from(inside ? planes : []);
    this.#show('inside', (viewer) => {
      viewer.set_cut(cut);
      viewer.set_section(section, hidesSurface);
      viewer.set_shells(shells.triangles.length > 0 ? shells : null, SHELL_OPACITY);
      viewer.set_inner_arrows(arrowPlaces, arrowVectors);
    });
  }

  /** Tints the triangles of the surface, `#F × 4`: see `Viewer.set_tints`. `surface`: as it was set. */
  setTints(surface: DrawMesh, tints: Uint8Array): void {
    const { isTinted } = this;
    this.#show('ground', (viewer) => viewer.set_tints(surface, tints));
    const field = this.#picture.layers.get('field');
    // The first time, the field is forgotten.
    if (!isTinted && field) this.#show('field', field);
  }

  /** Whether the surface was ever tinted. */
  get isTinted(): boolean {
    return this.#picture.layers.has('ground');
  }

  /** Outlines the brush, of a drawn radius; null: none. */
  setBrush(brush: { center: Vector; radius: number } | null): void {
    const [x, y, z] = brush?.center ?? [0, 0, 0];
    this.#use((viewer) => viewer.set_brush(x, y, z, brush?.radius ?? 0));
  }

  /** `whole`: the value that periods are shares of; `facing`: the camera's yaw that the surroundings are made for. */
  setStyle(style: Style, whole: number, facing: number): void {
    const period = style.period * whole;
    const uses = (map: MapName) => style.maps.includes(map);
    const { metalness, roughness } = uses('specular') ? style.stripes : style.surface;
    const { glow } = uses('emission') ? style.stripes : style.surface;
    this.#show('surroundings', (viewer) =>
      viewer.set_environment(style.surroundings, facing + (style.light * Math.PI) / 180),
    );
    this.#show('style', (viewer) => {
      viewer.set_ramps(rampBytes(style));
      viewer.set_finish(uses('colour') ? 1 : 0, finishOf(style.surface), finishOf({ metalness, roughness, glow }));
      viewer.set_materials_of_file(style.surfaceOf === 'file', style.blend);
      if (style.pattern === 'none') viewer.set_bands(0, 0, 1, 0);
      else if (style.pattern === 'lines') viewer.set_lines(period, style.width * WIDEST_LINE);
      else viewer.set_bands(period, style.width, style.sharpness, uses('normal') ? style.relief : 0);
    });
  }

  /** Lights in the place of those of the style, as `OpenedMesh` has them; none for those of the style. */
  setLights(lights: Float32Array): void {
    this.#show('lights', (viewer) => viewer.set_lights(lights));
  }

  /** Moves the pattern away from the sources, in periods. */
  setOffset(periods: number): void {
    this.#show('offset', (viewer) => viewer.set_offset(periods));
  }

  setPins(places: readonly Place[], selected: number): void {
    const positions = Float32Array.from(places.flatMap(({ position }) => position));
    const normals = Float32Array.from(places.flatMap(({ normal }) => normal));
    this.#show('pins', (viewer) => viewer.set_pins(positions, normals, selected));
  }

  setPath(path: SurfacePath | null): void {
    const points = path?.points ?? new Float32Array();
    const normals = path?.normals ?? new Float32Array();
    this.#picture.stride = path && path.length > 0 ? path.drawnLength / path.length : 1;
    this.#show('path', (viewer) => viewer.set_path(points, normals));
    if (!path) this.#show('walker', (viewer) => viewer.hide_walker());
  }

  /** `arc` of the path, in the unit of the file. */
  setWalker(arc: number): void {
    const drawn = arc * this.#picture.stride;
    this.#show('walker', (viewer) => viewer.set_walker(drawn));
  }

  /** `#walkers × 10`, as `SolverApi.stepCrowd` gives them. */
  setCrowd(poses: Float32Array): void {
    this.#show('crowd', (viewer) => viewer.set_crowd(poses, CROWD_HEIGHT));
  }

  /** One vector a triangle; empty for none. */
  setArrows(vectors: Float32Array): void {
    this.#show('arrows', (viewer) => viewer.set_arrows(vectors));
  }

  /** Lines on the surface, in the place of those that were shown for the same. */
  setEdges(group: EdgeGroup, kinds: readonly Edges[]): void {
    const edges = { ...this.#picture.edges, [group]: kinds };
    this.#picture.edges = edges;
    this.#show('edges', (viewer) => {
      viewer.clear_edges();
      for (const { ends, colour, width } of EDGE_GROUPS.flatMap((each) => edges[each])) {
        viewer.add_edges(ends, unitColour(colour), width ?? THIN);
      }
    });
  }

  /** Models are centred on what the insets leave free. */
  set insets(insets: Insets) {
    this.#insets = insets;
    this.#refit();
  }

  /** Where models are centred: the middle of what the insets leave free, in CSS pixels of the window. */
  get centre(): [number, number] {
    const stage = this.stage.getBoundingClientRect();
    const { left, top, right, bottom } = this.#insets;
    return [(stage.left + left + stage.right - right) / 2, (stage.top + top + stage.bottom - bottom) / 2];
  }

  orbit(dx: number, dy: number): void {
    this.#use((viewer) => viewer.orbit(dx, dy));
  }

  /** The pointer takes hold to orbit. */
  hold(): void {
    this.#use((viewer) => viewer.begin_orbit());
  }

  /** The pointer lets go; the camera glides on or stops. */
  letGo(glides: boolean): void {
    this.#use((viewer) => viewer.end_orbit(glides));
  }

  /** Turns by itself, in radians a second; 0 stops. */
  set spin(spin: number) {
    this.#show('spin', (viewer) => viewer.set_spin(spin));
  }

  pan(dx: number, dy: number): void {
    this.#use((viewer) => viewer.pan(dx, dy));
  }

  zoom(factor: number): void {
    this.#use((viewer) => viewer.zoom(factor));
  }

  /** The canvas drawn on now: another one after the renderer was lost. */
  get canvas(): HTMLCanvasElement {
    return this.#canvas;
  }

  /** A renderer that is still starting frames as soon as it can. */
  frame(): void {
    this.#frameFirst = this.#viewer === null;
    this.#use((viewer) => viewer.frame());
  }

  focus(position: Vector): void {
    if (!this.#isPreview) this.#use((viewer) => viewer.focus(...position));
  }

  /** Yaw, pitch, distance, offset; null before the first picture. */
  get camera(): readonly number[] | null {
    const camera = this.#use((viewer) => viewer.camera()) ?? this.#camera;
    return camera && [...camera];
  }

  set camera(camera: readonly number[]) {
    this.#frameFirst = false;
    const numbers = Float64Array.from(camera);
    this.#camera = numbers;
    this.#use((viewer) => viewer.set_camera(numbers));
  }

  /** `x`, `y` in CSS pixels of the window. Nothing is hit while a preview is drawn. */
  pick(x: number, y: number): PointHit | null {
    if (this.#isPreview) return null;
    const { left, top } = this.stage.getBoundingClientRect();
    const hit = this.#use((viewer) => viewer.pick((x - left) * this.#ratio, (y - top) * this.#ratio));
    if (!hit) return null;
    const [a, b, c] = hit.weights;
    const [px, py, pz] = hit.point;
    const { triangle, is_on_section: isOnSection } = hit;
    hit.free();
    const inner = isOnSection && this.#picture.inside ? innerPoint(this.#picture.inside, triangle, [a, b, c]) : null;
    return { point: inner ?? { face: triangle, weights: [a, b, c] }, position: [px, py, pz] };
  }

  /** CSS pixels of the window; null behind the camera and while a preview is drawn. */
  project(position: Vector): [number, number] | null {
    if (this.#isPreview) return null;
    const pixel = this.#use((viewer) => viewer.project(...position));
    if (!pixel) return null;
    const { left, top } = this.stage.getBoundingClientRect();
    return [left + pixel[0] / this.#ratio, top + pixel[1] / this.#ratio];
  }

  /** Draws so large a share of the pixels along an edge from now on, where that is free. */
  adapt(share: number): void {
    this.resolution.value = this.drawsAllPixels ? 1 : share;
  }

  /** True if a frame was drawn. Throws what the graphics device refused; the next frame may be drawn all the same. */
  render(seconds: number): boolean {
    const drawn = this.#use((viewer) => {
      if (!viewer.needs_frame()) return null;
      const isWell = viewer.render(seconds);
      if (isWell) this.#camera = viewer.camera();
      return isWell;
    });
    // A context is lost for reasons of the browser, so that another one is always asked for.
    if (drawn === false) {
      this.#recovers();
      void this.start();
    }
    if (drawn) this.looker?.();
    return typeof drawn === 'boolean';
  }

  /** What is shown, drawn `scale` times as large; without the background when `clear`. RGBA rows from the top. */
  async capture(scale: number, clear: boolean): Promise<ImageData> {
    this.resolution.value = 1;
    const picture = this.#use((viewer) => viewer.capture(scale, clear));
    if (!picture) throw new Error(t('There is no scene to save as an image yet.'));
    const { width, height } = picture;
    for (const since = performance.now(); !picture.is_ready();) {
      if (performance.now() - since > CAPTURE_MS)
        throw new Error(t('The graphics device could not read the image back. Try a smaller one.'));
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
    return new ImageData(new Uint8ClampedArray(picture.into_pixels()), width, height);
  }

  #show(layer: Layer, apply: (viewer: Viewer) => void): void {
    const isCommon = COMMON.has(layer);
    if (isCommon || !this.#isPreview) this.#use(apply);
    this.#picture.layers.set(layer, apply);
    if (isCommon) this.#drawn.layers.set(layer, apply);
  }

  #freshCanvas(): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = this.#pixels;
    if (!this.#canvas) this.stage.prepend(canvas);
    return canvas;
  }

  #resize(entry: ResizeObserverEntry): void {
    const { width, height } = entry.contentRect;
    const exact = entry.devicePixelContentBoxSize?.[0];
    this.#stage = {
      width: pixels(width, exact?.inlineSize),
      height: pixels(height, exact?.blockSize),
      cssWidth: Math.max(1, width),
    };
    this.#refit();
  }

  /** Of the canvas, which is no record of it: a renderer that starts sets its size itself. */
  get #pixels(): [width: number, height: number] {
    const { width, height } = this.#stage;
    const share = this.resolution.value;
    return [Math.max(1, Math.round(share * width)), Math.max(1, Math.round(share * height))];
  }

  /** What is free for the model has another size: once it was seen, it fills as large a share of that as before. */
  #refit(): void {
    this.#use((viewer) => {
      const before = viewer.fitting_distance();
      this.#fit(viewer);
      if (this.#camera) viewer.refit(before);
    });
  }

  #fit(viewer: Viewer): void {
    const [width, height] = this.#pixels;
    const ratio = width / this.#stage.cssWidth;
    this.#ratio = ratio;
    const { left, top, right, bottom } = this.#insets;
    viewer.resize(width, height);
    viewer.set_insets(left * ratio, top * ratio, right * ratio, bottom * ratio);
    viewer.set_split(this.#splitOffset);
  }
}

/** A place on the section as one in its tetrahedron. */
function innerPoint({ triangles, tetrahedra, weights }: InnerView, triangle: number, shares: Vector): MeshPoint {
  const at = (corner: number) =>
    shares.reduce((sum, share, i) => sum + share * weights[4 * triangles[3 * triangle + i] + corner], 0);
  return { tetrahedron: tetrahedra[triangle], weights: [at(0), at(1), at(2), at(3)] };
}

/** Whether the instance must not be called again: it trapped, or an exception left it in the middle of a call. */
function isUnusable(error: Error): boolean {
  return (
    isTrap(error) || /recursive use of an object|while it was borrowed|null pointer passed to rust/.test(error.message)
  );
}

function asError(thrown: unknown): Error {
  return thrown instanceof Error ? thrown : new Error(String(thrown));
}

/** The exact count of device pixels differs from the product by rounding only; on an emulated screen it is not scaled. */
function pixels(length: number, exact: number | undefined): number {
  const product = Math.max(1, Math.round(length * devicePixelRatio));
  return exact !== undefined && Math.abs(exact - product) <= 1 ? Math.max(1, exact) : product;
}

function finishOf({ metalness, roughness, glow }: Finish): Float32Array {
  return Float32Array.of(metalness, roughness, glow);
}

function unitColour(css: string): Float32Array {
  return Float32Array.from(parseColour(css), (value) => value / 255);
}
