/**
 * The messages between the page and the solver's worker. The worker exposes a `SolverApi` with comlink; buffers are
 * transferred, never copied. What Rust gives and takes is defined there: names, ranges and options come from the generated
 * contract, the rest from the types of the solver's module. Lengths are in the unit of the file but for those that are
 * said to be as they are drawn: see `DrawTransform`.
 */

import type { AUTOMATIC, EdgeKind, FaceField, Parameters, PathKind, Up } from './wasm/contract';
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

/** What the solver's module gives, as a plain object: its properties without its methods. */
export type Plain<T> = { [Key in keyof T as T[Key] extends (...given: never[]) => unknown ? never : Key]: T[Key] };

export type { EdgeKind, FaceField, Parameters, PathKind } from './wasm/contract';
export type InnerCut = interior.InnerCut;

/** What must fit into memory beside a mesh. */
export interface MemoryBudget {
  /** Windows of each half-edge; 0 where the mesh is factored, which checks its own memory. */
  windows: number;
  /** Most memory, in MiB; that of the browser where it is chosen automatically. */
  memory: Parameters['memory'];
}

export interface PartInfo {
  name: string;
  triangles: number;
  /** Its triangles as ranges of the file's, ascending: of each its first one and the one behind its last. */
  ranges: Uint32Array;
}

/**
 * From the file's unit to what is drawn: drawn = (position − center) · scale, turned so that `up` is drawn along Y. What is
 * drawn is near the origin and within ±1, whatever the file's unit, since graphics cards calculate in single precision.
 */
export interface DrawTransform {
  center: [number, number, number];
  /** Drawn length of the file's unit. */
  scale: number;
  /** The axis of the file that points up. */
  up: Up;
}

export type DrawMesh = Plain<wasm.DrawMesh>;
export type Shade = Plain<wasm.Shade>;
export type Material = Plain<wasm.Material>;
export type BuildReport = Plain<wasm.BuildReport>;
export type SurfacePath = Plain<wasm.SurfacePath>;
/** A path between two places: on a surface, where it can be drawn in any pose, or inside of tetrahedra. */
export type Leg = SurfaceLeg | InnerLeg;
export type SurfaceLeg = Plain<wasm.Leg>;
export type InnerLeg = Plain<interior.InnerPath>;
export type Enclosure = Plain<wasm.Enclosure>;
/** Curves, one after another, in the unit and the axes of the file. */
export type Tracks = Plain<wasm.Tracks>;
export type Convergence = Plain<wasm.Convergence>;

/** A moment of an animation: its number, and seconds from its beginning. */
export interface Moment {
  clip: number;
  seconds: number;
}

export type Clip = Plain<wasm.Clip>;
export type CameraView = Plain<wasm.CameraView>;
export type DrawPose = Plain<wasm.DrawPose>;

