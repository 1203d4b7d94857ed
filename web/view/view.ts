/** What is shown on the screen. It is kept, so that a renderer that was lost is made again with the scene intact. */
import { Failure, toError } from '../error';
import type { Appearance, DrawMesh, DrawnSurface, DrawPose, InnerView, MeshPoint, Shade, DrawPath } from '../protocol';
import {
  parseColour,
  rampBytes,
  stripeFinish,
  WIDEST_LINE,
  type Finish,
  type Style,
  type MapName,
} from '../state/styles';
import type { Place } from '../state/places';
import { type Vector, vectorAt } from '../state/vector';
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
  NO_ARROWS,
  NO_EDGES,
  NO_FIELD,
  NO_FIELDS,
  NO_MESH,
  ORDER,
  type Patches,
  type Picture,
  type ShownField,
  THIN,
  WITH_FRAME,
} from './layers';
import { reducedMotion } from './motion';
import { isUnusable, Screen } from './screen';
import type { Viewer } from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';
import { t } from '../texts';
import { entry } from '../state/entry';

export interface PointHit {
  point: MeshPoint;
  /** As it is drawn: see `DrawTransform`. */
  position: Vector;
}

/** A picture that takes longer never comes. */
const CAPTURE_MS = 30_000;

/** Of a shell of equal distance that is seen straight on. */
const SHELL_OPACITY = 0.35;

/** What the colors of the picture stand for: the largest value, what stripes are apart, and how far they are moved, in periods. */
interface PaintedField {
  readonly most: number;
  readonly period: number;
  readonly offset: number;
}

/** Where labels are drawn over a picture. */
export type PlaneContext = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

export class View extends Screen {
  /** What calls change. */
  #picture: Picture = emptyPicture();
  /** What is on the canvas: that, or a preview in its place. */
  #drawn = this.#picture;
  /** What the renderer is given with the next frame. */
  readonly #awaited = new Set<Layer>();
  /** What saved pictures and videos have over the model, in CSS pixels of the stage. */
  readonly overprints: ((context: PlaneContext) => void)[] = [];
  /** What they have in a corner: in CSS pixels of the picture, whose size these are, and how many of its own pixels one is. */
  readonly captions: ((context: PlaneContext, width: number, height: number, pixels: number) => void)[] = [];
  #isJoined = false;
  painted: PaintedField = { most: 0, period: 0, offset: 0 };
  /** What went wrong while drawing goes on. */
  readonly failure = new Signal<Error | null>(null);

  /** Shows everything again. What the renderer rejects is left out from now on. False: the instance trapped on it. */
  protected override replay(viewer: Viewer): boolean {
    for (const layer of ORDER) {
      try {
        this.#drawn.layers.get(layer)?.(viewer);
      } catch (error) {
        this.#drawn.layers.delete(layer);
        this.failure.value = toError(error);
        if (isUnusable(this.failure.value)) return false;
      }
    }
    return true;
  }

