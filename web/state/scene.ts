/** The state of the page. The panel, the link, undo and the renderer all derive from it. */
import type { IsolineWish, OpenedMesh, PathKind, SceneryPart, Source, MeshPoint } from '../protocol';
import {
  AUTOMATIC,
  DEFAULT_PARAMETERS,
  DEFAULT_WINDOWS,
  PATH_KIND,
  type Up,
  VERTEX_FIELD,
  type VertexField,
} from '../wasm/contract';
import { type Ground, LEVEL } from './ground';
import { type CutPlane, type Inside, WHOLE } from './inside';
import type { Compared } from './compared';
import type { Decal } from './decals';
import type { Units } from '../length';
import type { Settings } from './settings';
import { type SourceSet, UNCHOSEN } from './sources';
import type { Tape } from './tapes';
import { DEFAULT_STYLE, type Style } from './styles';

/** `hash`: SHA-256 of the file of the mesh. `path`: of the mesh in an archive at the address, else empty. */
export type MeshReference =
  | { kind: 'preset'; id: string }
  | { kind: 'file'; name: string; hash: string }
  | { kind: 'address'; address: string; path: string; hash: string };

export const OVERLAYS = [
  'scenery',
  'joined',
  'edges',
  'boundary',
  'contacts',
  'operator',
  'isolines',
  'cells',
  'curves',
  'loops',
  'loop',
  'bezier',
  'carried',
  'heat',
  'distance',
] as const;
/**
 * The inactive parts; the surface that joins the points of a cloud, in the place of these; edges of the mesh, boundary edges, places
 * where components meet, edges of the operator's triangles; curves of equal distance at the period of the stripes; what is nearest to
 * each source; the distance from curves with its sign; loops around handles;
 * a closed curve through the sources, and the Bézier curve that they control; arrows of a direction at the sources that is carried
 * over the surface; arrows along the gradients of heat and of distance.
 */
export type Overlay = (typeof OVERLAYS)[number];

/** What only the heat method has to show. */
export const OF_HEAT: { readonly overlays: readonly Overlay[]; readonly colorBy: readonly VertexField[] } = {
  overlays: ['operator', 'heat'],
  colorBy: ['heat'],
};

/**
 * Which components are joined, so that distance and paths lead from one to the other: those that pierce or nearly touch each
 * other, none, or those no farther apart than so much, in the unit of the file.
 */
export type Bridge = 'auto' | 'off' | number;

/** Which animation of the file is shown, and how. */
export interface Animation {
  /** Its number; null: the mesh stands as in its file. */
  clip: number | null;
  /** Where it stands, or begins to play; from the beginning of the animation. */
  seconds: number;
  plays: boolean;
  /** Times as fast as the file says. */
  speed: number;
  /** Whether it begins again at its end. */
  loops: boolean;
  /** Whether distance is measured in each pose; else that of the pose in the file is shown. */
  live: boolean;
}

/** The least and the greatest speed. */
export const SPEEDS = [0.1, 4] as const;

export const STILL: Animation = { clip: null, seconds: 0, plays: false, speed: 1, loops: true, live: false };

/** Those of the style, or those of the file where it has some. */
export const LIGHTS = ['style', 'file'] as const;

/** Triangles that a mesh can be simplified to: from a shape that can be recognised to more than fit. */
export const TRIANGLES = [100, 100_000_000] as const;

/** Degrees. */
export const HEADINGS = [-180, 180] as const;

export const LARGEST_CROWD = 10_000;

/** Height of a walker of the crowd in bounding radii of the surface: seen from afar, and small enough for thousands. */
export const CROWD_HEIGHT = 0.03;

