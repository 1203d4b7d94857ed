/** Shows a scene and the solver's answer to it on the view, and moves what moves by itself. */
import type { DistanceField, DrawMesh, OpenedMesh, Posed, SceneryPart, DrawPath } from '../protocol';
import { isPainted } from '../state/ground';
import { innerCutOf } from '../state/inside';
import type { Scene } from '../state/history';
import { type SceneState, visible } from '../state/scene';
import { type Style, telling } from '../state/styles';
import { reducedMotion } from '../view/motion';
import type { ShownField } from '../view/layers';
import type { View } from '../view/view';
import { Walk } from '../view/walk';
import { curvesOf } from './curves';
import { wholeOfDistance } from './period';
import type { OpenRequest, Shown } from './prepare';
import type { Painted } from './stripes';
import { costAlong, tintsOf, wallsOf } from './tints';

/** A pose that is shown for longer is one to rest in. */
const POSE_RESTS_MS = 300;

const NO_LIGHTS = new Float32Array();

export class Presenter {
  readonly walk = new Walk();
  readonly #scene: Scene;
  readonly #view: View;
  /** The scene's mesh and answer. */
  #shown: Shown | null = null;
  /** How far tetrahedra are apart in what is shown. */
  #gap = 0;
  /** The mesh that is on the view in the place of the scene, and the camera to come back to. */
  #previewed: { opened: OpenedMesh; camera: readonly number[] | null } | null = null;
  #state: SceneState;
  /** The field shown, of distance. */
  #field: DistanceField | null = null;
  /** What the period of the style is a share of: for distance, the diameter. */
  #whole = 1;
  /** What is painted: that field, or another one. */
  #painted: ShownField | null = null;
  /** Whether another field than that of distance is painted. */
  #isOther = false;
  /** The pose that the mesh is shown in; null: that of its file. */
  #posed: Posed | null = null;
  #resting: ReturnType<typeof setTimeout> | undefined;
  /** Yaw that the light is set up for, radians. */
  #facing = 0;
  /** How far the stripes have moved, in periods. */
  #flow = 0;