  protected override prepare(viewer: Viewer): void {
    for (const layer of ORDER) {
      if (this.#awaited.delete(layer)) this.#drawn.layers.get(layer)?.(viewer);
    }
  }

  setBackground(top: string, bottom: string): void {
    this.#show('background', (viewer) => viewer.set_background(unitColour(top), unitColour(bottom)));
  }

  /** `shade`: of the surface alone. If this throws, everything is shown as before. */
  setMesh(
    surface: DrawnSurface,
    shade: Shade | null,
    scenery: readonly DrawMesh[],
    appearance: Appearance | null,
  ): void {
    const picture = this.#picture;
    const before = new Map(picture.layers);
    const { materials, images } = appearance ?? NO_APPEARANCE;
    try {
      this.#show('materials', (viewer) => viewer.set_materials([...materials], images));
      this.#show('surface', (viewer) => {
        const { discs, ...joined } = surface;
        viewer.set_surface(discs && this.#isJoined ? joined : surface, shade);
      });
      for (const layer of CLEARED_BY_SURFACE) picture.layers.delete(layer);
      [picture.edges, picture.fields, picture.inside, picture.otherInside] = [NO_EDGES, NO_FIELDS, null, null];
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

  /** Whether the surface that joins points is drawn in the place of these. */
  set joined(isJoined: boolean) {
    if (isJoined === this.#isJoined) return;
    this.#isJoined = isJoined;
    this.#redraw();
  }

  setScenery(parts: readonly DrawMesh[]): void {
    this.#show('scenery', (viewer) => viewer.set_scenery([...parts]));
  }

  /** Lays something on the surface, through which it is seen; null: nothing. */
  setPatches(patches: Patches | null): void {
    if (!patches && !this.#picture.layers.has('patches')) return;
    const { mesh, materials, images } = patches ?? { mesh: {}, materials: [], images: [] };
    this.#show('patches', (viewer) => viewer.set_patches({ ...NO_MESH, ...mesh }, materials, images));
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
    if (!this.#picture.layers.has('surface')) this.use((viewer) => viewer.set_surface(NO_MESH, null));
    this.#redraw();
  }

  get #isPreview(): boolean {
    return this.#drawn !== this.#picture;
  }

  #redraw(): void {
    this.use((viewer) => this.replay(viewer));
  }

  /** Null where there is none. */
  setField(field: ShownField | null): void {
    this.#showFields({ ...this.#picture.fields, field });
  }

  /** Another field of the same mesh, right of the split, and what is seen of it inside of tetrahedra; null: none. */
  setOther(other: ShownField | null, inside: InnerView | null): void {
    if (other !== this.#picture.fields.other) this.#showFields({ ...this.#picture.fields, other });
    if (inside === this.#picture.otherInside) return;
    this.#picture.otherInside = inside;
    this.#show('otherInside', (viewer) => viewer.set_other_inside(inside?.section, inside?.shells));
  }

  /** Both in colors up to the larger of their largest values. */
  #showFields(fields: Fields): void {
    this.#picture.fields = fields;
    const field = asDrawn(fields.field ?? NO_FIELD);
    const other = asDrawn((fields.field && fields.other) ?? NO_FIELD);
    const most = Math.max(field.maxDistance, other.maxDistance);
    this.painted = { ...this.painted, most };
    this.#show('field', (viewer) => {
      viewer.set_field(field.distance, field.tangents, most, field.byCorner);
      viewer.set_other_field(other.distance, other.tangents, other.byCorner);
    });
  }

  /** What is seen of the inside of tetrahedra, where planes of four numbers each cut them open; null: nothing. */
  setInside(inside: InnerView | null, planes: readonly number[]): void {
    if (!inside && !this.#picture.inside) return;
    this.#picture.inside = inside;
    const { places, vectors } = inside?.arrows ?? NO_ARROWS;
    const cut = Float32Array.from(inside ? planes : []);
    this.#show('inside', (viewer) => {
      viewer.set_cut(cut);
      viewer.set_section(inside?.section, inside?.hidesSurface ?? false);
      viewer.set_shells(inside?.shells, SHELL_OPACITY);
      viewer.set_inner_arrows(places, vectors);
    });
  }

  /** Tints the triangles of the surface, `#F × 4`: see `Viewer.set_tints`. `surface`: as it was set. */
  setTints(surface: DrawnSurface, tints: Uint8Array): void {
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
    this.use((viewer) => viewer.set_brush(x, y, z, brush?.radius ?? 0));
  }

  /** `whole`: the value that periods are shares of; `facing`: the camera's yaw that the surroundings are made for. */
  setStyle(style: Style, whole: number, facing: number): void {
    const period = style.period * whole;
    this.painted = { ...this.painted, period };
    const uses = (map: MapName) => style.maps.includes(map);
    this.#show('surroundings', (viewer) =>
      viewer.set_environment(style.surroundings, facing + (style.light * Math.PI) / 180),
    );
    this.#show('style', (viewer) => {
      viewer.set_ramps(rampBytes(style));
      viewer.set_finish(uses('colour') ? 1 : 0, finishOf(style.surface), finishOf(stripeFinish(style)));
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
    this.painted = { ...this.painted, offset: periods };
    this.#show('offset', (viewer) => viewer.set_offset(periods));
  }

  setPins(places: readonly Place[], selected: number): void {
    const positions = Float32Array.from(places.flatMap(({ position }) => position));
    const normals = Float32Array.from(places.flatMap(({ normal }) => normal));
    this.#show('pins', (viewer) => viewer.set_pins(positions, normals, selected));
  }