export interface SceneState extends Settings, Units {
  mesh: MeshReference;
  /** Indices of the active parts; empty: all. */
  parts: readonly number[];
  /** A mesh of more triangles is simplified to this number; null: it is as in its file. */
  triangles: number | null;
  /** What the surface encloses is filled with about this number of tetrahedra; null: with none. */
  fill: number | null;
  /** As `Viewer.camera` gives it; null until the user has moved it. */
  camera: readonly number[] | null;
  /** Whether lines of sight are parallel; else in perspective. */
  orthographic: boolean;
  animation: Animation;
  /** Indices of the parts that are hidden; active parts are always shown. */
  hidden: readonly number[];
  sources: readonly Source[];
  /** Sources that are many places each. */
  sets: readonly SourceSet[];
  /** Where the walker starts; null: no walker. Undefined: the mesh that is to be opened says. */
  walker: MeshPoint | null | undefined;
  /** How many links there are between groups that stay apart, each time of the two that are nearest. */
  links: number;
  /** The axis of the file that points up where it is drawn; automatic: by its format or its shape. */
  up: Up | typeof AUTOMATIC;
  /** What is measured. */
  tapes: readonly Tape[];
  /** The plane in whose curves the girth is measured; null: it is not. */
  girth: CutPlane | null;
  /** Images on the surface. */
  decals: readonly Decal[];
  /** What it costs to walk where, and walls. */
  ground: Ground;
  /** How the inside of tetrahedra is looked into. */
  inside: Inside;
  /** At which distances isolines are drawn and measured; null: at the stripes. */
  isolines: IsolineWish | null;
  /** What the scene is compared with; null: with nothing. */
  compared: Compared | null;
  bridge: Bridge;
  /** The kind of path that the walker takes. */
  pathKind: PathKind;
  style: Style;
  /** Whose lights are on. */
  lights: (typeof LIGHTS)[number];
  /** The field that the surface is colored by. */
  colorBy: VertexField;
  /** What is drawn in addition. */
  overlays: readonly Overlay[];
  /** Of arrows that are carried from the sources: degrees counterclockwise from upright, seen from outside. */
  heading: number;
  /** Number of walkers in the crowd. */
  crowd: number;
  /** Index into `sources` and, after these, `sets`; −1 for none. Belongs to the moment, so the link leaves it out. */
  selected: number;
}

export function emptyScene(mesh: MeshReference): SceneState {
  return {
    mesh,
    parts: [],
    triangles: null,
    fill: null,
    sources: UNCHOSEN,
    sets: [],
    walker: undefined,
    links: 0,
    up: 'y',
    unit: AUTOMATIC,
    scale: 1,
    shownUnit: null,
    tapes: [],
    girth: null,
    decals: [],
    ground: LEVEL,
    inside: WHOLE,
    isolines: null,
    compared: null,
    method: 'heat',
    windows: DEFAULT_WINDOWS,
    parameters: DEFAULT_PARAMETERS,
    bridge: 'auto',
    pathKind: PATH_KIND.default,
    refine: true,
    camera: null,
    orthographic: false,
    lights: 'style',
    animation: STILL,
    style: DEFAULT_STYLE,
    colorBy: VERTEX_FIELD.default,
    hidden: [],
    overlays: ['scenery'],
    heading: 0,
    crowd: 0,
    selected: -1,
  };
}

/** Whether a field at rest is made exact. */
export function isRefined({ method, refine }: Pick<SceneState, 'method' | 'refine'>): boolean {
  return method === 'exact' || (refine && method !== 'propagation');
}

/** The axis that is to be drawn upward of a mesh that by itself has `upright` there. */
export function upOf({ up }: Pick<SceneState, 'up'>, upright: Up): Up {
  return up === AUTOMATIC ? upright : up;
}

/** Whether paths may lead from one component to another, or across a crack between boundaries of one. */
export function mayBeJoined({ report, interior }: OpenedMesh): boolean {
  return interior === null && (report.components > 1 || report.boundaryLoops > 0);
}

/** The inactive parts that are shown. */
export function visible(scenery: readonly SceneryPart[], { overlays, hidden }: SceneState): SceneryPart[] {
  if (!overlays.includes('scenery')) return [];
  return scenery.filter(({ part }) => !hidden.includes(part));
}
