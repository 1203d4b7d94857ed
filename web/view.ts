/** The canvas and the renderer on it. What is shown is kept, so that a lost renderer can be made again with the scene intact. */
import { parseColour, rampBytes, type Look } from './looks';
import type { Place, Vector } from './places';
import type { OpenedMesh, SurfacePath, SurfacePoint } from './protocol';
import { Signal } from './signal';
import init, { Viewer } from './wasm/viewer/heatwalk_viewer.js';
import wasmAddress from './wasm/viewer/heatwalk_viewer_bg.wasm?url';

export interface PointHit {
  point: SurfacePoint;
  position: Vector;
}

/** The order in which the parts of a picture must be given: the surface clears what depends on it. */
const ORDER = ['background', 'surface', 'scenery', 'ramp', 'stripes', 'distance', 'pins', 'path', 'walker'] as const;
type Layer = (typeof ORDER)[number];
const CLEARED_BY_SURFACE: readonly Layer[] = ['distance', 'pins', 'path', 'walker'];

/** How far panels reach in from the edges of the stage; CSS pixels. */
export interface Insets {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const NO_INSETS: Insets = { left: 0, top: 0, right: 0, bottom: 0 };

export class View {
  readonly stage: HTMLElement;
  readonly #forceWebgl: boolean;
  #canvas: HTMLCanvasElement;
  #viewer: Viewer | null = null;
  readonly #layers = new Map<Layer, (viewer: Viewer) => void>();
  #camera: Float64Array | null = null;
  #frameFirst = false;
  #ratio = 1;
  /** Of the stage, in device pixels. The canvas is no record of it: a renderer that starts sets its size itself. */
  #size: [width: number, height: number] = [1, 1];
  #insets: Insets = NO_INSETS;
  #ready: Promise<unknown> | null = null;
  /** "WebGPU", "WebGL2", or null while there is none. */
  readonly backend = new Signal<string | null>(null);
  /** Why nothing can be drawn. */
  readonly trouble = new Signal<string | null>(null);

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
  }