  setPath(path: DrawPath | null): void {
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

  /** `#walkers × 10`, as `Queries.stepCrowd` gives them. */
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

  orbit(dx: number, dy: number): void {
    this.use((viewer) => viewer.orbit(dx, dy));
  }

  /** The pointer takes hold to orbit. */
  hold(): void {
    this.use((viewer) => viewer.begin_orbit());
  }

  /** The pointer lets go; the camera glides on or stops. */
  letGo(glides: boolean): void {
    this.use((viewer) => viewer.end_orbit(glides));
  }

  /** Turns by itself, in radians a second; 0 stops. */
  /** Whether lines of sight are parallel. */
  set orthographic(isOrthographic: boolean) {
    this.#show('lens', (viewer) => viewer.set_orthographic(isOrthographic));
  }

  set spin(spin: number) {
    this.#show('spin', (viewer) => viewer.set_spin(spin));
  }

  pan(dx: number, dy: number): void {
    this.use((viewer) => viewer.pan(dx, dy));
  }

  zoom(factor: number): void {
    this.use((viewer) => viewer.zoom(factor));
  }

  focus(position: Vector): void {
    if (!this.#isPreview) this.use((viewer) => viewer.focus(...position, !reducedMotion()));
  }

  /** `x`, `y` in CSS pixels of the window. Nothing is hit while a preview is drawn. */
  pick(x: number, y: number): PointHit | null {
    if (this.#isPreview) return null;
    const hit = this.use((viewer) => viewer.pick(...this.toCanvas(x, y)));
    if (!hit) return null;
    const [weights, position] = [vectorAt(hit.weights, 0), vectorAt(hit.point, 0)];
    const { triangle, is_on_section: isOnSection } = hit;
    hit.free();
    const section = isOnSection ? this.#picture.inside?.section : undefined;
    return { point: section ? innerPoint(section, triangle, weights) : { face: triangle, weights }, position };
  }

  /** The pin whose ball is seen under a pixel of the window, or within `slack` pixels; −1 for none. */
  pinAt(x: number, y: number, slack: number): number {
    if (this.#isPreview) return -1;
    return this.use((viewer) => viewer.pick_pin(...this.toCanvas(x, y), slack)) ?? -1;
  }

  /** CSS pixels of the window; null behind the camera and while a preview is drawn. */
  project(position: Vector): [number, number] | null {
    if (this.#isPreview) return null;
    const [x, y] = this.use((viewer) => viewer.project(...position)) ?? [];
    return x === undefined || y === undefined ? null : this.toWindow(x, y);
  }

  /** What is shown, drawn `scale` times as large; without the background when `clear`. RGBA rows from the top. */
  async capture(scale: number, clear: boolean): Promise<ImageData> {
    this.resolution.value = 1;
    const picture = this.use((viewer) => {
      this.prepare(viewer);
      return viewer.capture(scale, clear);
    });
    if (!picture) throw new Failure(t('There is no scene to save as an image yet.'));
    const { width, height } = picture;
    for (const since = performance.now(); !picture.is_ready();) {
      if (performance.now() - since > CAPTURE_MS)
        throw new Failure(t('The graphics device could not read the image back. Try a smaller one.'));
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
    return new ImageData(new Uint8ClampedArray(picture.into_pixels()), width, height);
  }

  #show(layer: Layer, apply: (viewer: Viewer) => void): void {
    const isCommon = COMMON.has(layer);
    if (WITH_FRAME.has(layer)) this.#awaited.add(layer);
    else if (isCommon || !this.#isPreview) this.use(apply);
    this.#picture.layers.set(layer, apply);
    if (isCommon) this.#drawn.layers.set(layer, apply);
  }
}

/** A place on the section as one in its tetrahedron. */
function innerPoint(section: InnerView['section'], triangle: number, shares: Vector): MeshPoint {
  const { mesh, tetrahedra, weights } = section;
  const vertexAt = (i: number) => entry(mesh.triangles, 3 * triangle + i);
  const at = (corner: number) =>
    shares.reduce((sum, share, i) => sum + share * entry(weights, 4 * vertexAt(i) + corner), 0);
  return { tetrahedron: entry(tetrahedra, triangle), weights: [at(0), at(1), at(2), at(3)] };
}

/** With distances in the middles of edges, where they are known. */
function asDrawn(field: ShownField): ShownField {
  return { ...field, ...field.finer };
}

function finishOf({ metalness, roughness, glow }: Finish): Float32Array {
  return Float32Array.of(metalness, roughness, glow);
}

function unitColour(css: string): Float32Array {
  return Float32Array.from(parseColour(css), (value) => value / 255);
}