  constructor(scene: Scene, view: View) {
    this.#scene = scene;
    this.#view = view;
    this.#state = scene.state;
    scene.subscribe((state) => this.#follow(state));
  }

  /**
   * Draws a mesh without an answer in the place of the scene, which goes on behind it until `replace` or `endPreview`. If
   * this throws, the scene is shown as before.
   */
  preview(opened: OpenedMesh, { state, view: from }: OpenRequest): void {
    const { camera } = this.#view;
    this.#view.preview(() => {
      this.#showMesh(opened, state);
      this.#view.setStyle(state.style, 1, from?.[0] ?? this.#facing);
    });
    this.#previewed = { opened, camera };
    this.#look(state, from);
  }

  /** Shows the scene again, if a mesh is drawn in its place. */
  endPreview(): void {
    if (!this.#previewed) return;
    const { camera } = this.#previewed;
    this.#previewed = null;
    this.#view.endPreview();
    if (camera) this.#view.camera = camera;
  }

  /**
   * Shows another mesh; one that is drawn already stays as the user has turned it. Where the view cannot take it, it is
   * started anew with what it showed before, and the reason is thrown.
   */
  replace(shown: Shown, state: SceneState, from: OpenRequest['view']): void {
    const previewed = this.#previewed?.opened === shown.opened ? this.#previewed : null;
    const { camera } = previewed ?? this.#view;
    const before = { shown: this.#shown, state: this.#state, facing: this.#facing, camera, posed: this.#posed };
    this.#previewed = null;
    this.#posed = null;
    try {
      if (previewed) this.#view.adoptPreview();
      else this.#showMesh(shown.opened, state);
      this.#showRest(shown, state, from?.[0] ?? this.#facing, 0);
      if (!previewed) this.#look(state, from);
    } catch (error) {
      // One that is not being replaced already has seen half of it. The next one is given what was shown.
      if (this.#view.backend.value !== null) void this.#view.start();
      if (before.shown) {
        this.#showMesh(before.shown.opened, before.state);
        this.#showRest(before.shown, before.state, before.facing, this.walk.arc);
        if (before.posed) this.pose(before.posed);
      }
      if (before.camera) this.#view.camera = before.camera;
      throw error;
    }
    clearTimeout(this.#resting);
    this.walk.follow(shown.answer.path?.length ?? 0, true, costAlong(shown.answer.path));
  }

  /** Shows the mesh in another pose, and with it what is on it. */
  pose(posed: Posed): void {
    const shown = this.#shown;
    if (!shown) return;
    this.#posed = posed;
    this.#showPose(false);
    // Only a pose that stays is worth what the rest takes.
    clearTimeout(this.#resting);
    this.#resting = setTimeout(() => this.#showPose(true), POSE_RESTS_MS);
    shown.places.pose(posed.surface);
    this.#showLines(shown);
    this.#showPins();
    if (shown.answer.path && posed.path) this.#showPath(posed.path, this.walk.arc);
  }

  /** Shows another answer for the same mesh; its path replaces the one shown if `withPath`. */
  answer(shown: Shown, fromStart: boolean, withPath: boolean): void {
    this.#showField(shown);
    if (!withPath) return;
    this.walk.follow(shown.answer.path?.length ?? 0, fromStart, costAlong(shown.answer.path));
    this.#showPath(shown.answer.path, this.walk.arc);
  }

  /** Paints another field in the place of distance, with periods as shares of `whole`; null for distance itself. */
  paint(instead: { field: ShownField; whole: number } | null): void {
    this.#painted = instead?.field ?? this.#field;
    this.#view.setField(this.#painted);
    const whole = instead?.whole ?? (this.#shown ? wholeOfDistance(this.#shown) : 1);
    const isOther = instead !== null;
    if (whole !== this.#whole || isOther !== this.#isOther) {
      [this.#whole, this.#isOther] = [whole, isOther];
      this.#showStyle();
    }
  }

  /** The surface as it is painted; null without a field. */
  get painted(): Painted | null {
    const surface = this.#shown?.opened.surface;
    if (!surface || !this.#painted) return null;
    const pose = this.#posed?.surface ?? surface;
    return { surface, pose, field: this.#painted, style: this.#styleNow(), ...this.#view.painted };
  }

  #styleNow(): Style {
    const { style } = this.#state;
    return this.#isOther ? telling(style) : style;
  }

  /** Takes what moves by itself further. */
  animate(seconds: number): void {
    const still = reducedMotion();
    const diameter = this.#shown?.places.diameter ?? 1;
    if ((!still || this.walk.performs) && this.walk.advance(seconds, diameter)) this.#view.setWalker(this.walk.arc);
    const { flow } = this.#scene.state.style;
    if (flow !== 0 && !still && !this.walk.paused) {
      this.#flow = (this.#flow + seconds * flow) % 1;
      this.#showOffset();
    }
  }

  #look(state: SceneState, from: OpenRequest['view']): void {
    if (state.camera) {
      this.#view.camera = state.camera;
    } else if (from) {
      this.#view.camera = [...from, 3, 0, 0, 0];
      this.#view.frame();
    }
  }

  #showMesh({ surface, shade, scenery, appearance, lights }: OpenedMesh, state: SceneState): void {
    this.#view.joined = state.overlays.includes('joined');
    this.#view.setMesh(surface, shade, meshesOf(visible(scenery, state)), appearance);
    this.#showLights(lights, state);
    this.#view.orthographic = state.orthographic;
  }

  #showLights(ofFile: Float32Array, { lights }: SceneState): void {
    this.#view.setLights(lights === 'file' ? ofFile : NO_LIGHTS);
  }

  #showPose(rests: boolean): void {
    if (!this.#posed || !this.#shown) return;
    const { surface, scenery } = this.#posed;
    const parts = visible(this.#shown.opened.scenery, this.#state);
    const placed = scenery.map(({ part, pose }) => [parts.findIndex((other) => other.part === part), pose] as const);
    this.#view.setPose(
      surface,
      placed.filter(([index]) => index >= 0),
      rests,
    );
  }

  #showRest(shown: Shown, state: SceneState, facing: number, arc: number): void {
    this.#state = state;
    this.#facing = facing;
    this.#whole = shown.places.diameter;
    this.#isOther = false;
    this.#showStyle();
    this.#showGround(shown, state, true);
    this.#showField(shown);
    this.#showPath(shown.answer.path, arc);
    this.#showPins();
  }

  #showField(shown: Shown): void {
    this.#shown = shown;
    this.#field = shown.answer.field;
    if (this.#state.colorBy === 'distance') this.paint(null);
    this.#showInside(shown);
  }

  #showInside({ answer: { inside, question }, places }: Shown): void {
    const { gap } = question.inside;
    this.#view.setInside(inside, innerCutOf(question.inside, places.box)?.planes ?? []);
    // What is pulled apart takes more room, or less again. Whoever has moved the camera keeps the view.
    if (gap !== this.#gap && !this.#state.camera) this.#view.frame();
    this.#gap = gap;
  }

  #showPath(path: DrawPath | null, arc: number): void {
    this.#view.setPath(path);
    if (path) this.#view.setWalker(arc);
  }

  #follow(state: SceneState): void {
    const previous = this.#state;
    this.#state = state;
    if (!this.#shown || state === previous) return;
    if (state.style !== previous.style) this.#showStyle();
    if (state.orthographic !== previous.orthographic) this.#view.orthographic = state.orthographic;
    if (state.overlays !== previous.overlays) this.#view.joined = state.overlays.includes('joined');
    if (state.lights !== previous.lights) this.#showLights(this.#shown.opened.lights, state);
    if (state.ground !== previous.ground) this.#showGround(this.#shown, state, isPainted(previous.ground));
    if (state.sources !== previous.sources || state.selected !== previous.selected) this.#showPins();
    const hasSets = state.sets.length > 0 || previous.sets.length > 0;
    if (hasSets && (state.sets !== previous.sets || state.selected !== previous.selected)) this.#showLines(this.#shown);
    this.#showScenery(state, previous);
  }

  /** `isAnew`: also where there is nothing to show any more. */
  #showGround(shown: Shown, { ground }: SceneState, isAnew: boolean): void {
    if (!isAnew && !isPainted(ground)) return;
    const { surface } = shown.opened;
    if (isPainted(ground) || this.#view.isTinted) this.#view.setTints(surface, tintsOf(ground, surface));
    this.#showLines(shown);
  }

  /** Walls along edges, and sets of sources. */
  #showLines({ places }: Shown): void {
    const { ground, sources, sets, selected } = this.#state;
    const curves = curvesOf(sets, sets[selected - sources.length], places);
    this.#view.setEdges('lines', [...wallsOf(ground, places), ...curves]);
  }

  #showStyle(): void {
    this.#view.setStyle(this.#styleNow(), this.#whole, this.#facing);
    if (this.#state.style.flow === 0) this.#flow = 0;
    this.#showOffset();
  }

  #showOffset(): void {
    this.#view.setOffset(this.#state.style.offset + this.#flow);
  }

  /** A new scenery is costly, so only where other parts are seen. */
  #showScenery(state: SceneState, previous: SceneState): void {
    const parts = this.#shown?.opened.scenery ?? [];
    const [now, before] = [visible(parts, state), visible(parts, previous)];
    if (now.length === before.length && now.every((part, i) => part === before[i])) return;
    this.#view.setScenery(meshesOf(now));
    this.#showPose(true);
  }

  #showPins(): void {
    const places = this.#shown?.places;
    const { sources, selected } = this.#state;
    if (!places) return;
    this.#view.setPins(
      sources.map((source) => places.at(source)).filter((place) => place !== null),
      selected,
    );
  }
}

function meshesOf(parts: readonly SceneryPart[]): DrawMesh[] {
  return parts.map(({ mesh }) => mesh);
}
