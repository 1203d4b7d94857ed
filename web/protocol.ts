/**
 * The messages between the page and the solver's worker. The worker exposes a `SolverApi` with comlink; buffers are
 * transferred, never copied. What Rust gives and takes is defined there: names, ranges and options come from the generated
 * contract, the rest from the types of the solver's module. Lengths are in the unit of the file but for those that are
 * said to be as they are drawn: see `DrawTransform`.
 */

import type { LengthUnit, ModelArea, ModelLength, ModelVolume, WithLengths } from './length';
import type { Parameters, PathKind, Stage } from './wasm/contract';
import type * as writer from './wasm/writer/heatwalk_writer';
import type * as interior from './wasm/interior/heatwalk_interior';
import type * as wasm from './wasm/solver/heatwalk_worker';

/** A place on a surface, or inside of tetrahedra. */
export type MeshPoint = wasm.SurfacePoint | InnerPoint;
export type InnerPoint = interior.InnerPoint;

/** A place that distance is measured from. */
export type Source = MeshPoint & Pick<wasm.Source, 'offset'>;

/** What becomes of the ground; see `SolverApi.ground`. */
export interface GroundChange {
  triangles: Uint32Array;
  /** One a triangle; Infinity for walls. */
  costs: Float64Array;
  /** How many vertices of the input a wall goes through, these, and so on. */
  lines: Uint32Array;
  /** Whether slopes cost what Tobler's hiking function says. */
  slope: boolean;
  /** What it costs at the highest place, as a multiple of the lowest. */
  highest: number;
}

/** A file of the user. `path` begins with the folder that was opened, if any: `model/scene.bin`. */
export interface InputFile {
  path: string;
  content: Blob;
}

/**
 * What to open. Of files and archives, the mesh at the path `mesh`; what it refers to is looked for beside it. `positions` is
 * #V × 3, `triangles` #F × 3. `tetrahedra`: a shape of these.
 */
export type MeshInput =
  | { kind: 'files'; mesh: string; files: readonly InputFile[] }
  | { kind: 'archive'; mesh: string; archive: Blob }
  | { kind: 'shape'; shape: string }
  | { kind: 'tetrahedra'; shape: string }
  | { kind: 'arrays'; name: string; positions: Float32Array; triangles: Uint32Array };

export type { EdgeKind, FaceField, Parameters, PathKind } from './wasm/contract';
export type InnerCut = interior.InnerCut;

/** What must fit into memory beside a mesh. */
export interface MemoryBudget {
  /** Windows of each half-edge; 0 where the mesh is factored, which checks its own memory. */
  windows: number;
  /** Most memory, in MiB; that of the browser where it is chosen automatically. */
  memory: Parameters['memory'];
}

export type DrawTransform = wasm.DrawTransform;
export type DrawMesh = wasm.DrawMesh;
/** Places on drawn triangles. */
export interface TrianglePlaces {
  /** #P. */
  triangles: Uint32Array;
  /** #P × 3. */
  weights: Float64Array;
}

/** Where distances are drawn on a coarse surface that is divided. */
export interface FinerPlaces {
  /** #E: the middles of edges. */
  middles: TrianglePlaces;
  /** Corners of parts, those of one triangle once each. */
  corners: TrianglePlaces;
  /** #T × 3: which of these each corner is. */
  ofCorners: Uint32Array;
}

/** The surface as it is drawn; where it is coarse, also divided; of a cloud also the points. */
export type DrawnSurface = DrawMesh & { finer?: FinerMesh; discs?: Discs };

/** The points of a cloud as discs, one after another, of each its middle first and then its rim. */
export interface Discs {
  /** The middle of a disc is the first corner of all of its triangles. */
  mesh: DrawMesh;
  /** #D: the triangle of the surface where each vertex lies. */
  triangles: Uint32Array;
  /** #D × 3: the weights of the corners of that triangle there. */
  weights: Float32Array;
}

