/** The canvas of the page and the renderer on it: made, sized, lost and made again. */
import { Failure, messageOf, toError } from '../error';
import { isTrap } from '../solver/trap';
import { Signal } from '../state/signal';
import type { Viewer } from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';
import { type Build, hasWebGpu, WEBGL2, WEBGPU } from './builds';
import { reducedMotion } from './motion';
import { Traps } from './traps';
import { t, type Words } from '../texts';

/** How far panels reach in from the edges of the stage; CSS pixels. */
export interface Insets {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** A renderer that fails again within this time fails for a reason that is still there. */
const RELAPSE_MS = 10_000;

const NO_INSETS: Insets = { left: 0, top: 0, right: 0, bottom: 0 };

/** What is drawn is left to those that extend it. */
export abstract class Screen {
  readonly stage: HTMLElement;
  /** Asked for, or because WebGPU failed repeatedly. */
  #forceWebgl: boolean;
  readonly #traps = new Traps();
  #canvas: HTMLCanvasElement;
  #viewer: Viewer | null = null;
  /** What stands before it. */
  #standIn = (viewer: Viewer): Viewer => viewer;
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
  /** Why nothing can be drawn. */
  readonly trouble = new Signal<Words | null>(null);
  /** All pixels are drawn, however long a frame takes. */
  drawsAllPixels = false;
  /** Share of the device's pixels along an edge that are drawn. */
  readonly resolution = new Signal(1);

  constructor(stage: HTMLElement, forceWebgl: boolean) {
    this.stage = stage;
    this.#forceWebgl = forceWebgl;
    this.#canvas = this.#freshCanvas();
    const observer = new ResizeObserver((entries) => entries.forEach((entry) => this.#resize(entry)));
    try {
      observer.observe(stage, { box: 'device-pixel-content-box' });
    } catch {
      observer.observe(stage);
    }
    this.resolution.watch(() => this.use((viewer) => this.#fit(viewer)));
  }

  /** Shows everything on a renderer that has nothing. False: it must not be called again. */
  protected abstract replay(viewer: Viewer): boolean;

  /** Gives a renderer what only the frame to come shows. */
  protected abstract prepare(viewer: Viewer): void;

  /** Makes a renderer: on WebGPU where the browser has it and it works, else on WebGL2. */
  async start(): Promise<void> {
    this.#viewer = null;
    this.backend.value = null;
    try {
      const viewer = this.#standIn(await this.#open());
      this.#fit(viewer);
      if (!this.replay(viewer)) return await this.start();
      if (this.#camera) viewer.set_camera(this.#camera);
      if (this.#frameFirst) viewer.frame(!reducedMotion());
      this.#frameFirst = false;
      this.#viewer = viewer;
      this.trouble.value = null;
      this.backend.value = viewer.backend();
    } catch (error) {
      this.trouble.value = messageOf(error);
    }
  }

  /** Draws by what stands before the renderer from now on. */
  drawBy(standIn: (viewer: Viewer) => Viewer): void {
    if (standIn === this.#standIn) return;
    this.#standIn = standIn;
    this.#viewer &&= standIn(this.#viewer);
  }

  async #open(): Promise<Viewer> {
    if (!this.#forceWebgl && (await hasWebGpu())) {
      try {
        return await this.#create(WEBGPU);
      } catch {
        // WebGL2 may work all the same. If not, its error is shown.
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

  /** Calls the renderer, if there is one. Where that breaks it, another one takes its place, and an error says so. */
  protected use<T>(call: (viewer: Viewer) => T): T | undefined {
    if (!this.#viewer) return undefined;
    try {
      return call(this.#viewer);
    } catch (cause) {
      const error = toError(cause);
      if (!isUnusable(error)) throw error;
      if (this.#recovers()) void this.start();
      else this.#giveUp(t`The renderer failed repeatedly: ${messageOf(error)}`);
      throw new Failure(t('The renderer failed and was restarted; the scene is unchanged.'), { cause });
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

  #giveUp(trouble: Words): void {
    this.#viewer = null;
    this.backend.value = null;
    this.trouble.value = trouble;
  }

  /** The canvas drawn on now: another one after the renderer was lost. */
  get canvas(): HTMLCanvasElement {
    return this.#canvas;
  }

  /** A renderer that is still starting frames as soon as it can. */
  frame(): void {
    this.#frameFirst = this.#viewer === null;
    this.use((viewer) => viewer.frame(!reducedMotion()));
  }

  /** Yaw, pitch, distance, offset; null before the first picture. */
  get camera(): readonly number[] | null {
    const camera = this.use((viewer) => viewer.camera()) ?? this.#camera;
    return camera && [...camera];
  }

  set camera(camera: readonly number[]) {
    this.#frameFirst = false;
    const numbers = Float64Array.from(camera);
    this.#camera = numbers;
    this.use((viewer) => viewer.set_camera(numbers));
  }

  /** Where the other field begins: share of the width that insets leave free, from the left. */
  set split(split: number) {
    this.#split = split;
    this.use((viewer) => viewer.set_split(this.#splitOffset));
  }

  /** From the middle of what is free, as a share of the stage's width. */
  get #splitOffset(): number {
    return ((this.#split - 0.5) * this.free) / this.#stage.cssWidth;
  }

  /** Width that the insets leave free; CSS pixels. */
  get free(): number {
    return Math.max(0, this.#stage.cssWidth - this.#insets.left - this.#insets.right);
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

  /** A place of the window, in CSS pixels, as pixels of the canvas. */
  protected toCanvas(x: number, y: number): [number, number] {
    const { left, top } = this.stage.getBoundingClientRect();
    return [(x - left) * this.#ratio, (y - top) * this.#ratio];
  }

  /** The other way round. */
  protected toWindow(x: number, y: number): [number, number] {
    const { left, top } = this.stage.getBoundingClientRect();
    return [left + x / this.#ratio, top + y / this.#ratio];
  }

  /** Draws so large a share of the pixels along an edge from now on, where that is free. */
  adapt(share: number): void {
    this.resolution.value = this.drawsAllPixels ? 1 : share;
  }

  /** True if a frame was drawn. Throws what the graphics device rejected; the next frame may be drawn all the same. */
  render(seconds: number): boolean {
    const drawn = this.use((viewer) => {
      this.prepare(viewer);
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
    return typeof drawn === 'boolean';
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
    this.use((viewer) => {
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

/** Whether the instance must not be called again: it trapped, or an exception left it in the middle of a call. */
export function isUnusable(error: Error): boolean {
  return (
    isTrap(error) || /recursive use of an object|while it was borrowed|null pointer passed to rust/.test(error.message)
  );
}

/** The exact count of device pixels differs from the product by rounding only; on an emulated screen it is not scaled. */
function pixels(length: number, exact: number | undefined): number {
  const product = Math.max(1, Math.round(length * devicePixelRatio));
  return exact !== undefined && Math.abs(exact - product) <= 1 ? Math.max(1, exact) : product;
}