/** A mesh as it stands at a moment. */
export interface Posed {
  surface: DrawPose;
  /** The inactive parts that move. */
  scenery: { part: number; pose: DrawPose }[];
  /** The path that was traced last, as it lies there; null where there is none, or distances are measured in another pose since. */
  path: SurfacePath | null;
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
export interface Factoring {
  timings: Timings;
  /** Groups of components that paths lead between; 0 where nothing was joined. */
  groups: number;
  /** Pairs of components that meet. */
  contacts: number;
  /** Whether all contacts were looked at, or there are too many. */
  contactsComplete: boolean;
  /** Places where paths cross cracks within components. */
  crackPortals: number;
  /** The widest of these cracks, in the unit of the file. */
  crackGap: number;
  /** Links between groups that would stay apart. */
  links: number;
  /** The widest gap that is linked, in the unit of the file; 0 without links. */
  linkedGap: number;
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
  error: number;
  /** Of the box around the mesh, in that unit. */
  diagonal: number;
}

/** The tetrahedra of a mesh whose boundary is drawn, counted as in the input. */
export interface Interior {
  /** #V × 3, as they are drawn. */
  positions: Float32Array;
  /** #T × 4, corners. */
  tetrahedra: Uint32Array;
  report: Plain<interior.InnerReport>;
  /** Of reading or filling, and finding neighbors. */
  madeMs: number;
}

/** What is drawn of the inside. */
export type InnerView = Plain<interior.InnerView>;

/** How a file wants its surface to look. */
export interface Appearance {
  /** What the runs of drawn meshes name. */
  materials: Material[];
  /** What the textures of materials name; null for an image that cannot be decoded. */
  images: (ImageBitmap | null)[];
}

/** What is known of a mesh before anything is solved on it: enough to draw it. */
export interface OpenedMesh {
  name: string;
  /** SHA-256 of the file of the mesh, hex; empty for shapes and arrays. */
  hash: string;
  parts: PartInfo[];
  /** Indices of the parts that form the surface. */
  active: number[];
  surface: DrawMesh;
  /** Of the surface alone; null where there are other parts. */
  shade: Shade | null;
  /** Null where the file says nothing. */
  appearance: Appearance | null;
  /** The animations of the file. */
  clips: Clip[];
  /** Its cameras. */
  cameras: CameraView[];
  /** #lights × 12: its lights, as `Viewer.set_lights` takes them. */
  lights: Float32Array;
  /** Null for a mesh as it is in the file. */
  simplified: Simplified | null;
  /** The symbol of the unit of lengths, `mm`; empty where there is none. */
  unit: string;
  /** Whether only the size of the file suggests that unit. */
  unitAssumed: boolean;
  /** What the file refers to that was not given, as the file calls it. */
  missing: string[];
  /** What was left out of the file, or taken otherwise than it is written. */
  warnings: Plain<wasm.Warning>[];
  /** Images that the browser cannot decode, as the file calls them. */
  undecoded: string[];
  /** For each drawn vertex of the surface, its vertex index in the input (in file order, whichever parts are active). */
  inputVertices: Uint32Array;
  /** Of everything that is drawn with this mesh: surface, scenery, paths, crowd, edges. */
  drawTransform: DrawTransform;
  /** The axis that points up by the rules of the format, or by the shape. */
  upright: Up;
  /** The inactive parts. */
  scenery: SceneryPart[];
  report: BuildReport;
  /** Mean edge length. */
  meanEdge: number;
  /** Null for a surface. */
  interior: Interior | null;
  /** What the file says that vertices of the input cost, under the name that it has for that; null where it says nothing. */
  weights: { name: string; values: Float32Array } | null;
}

export interface DistanceField extends Omit<Plain<wasm.Field>, 'meanError' | 'maxError'> {
  /** #D × 4: the direction in which distance grows at each drawn vertex, 127 for a unit; the fourth number is 0. */
  tangents: Int8Array;
  /** How far the field was off before it was refined; null until refining has made all of it exact. */
  error: FieldError | null;
  /** Of tetrahedra: one value a vertex of the input, Infinity where no source can be reached; null for a surface. */
  inner: Float32Array | null;
  /** Of `solve` or `propagate` alone. */
  solveMs: number;
  /** Of all steps of refinement so far. */
  refineMs: number;
}

/** Relative to the exact distance, over the reachable welded vertices off the sources; 0.01 is one percent. */
export interface FieldError {
  mean: number;
  max: number;
}

/** A path that is wanted. */
export interface PathRequest {
  from: MeshPoint;
  kind: PathKind;
}

export interface TracedPath {
  /** Null where none was wanted, and where there is none: the start is on a part that no source reaches. */
  path: SurfacePath | null;
  /** Of tracing alone. */
  pathMs: number;
}

/** A field and the path on it, in one message: both are shown in the same frame. */
export interface Solved extends TracedPath {
  field: DistanceField;
  /** The inside with this field, as it was asked for last; null where nothing of it is. */
  inside: InnerView | null;
}

export interface Progress {
  /** In words: "Factoring" */
  stage: string;
  /** 0 to 1 over the whole opening. */
  fraction: number;
  vertices: number;
}

/** At which distances isolines are wanted: at these, or where there are none at the multiples of a spacing; in the unit of the file. */
export interface IsolineWish {
  values: readonly number[];
  spacing: number;
}

/** Isolines of a field. */
export interface Isolines {
  /** Of each, by value: how long it is, what area is nearer, and how many curves it has, and closed ones; in the unit of the file. */
  rows: readonly { value: number; length: number; area: number; curves: number; closed: number }[];
  /** #segments × 2 × 3, ends of all segments, as they are drawn. */
  ends: Float32Array;
}

/** A file of isolines, of strips between them, or of these in the plane; of curves as they are seen in an SVG, whence. */
export interface CurveFile {
  kind: 'obj' | 'dxf' | 'svg' | 'csv' | 'glb' | 'strips.obj' | 'unrolled.svg' | 'unrolled.dxf';
  towardEye: readonly [number, number, number];
}

/** A file with a distance for each vertex of the input; `weights.ply` has them as vertex colors. */
export type DistanceFile = 'csv' | 'npy' | 'ply' | 'glb' | 'weights.ply';
/** The same of tetrahedra. */
export type InnerDistanceFile = 'csv' | 'vtu' | 'msh';

export type ProgressListener = (progress: Progress) => void;

/**
 * Calls run one after another, none before `start`. A call that fails rejects with a one-sentence message and changes
 * nothing.
 */
export interface SolverApi {
  /** The solver's module, compiled once by the page for all its workers. */
  start(module: WebAssembly.Module): Promise<void>;
  /** Solves a small shape and forgets it, so that the browser has optimised the solver's code before a mesh comes. */
  warmUp(): Promise<void>;
  /**
   * Reads and welds a mesh, the only one of this worker, where it fits into memory. `parts`: the indices to walk on, empty
   * for all. `up`: the axis that points up where it is drawn. `triangles`: a mesh of more is simplified to this number, as one part
   * without materials. `fill`: what the surface encloses is filled with about this number of tetrahedra.
   */
  open(
    input: MeshInput,
    parts: number[],
    budget: MemoryBudget,
    progress: ProgressListener,
    up?: Up | typeof AUTOMATIC,
    triangles?: number | null,
    fill?: number | null,
  ): Promise<OpenedMesh>;
  /** Factors the mesh for the heat method with these parameters; with null, for propagation alone, nothing. To be called once. */
  prepare(parameters: Parameters | null, progress: ProgressListener): Promise<Factoring>;
  /** Factors again what the change needs, where anything is factored. The last field is forgotten. */
  configure(parameters: Parameters): Promise<Factoring>;
  /**
   * Joins components between which paths are to lead: "auto" those that pierce or nearly touch each other, "off" none, else
   * those no farther apart than so much, in the unit of the file. Of the groups that stay apart, so many pairs are linked, the
   * nearest first. `posed`: where they meet in the pose that is shown, not in that of the file. The last field is forgotten.
   */
  bridge(rule: string, links: number, posed: boolean): Promise<Factoring>;
  /**
   * Changes the ground: triangles that are painted anew and their costs, Infinity for walls; all closed walls along edges; and
   * what slope and height cost. The last field is forgotten, and what is factored is factored anew by the next `solve`.
   */
  ground(change: GroundChange): Promise<void>;
  /** How the inside of tetrahedra is looked into from now on; null: not at all. What is seen of it with the last field. */
  look(cut: InnerCut | null): Promise<InnerView | null>;
  /** #F × 3, the drawn triangles beside each; itself at the boundary. */
  neighbors(): Promise<Uint32Array>;
  /** The shortest line along edges from one vertex of the input to another, both included. */
  line(from: number, to: number): Promise<Uint32Array>;
  /**
   * With how many links, at least, the sources of the last field reach more than they do; as many as there are where nothing is
   * left to link.
   */
  linksToReachMore(): Promise<number>;
  /**
   * Shows the mesh as it is at a moment, with null as in its file; null where it does not move. What the other calls give is
   * drawn there. Distances are `measured` in that pose from now on, and the last field is forgotten; or in that of the file.
   */
  pose(moment: Moment | null, measured: boolean): Promise<Posed | null>;
  /**
   * By heat, which needs factors. `quick`: with a small exact region whatever the parameters, during a drag; null: another
   * quick field was asked for before this one was begun.
   */
  solve(sources: Source[], quick: boolean, request: PathRequest | null): Promise<Solved | null>;
  /** By `windows` of each half-edge, with or without factors. Quick ones are overtaken as those by heat are. */
  propagate(sources: Source[], windows: number, quick: boolean, request: PathRequest | null): Promise<Solved | null>;
  /**
   * One step of making the last field exact, from the sources outward: exact inside, as it was beyond. Takes 100 to
   * 200 ms, more where a solve by heat or showing the field takes longer; the next call goes on. Once all is exact, the
   * field stays as it is.
   */
  refine(request: PathRequest | null): Promise<Solved>;
  /**
   * The last field at places of a surface, in the file's unit, Infinity where no source reaches them; null until all of it is exact,
   * and inside of tetrahedra.
   */
  exactDistances(places: readonly MeshPoint[]): Promise<Float64Array | null>;
  /** A path on the last field. */
  path(request: PathRequest): Promise<TracedPath>;
  /** One step of searching the exact path, of 100 to 200 ms; null: it is not found yet, and the next call goes on. */
  searchPath(from: MeshPoint): Promise<TracedPath | null>;
  /**
   * One step of searching the exact path between two places, of 100 to 200 ms, beside the last field; null: it is not found yet,
   * and the next call goes on. Its `leg` is null where no path leads there. Inside of tetrahedra a shortest path is found at once.
   */
  measure(from: MeshPoint, to: MeshPoint): Promise<{ leg: Leg | null } | null>;
  /** A locally shortest path between two places of a surface, or one of locally least cost; null where none leads there. */
  estimate(from: MeshPoint, to: MeshPoint): Promise<SurfaceLeg | null>;
  /** What the closed curve of these legs encloses. */
  enclosed(legs: readonly SurfaceLeg[]): Promise<Enclosure>;
  /**
   * #F × 3, one vector a drawn triangle, by the last field: the gradient of distance, or the unit vector along the
   * gradient of heat (towards the sources); 0 where there is none.
   */
  gradients(kind: FaceField): Promise<Float32Array>;
  /** One value a drawn vertex, or a corner as in the field, of a field by heat: log10 of its heat over its maximum; −Infinity where there is none. */
  heat(): Promise<Float32Array>;
  /**
   * How many walkers take the path to the sources by the last field, wherever they start; 0: none. Those who are out stay
   * out. `height`: of those who set out, in bounding radii of the surface.
   */
  crowd(count: number, height: number): Promise<void>;
  /**
   * Moves each walker by `step` and gives 10 numbers a walker: position, unit surface normal and unit heading (three
   * each), and the length that it has walked, as they are drawn. Who arrives starts again elsewhere, with length 0. Walkers keep their
   * places in the array. Empty without a field or a crowd.
   */
  stepCrowd(step: number): Promise<Float32Array>;
  /** The way of each walker down the last field, from where it is to its source; none without a crowd. */
  crowdTracks(): Promise<Tracks>;
  /**
   * #E × 2 × 3, ends of lines on the surface, as they are drawn: edges between faces, edges with one face, the edges of the triangles that
   * carry the operators, or the marks of where components meet.
   */
  edges(kind: EdgeKind): Promise<Float32Array>;
  /** One value a drawn vertex, or a corner as in the field: relative error of the last field before it was made exact; null until it is. */
  errors(): Promise<Float32Array | null>;
  /** Residuals of both linear solvers in the systems of the last field, which is by heat. */
  convergence(): Promise<Convergence>;
  /** #P × 2, points of the path traced last: the length up to each, and the last field there, in the unit of the file; null without a path. */
  pathProfile(): Promise<Float64Array | null>;
  /** Isolines of the last field. */
  isolines(wish: IsolineWish): Promise<Isolines>;
  /** A file of isolines of the last field, in the unit of the file. */
  curveFile(wish: IsolineWish, file: CurveFile): Promise<Uint8Array<ArrayBuffer>>;
  /** A file of the last field; of a mesh that is as in its file, with all that this holds. */
  distanceFile(kind: DistanceFile): Promise<Uint8Array<ArrayBuffer>>;
  /** The same of tetrahedra. */
  innerDistanceFile(kind: InnerDistanceFile): Promise<Uint8Array<ArrayBuffer>>;
}