/** A coarse surface divided, so that what is drawn within its triangles can follow the distance. */
export interface FinerMesh {
  /** The drawn vertices of the surface and after them the middles of edges; its triangles are parts of the surface's, in their order. */
  mesh: DrawMesh;
  /** #E × 2: the ends of the edges, each before its middle. */
  middles: Uint32Array;
  /** #T: the triangle of the surface that each is part of. */
  origins: Uint32Array;
  /** #T × 3 × 3: of each corner, the weights of the corners of that triangle there. */
  weights: Float32Array;
}
export type Shade = wasm.Shade;
export type Material = wasm.Material;
export type BuildReport = WithLengths<wasm.BuildReport, 'crackWidth'>;
/** `cost`: the length of as dear a path where a unit of it costs 1. */
export type DrawPath = WithLengths<wasm.DrawPath, 'length' | 'straight' | 'cost'>;
/** A path between two places: on a surface, where it can be drawn in any pose, or inside of tetrahedra. */
export type Leg = SurfaceLeg | DrawPath;
export type SurfaceLeg = WithLengths<wasm.Leg, 'length' | 'straight' | 'cost'>;
export type Enclosure = WithLengths<wasm.Enclosure, never, 'area'>;
/** Curves, one after another, in the unit and the axes of the file. */
export type Tracks = wasm.Tracks;
export type Convergence = wasm.Convergence;

/** A moment of an animation: its number, and seconds from its beginning. */
export interface Moment {
  clip: number;
  seconds: number;
}

export type Clip = wasm.Clip;
export type CameraView = wasm.CameraView;
export type DrawPose = wasm.DrawPose;

/** A mesh as it stands at a moment. */
export interface Posed {
  surface: DrawPose;
  /** The inactive parts that move. */
  scenery: { part: number; pose: DrawPose }[];
  /** The path that was traced last, as it lies there; null where there is none, or distances are measured in another pose since. */
  path: DrawPath | null;
}

export interface Timings {
  readMs: number;
  /** Welding and connectivity, and what windows need of it where nothing is factored. */
  buildMs: number;
  /** Making the triangles ready to be drawn. */
  drawMs: number;
  /** Finding where components meet; 0 where that was not asked for. */
  joinMs: number;
  /** Factoring; 0 where nothing is factored. */
  precomputeMs: number;
}

/** What is ready to be asked, and what that cost. */
export interface Factoring extends WithLengths<wasm.Joined, 'crackGap' | 'linkedGap'> {
  timings: Timings;
  /** Stored entries of all Cholesky factors together. */
  factorNonzeros: number;
  /** Bytes of wasm memory in use. */
  memoryBytes: number;
}

export interface SceneryPart {
  /** Its index in `OpenedMesh.parts`. */
  part: number;
  mesh: DrawMesh;
}

/** What a mesh was before it was simplified, and how far it is from that. */
export interface Simplified {
  /** Triangles of the file. */
  triangles: number;
  /** What the simplifier says of the distance between both, in the unit of the file. */
  error: ModelLength;
  /** Of the box around the mesh, in that unit. */
  diagonal: ModelLength;
}

/** The tetrahedra of a mesh whose boundary is drawn, counted as in the input. */
export interface Interior {
  /** #V × 3, as they are drawn. */
  positions: Float32Array;
  /** #T × 4, corners. */
  tetrahedra: Uint32Array;
  report: InnerReport;
  /** Of reading or filling, and finding neighbors. */
  madeMs: number;
}

export type InnerReport = WithLengths<Omit<interior.InnerReport, 'volume'>, 'deviation'> & { volume: ModelVolume };

/** What is drawn of the inside. */
export type InnerView = interior.InnerView;

/** How a file wants its surface to look. */
export interface Appearance {
  /** What the runs of drawn meshes name. */
  materials: Material[];
  /** What the textures of materials name; null for an image that cannot be decoded. */
  images: (ImageBitmap | null)[];
}

/** What is known of a mesh before anything is solved on it: enough to draw it. */
export interface OpenedMesh extends wasm.Contents {
  name: string;
  /** SHA-256 of the file of the mesh, hex; empty for shapes and arrays. */
  hash: string;
  /** Indices of the parts that form the surface. */
  active: number[];
  surface: DrawnSurface;
  /** Of the surface alone; null where there are other parts. */
  shade: Shade | null;
  /** Null where the file says nothing. */
  appearance: Appearance | null;
  /** The cameras of the file. */
  cameras: CameraView[];
  /** #lights × 12: its lights, as `Viewer.set_lights` takes them. */
  lights: Float32Array;
  /** Null for a mesh as it is in the file. */
  simplified: Simplified | null;
  /** Whether its vertices are the points of a file without faces, and its triangles join them. */
  isCloud: boolean;
  /** Images that the browser cannot decode, as the file calls them. */
  undecoded: string[];
  /** For each drawn vertex of the surface, its vertex index in the input (in file order, whichever parts are active). */
  inputVertices: Uint32Array;
  /** Of everything that is drawn with this mesh: surface, scenery, paths, crowd, edges. */
  drawTransform: DrawTransform;
  /** The inactive parts. */
  scenery: SceneryPart[];
  report: BuildReport;
  /** Mean edge length. */
  meanEdge: ModelLength;
  /** Null for a surface. */
  interior: Interior | null;
  /** What the file says that vertices of the input cost, under the name that it has for that; null where it says nothing. */
  weights: wasm.Weights | null;
}

