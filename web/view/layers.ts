/** What a picture is made of, and the order in which the renderer needs it. */
import type { Appearance, DistanceField, DrawMesh, InnerView, Material } from '../protocol';
import type { Viewer } from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';

/** What is painted: values of drawn vertices and where they grow, as in a `DistanceField`. */
export type ShownField = Pick<DistanceField, 'distance' | 'tangents' | 'byCorner' | 'finer'> & { maxDistance: number };

/** Segments, #E × 2 × 3, their CSS colour, and their width in CSS pixels, a thin line's when left out. */
export interface Edges {
  ends: Float32Array;
  colour: string;
  width?: number;
}

export const THIN = 1.2;

/** Around curves and places, so that they are seen on every color: dark, and light around that. */
export const RIM = '#101418';
export const HALO = '#ffffff';

/** A curve in all three; `share` of the rims of a wide one. */
export function rimmed(line: Required<Edges>, share = 1): Edges[] {
  return [
    { ...line, colour: HALO, width: line.width + 4.5 * share },
    { ...line, colour: RIM, width: line.width + 2.5 * share },
    line,
  ];
}

/** What lines are shown for, in the order in which they are drawn: overlays, borders of cells, offsets of curves, loops around handles, a loop and a Bézier curve of the sources, walls and sets of sources, the other path, girths, tapes. */
export const EDGE_GROUPS = [
  'overlays',
  'cells',
  'offsets',
  'loops',
  'loop',
  'bezier',
  'lines',
  'path',
  'girth',
  'tapes',
] as const;
export type EdgeGroup = (typeof EDGE_GROUPS)[number];
export const NO_EDGES: Picture['edges'] = {
  overlays: [],
  cells: [],
  offsets: [],
  loops: [],
  loop: [],
  bezier: [],
  lines: [],
  path: [],
  girth: [],
  tapes: [],
};

/** What has places on the surface, or values of its vertices. */
const ON_SURFACE = [
  'field',
  'patches',
  'inside',
  'otherInside',
  'pins',
  'path',
  'walker',
  'crowd',
  'arrows',
  'edges',
] as const;
/** The order in which the parts of a picture must be given: the surface clears what depends on it. */
export const ORDER = [
  'background',
  'materials',
  'surface',
  'scenery',
  'pose',
  'ground',
  'surroundings',
  'lights',
  'style',
  'offset',
  ...ON_SURFACE,
  'lens',
  'spin',
] as const;
export type Layer = (typeof ORDER)[number];
export const CLEARED_BY_SURFACE: readonly Layer[] = ['pose', 'ground', ...ON_SURFACE];
/** What answers bring, several of them while one frame is drawn: given to the renderer with the frame that shows it. */
export const WITH_FRAME: ReadonlySet<Layer> = new Set(['offset', 'field', 'pins', 'path', 'walker', 'crowd', 'arrows']);
/** What a preview has from the scene that it stands before. */
export const COMMON: ReadonlySet<Layer> = new Set(['background', 'spin']);

/** What lies on the surface, in materials of its own. */
export interface Patches {
  mesh: Omit<DrawMesh, 'order' | 'boxes'>;
  materials: Material[];
  images: ImageBitmap[];
}

export interface Fields {
  field: ShownField | null;
  other: ShownField | null;
}
export const NO_FIELDS: Fields = { field: null, other: null };

/** All that is shown together. */
export interface Picture {
  layers: Map<Layer, (viewer: Viewer) => void>;
  /** Drawn length of a unit of the path. */
  stride: number;
  edges: Readonly<Record<EdgeGroup, readonly Edges[]>>;
  /** The field, and the one that it is compared with. */
  fields: Readonly<Fields>;
  /** What is seen of the inside of tetrahedra, and by the other field. */
  inside: InnerView | null;
  otherInside: InnerView | null;
}

export const NO_MESH = {
  positions: new Float32Array(),
  normals: new Float32Array(),
  triangles: new Uint32Array(),
  order: new Uint32Array(),
  boxes: new Float32Array(),
  texcoords: new Float32Array(),
  colors: new Uint16Array(),
  runs: new Uint32Array(),
};
export const NO_APPEARANCE: Appearance = { materials: [], images: [] };
export const NO_FIELD: ShownField = {
  distance: new Float32Array(),
  tangents: new Int8Array(),
  maxDistance: 0,
  byCorner: false,
};
export const NO_ARROWS: InnerView['arrows'] = { places: new Float32Array(), vectors: new Float32Array() };
export function emptyPicture(): Picture {
  return { layers: new Map(), stride: 1, edges: NO_EDGES, fields: NO_FIELDS, inside: null, otherInside: null };
}