  /** Makes a renderer on a fresh canvas: a canvas whose context was lost gives no other. */
  async start(): Promise<void> {
    this.#viewer = null;
    this.backend.value = null;
    try {
      this.#ready ??= init({ module_or_path: wasmAddress });
      await this.#ready;
      const fresh = this.#freshCanvas();
      this.#canvas.replaceWith(fresh);
      this.#canvas = fresh;
      const viewer = await Viewer.create(fresh, this.#forceWebgl);
      this.#fit(viewer);
      for (const layer of ORDER) this.#layers.get(layer)?.(viewer);
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

  setBackground(top: string, bottom: string): void {
    this.#show('background', (viewer) => viewer.set_background(unitColour(top), unitColour(bottom)));
  }

  setMesh({ surface, scenery }: OpenedMesh): void {
    for (const layer of CLEARED_BY_SURFACE) this.#layers.delete(layer);
    this.#show('surface', (viewer) => viewer.set_surface(surface.positions, surface.normals, surface.triangles));
    this.#show('scenery', (viewer) => viewer.set_scenery(scenery.positions, scenery.normals, scenery.triangles));
  }

  setDistance(values: Float32Array, max: number): void {
    this.#show('distance', (viewer) => viewer.set_distance(values, max));
  }

  setLook(look: Look, diameter: number): void {
    const [red, green, blue] = unitColour(look.stripe);
    this.#show('ramp', (viewer) => viewer.set_ramp(rampBytes(look.ramp)));
    this.#show('stripes', (viewer) => viewer.set_stripes(look.period * diameter, look.width, red, green, blue));
  }

  setPins(places: readonly Place[], selected: number): void {
    const positions = Float32Array.from(places.flatMap(({ position }) => position));
    const normals = Float32Array.from(places.flatMap(({ normal }) => normal));
    this.#show('pins', (viewer) => viewer.set_pins(positions, normals, selected));
  }

  setPath(path: SurfacePath | null): void {
    const points = path?.points ?? new Float32Array();
    const normals = path?.normals ?? new Float32Array();
    this.#show('path', (viewer) => viewer.set_path(points, normals));
    if (!path) this.#show('walker', (viewer) => viewer.hide_walker());
  }

  setWalker(arc: number): void {
    this.#show('walker', (viewer) => viewer.set_walker(arc));
  }

  /** Models are centred on what the insets leave free. */
  set insets(insets: Insets) {
    this.#insets = insets;
    if (this.#viewer) this.#fit(this.#viewer);
  }

  /** Where models are centred: the middle of what the insets leave free, in CSS pixels of the window. */
  get centre(): [number, number] {
    const stage = this.stage.getBoundingClientRect();
    const { left, top, right, bottom } = this.#insets;
    return [(stage.left + left + stage.right - right) / 2, (stage.top + top + stage.bottom - bottom) / 2];
  }

  /** Device pixels for one CSS pixel. */
  get ratio(): number {
    return this.#ratio;
  }

  orbit(dx: number, dy: number): void {
    this.#viewer?.orbit(dx, dy);
  }

  pan(dx: number, dy: number): void {
    this.#viewer?.pan(dx, dy);
  }

  zoom(factor: number): void {
    this.#viewer?.zoom(factor);
  }

  /** A renderer that is still starting frames as soon as it can. */
  frame(): void {
    this.#frameFirst = this.#viewer === null;
    this.#viewer?.frame();
  }

  focus(position: Vector): void {
    this.#viewer?.focus(...position);
  }

  /** Yaw, pitch, distance, offset; null before the first picture. */
  get camera(): readonly number[] | null {
    return this.#viewer ? [...this.#viewer.camera()] : this.#camera && [...this.#camera];
  }

  set camera(camera: readonly number[]) {
    this.#frameFirst = false;
    this.#camera = Float64Array.from(camera);
    this.#viewer?.set_camera(this.#camera);
  }

  /** `x`, `y` in CSS pixels of the window. */
  pick(x: number, y: number): PointHit | null {
    const { left, top } = this.stage.getBoundingClientRect();
    const hit = this.#viewer?.pick((x - left) * this.#ratio, (y - top) * this.#ratio);
    if (!hit) return null;
    const [a, b, c] = hit.weights;
    const [px, py, pz] = hit.point;
    const found: PointHit = { point: { face: hit.triangle, weights: [a, b, c] }, position: [px, py, pz] };
    hit.free();
    return found;
  }

  /** CSS pixels of the window; null behind the camera. */
  project(position: Vector): [number, number] | null {
    const pixel = this.#viewer?.project(...position);
    if (!pixel) return null;
    const { left, top } = this.stage.getBoundingClientRect();
    return [left + pixel[0] / this.#ratio, top + pixel[1] / this.#ratio];
  }

  /** True if a frame was drawn. */
  render(seconds: number): boolean {
    const viewer = this.#viewer;
    if (!viewer?.needs_frame()) return false;
    if (viewer.render(seconds)) {
      this.#camera = viewer.camera();
    } else {
      void this.start();
    }
    return true;
  }

  #show(layer: Layer, apply: (viewer: Viewer) => void): void {
    this.#layers.set(layer, apply);
    if (this.#viewer) apply(this.#viewer);
  }

  #freshCanvas(): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = this.#size;
    if (!this.#canvas) this.stage.prepend(canvas);
    return canvas;
  }

  #resize(entry: ResizeObserverEntry): void {
    const { width, height } = entry.contentRect;
    const exact = entry.devicePixelContentBoxSize?.[0];
    const w = pixels(width, exact?.inlineSize);
    const h = pixels(height, exact?.blockSize);
    this.#ratio = w / Math.max(1, width);
    this.#size = [w, h];
    if (this.#viewer) this.#fit(this.#viewer);
  }

  #fit(viewer: Viewer): void {
    const { left, top, right, bottom } = this.#insets;
    viewer.resize(...this.#size);
    viewer.set_insets(left * this.#ratio, top * this.#ratio, right * this.#ratio, bottom * this.#ratio);
  }
}

/** The exact count of device pixels differs from the product by rounding only; on an emulated screen it is not scaled. */
function pixels(length: number, exact: number | undefined): number {
  const product = Math.max(1, Math.round(length * devicePixelRatio));
  return exact !== undefined && Math.abs(exact - product) <= 1 ? Math.max(1, exact) : product;
}

function unitColour(css: string): Float32Array {
  return Float32Array.from(parseColour(css), (value) => value / 255);
}