export interface DistanceField extends WithLengths<
  Omit<wasm.Field, 'error' | 'inner'>,
  'maxDistance' | 'exactBelow'
> {
  /** #D × 4: the direction in which distance grows at each drawn vertex, 127 for a unit; the fourth number is 0. */
  tangents: Int8Array;
  /**
   * On the finer mesh, where they are known, and the largest of all: #D + #E, these distances and after them the exact ones at the middles;
   * or #T × 3, where values are those of corners.
   */
  finer?: Pick<DistanceField, 'distance' | 'maxDistance'>;
  /** How far the field was off before it was refined; null until refining has made all of it exact. */
  error: FieldError | null;
  /** Of tetrahedra: one value a vertex of the input, Infinity where no source can be reached; null for a surface. */
  inner: Float32Array | null;
  /** Of `solve` or `propagate` alone. */
  solveMs: number;
  /** Of all steps of refinement so far. */
  refineMs: number;
}

export type FieldError = wasm.FieldError;

/** A path that is wanted. */
export interface PathRequest {
  from: MeshPoint;
  kind: PathKind;
}

export interface TracedPath {
  /** Null where none was wanted, and where there is none: the start is on a part that no source reaches. */
  path: DrawPath | null;
  /** Of tracing alone. */
  pathMs: number;
}

/** A field and the path on it, in one message: both are shown in the same frame. */
export interface Solved extends TracedPath {
  field: DistanceField;
  /** The inside with this field, as it was asked for last; null where nothing of it is. */
  inside: InnerView | null;
}

/** What is going on while a mesh is opened; Fetching is before the worker's. */
export type OpeningStage =
  | 'Fetching'
  | 'Reading'
  | 'Simplifying'
  | 'Welding'
  | 'Drawing'
  | 'Propagating'
  | 'Marching'
  | Stage;

export interface Progress {
  stage: OpeningStage;
  /** 0 to 1 over the whole opening. */
  fraction: number;
  vertices: number;
}

/** At which distances isolines are wanted: at these, or where there are none at the multiples of a spacing; in the unit of the file. */
export interface IsolineWish {
  values: readonly ModelLength[];
  spacing: ModelLength;
}

export type IsolineRow = WithLengths<writer.IsolineRow, 'value' | 'length', 'area'>;

/** Isolines of a field. */
export interface Isolines {
  rows: readonly IsolineRow[];
  /** Whether they follow the distance itself, with lengths that are right to about a thousandth; else they are chords of triangles. */
  isTrue: boolean;
}

/** A file of isolines, of strips between them, or of these in the plane; of curves as they are seen in an SVG, whence. */
export interface CurveFile {
  kind:
    | 'obj'
    | 'dxf'
    | 'svg'
    | 'pdf'
    | 'csv'
    | 'glb'
    | 'strips.obj'
    | 'unrolled.svg'
    | 'unrolled.dxf'
    | 'unrolled.pdf';
  towardEye: readonly [number, number, number];
  /** That of all lengths in it. */
  unit: LengthUnit;
}

/** A surface with exact distances. */
export interface ExactSurface {
  /** Tells surfaces apart, by whatever distance depends on besides the sources. */
  surface: number;
  /** The rule by which components are joined, and the number of links. */
  bridge: string;
  links: number;
}

/** Which cells are wanted: of what sources, on what surface. */
export interface CellWish extends ExactSurface {
  /** Tells questions apart: the next call with the same number goes on. */
  question: number;
  /** #S and #S × 3: the places of the sources, drawn triangles and weights of their corners. */
  places: TrianglePlaces;
  /** #S: initial distances, in the unit of the file. */
  initial: Float64Array;
  /** #S: the cell of each source. */
  cells: Uint32Array;
  count: number;
}

/** Other places in the stead of some: so many, as far apart as can be; these moved once to the middles of their cells; or their mean. */
export interface SpreadWish extends ExactSurface {
  places: TrianglePlaces;
  wanted: number | 'middles' | 'mean';
}

/** Cells that were found. */
export interface FoundCells {
  /** One a cell. */
  areas: readonly ModelArea[];
  /** #segments × 2 × 3: the ends of the segments of all borders, as they are drawn. */
  ends: Float32Array;
  /** #T × 2: of the drawn triangles, divided along borders, the cell of each part and the triangle. */
  tiles: Uint32Array;
  /** #T × 3 × 3: the weights of their corners there. */
  corners: Float32Array;
}

/** Which curves distance is wanted from. */
export interface CurveWish extends ExactSurface {
  /** How many places each has, and whether it is closed: 1, or 0. */
  counts: Uint32Array;
  closed: Uint8Array;
  places: TrianglePlaces;
  /** What isolines are apart, as a share of the largest distance. */
  period: number;
}

/** Distance from curves: negative inside, which is the smaller side. */
export interface CurveDistances {
  /** #F × 3: of the corners of drawn triangles; Infinity where no curve is reached. */
  values: Float32Array;
  /** The smallest and the largest. */
  range: readonly [ModelLength, ModelLength];
  /** #segments × 2 × 3: ends of the segments of isolines on both sides, as they are drawn. */
  ends: Float32Array;
  /** As of cells: 0 inside, 1 outside. */
  tiles: Uint32Array;
  corners: Float32Array;
}

/** Curves of paths: loops around handles; a loop through places; the Bézier curve that places control. */
export type PathCurves = 'loops' | 'loop' | 'bezier';

/** Which curves are wanted; those around handles need no places. */
export interface PathWish extends ExactSurface {
  kind: PathCurves;
  places: TrianglePlaces;
}

export interface FoundPaths {
  /** The shortest first. */
  lengths: readonly ModelLength[];
  /** #segments × 2 × 3: ends of the segments of all, as they are drawn. */
  ends: Float32Array;
}

/** Directions at places: of each three numbers, as they are drawn. */
export interface DirectionWish extends ExactSurface {
  places: TrianglePlaces;
  directions: Float64Array;
}

/** Which image is wanted on the surface, and where. */
export interface DecalWish extends ExactSurface {
  /** Of its middle, a drawn triangle and weights of its corners. */
  place: TrianglePlaces;
  /** Half its width and half its height, in the unit of the file. */
  half: readonly [number, number];
  /** The direction of its right side, as it is drawn. */
  right: readonly [number, number, number];
}

/** What of the surface an image covers: parts of triangles. */
export interface LaidDecal {
  /** #T: the drawn triangle that each is of. */
  triangles: Uint32Array;
  /** #T × 3 × 3: the weights of its corners at those of the part. */
  corners: Float32Array;
  /** #T × 3 × 2: where these are in the image, from 0 to 1 to the right and down. */
  image: Float32Array;
}

/** A plane, in the unit and the axes of the file: where a point times `normal`, which has length 1, is `offset`. */
export interface Plane {
  normal: readonly [number, number, number];
  offset: ModelLength;
}

/** A file of the curves in which a plane cuts the surface. */
export type GirthFile = Exclude<CurveFile['kind'], `${string}.${string}` | 'svg' | 'pdf'>;

/** Such a file. */
export interface SavedCurves {
  bytes: Uint8Array<ArrayBuffer>;
  /** Of strips that are not in it since they are curved, the distances that each lies between, in the file's unit; none for no bound. */
  leftOut: readonly (readonly [from: number | null, to: number | null])[];
  /** A spacing by which it would leave out none, in the file's unit; null where none is known. */
  flatSpacing: number | null;
}

/** A file with a distance for each vertex of the input; `weights.ply` has them as vertex colors. */
export type DistanceFile = 'csv' | 'npy' | 'ply' | 'glb' | 'weights.ply';
/** The same of tetrahedra. */
export type InnerDistanceFile = 'csv' | 'vtu' | 'msh';

export type ProgressListener = (progress: Progress) => void;
