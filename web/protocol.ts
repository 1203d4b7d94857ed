/**
 * The messages between the page and the solver's worker: the only definition of them. The worker exposes a `SolverApi`
 * with comlink; buffers are transferred, never copied. Lengths are in the unit of the file.
 */

/** A file as the user gave it. The mesh comes first, then what it refers to (.bin). */
export interface NamedBytes {
  name: string;
  bytes: Uint8Array;
}

/** What to open. `positions` is #V × 3, `triangles` #F × 3. */
export type MeshInput =
  | { kind: 'files'; files: NamedBytes[] }
  | { kind: 'shape'; shape: string }
  | { kind: 'arrays'; name: string; positions: Float32Array; triangles: Uint32Array };

/** A place on the surface: an input vertex, or a face of `DrawMesh.triangles` with three weights that sum to 1. */
export type SurfacePoint = { vertex: number } | { face: number; weights: [number, number, number] };

export type Boundary = 'neumann' | 'dirichlet' | 'average';

export interface Parameters {
  /** m in t = m h², h the mean edge length. */
  timeFactor: number;
  boundary: Boundary;
}

export interface PartInfo {
  name: string;
  triangles: number;
}

/** Triangles to draw, with vertices split where the normal jumps. */
export interface DrawMesh {
  /** #D × 3 */
  positions: Float32Array;
  /** #D × 3, unit length */
  normals: Float32Array;
  /** #F × 3, indices of drawn vertices, counter-clockwise seen from outside */
  triangles: Uint32Array;
}

/** What was done to make a surface of the triangles, in counts. */
export interface BuildReport {
  inputVertices: number;
  /** Vertices after welding. */
  vertices: number;
  faces: number;
  weldedVertices: number;
  unreferencedVertices: number;
  degenerateFaces: number;
  duplicateFaces: number;
  turnedFaces: number;
  nonManifoldEdges: number;
  components: number;
  boundaryLoops: number;
  /** Euler characteristic V − E + F. */
  eulerCharacteristic: number;
}

export interface Timings {
  readMs: number;
  buildMs: number;
  precomputeMs: number;
}

export interface OpenedMesh {
  name: string;
  /** SHA-256 of the first file, hex; empty for shapes and arrays. */
  hash: string;
  parts: PartInfo[];
  /** Indices of the parts that form the surface. */
  walked: number[];
  surface: DrawMesh;
  /** For each drawn vertex of the surface, its vertex index in the input (over the walked parts, in file order). */
  inputVertices: Uint32Array;
  /** The parts that are not walked on; empty arrays if none. */
  scenery: DrawMesh;
  report: BuildReport;
  timings: Timings;
  /** Mean edge length. */
  meanEdge: number;
  /** Stored entries of all Cholesky factors together. */
  factorNonzeros: number;
  /** Bytes of wasm memory in use. */
  memoryBytes: number;
}

export interface DistanceField {
  /** One value a drawn vertex of the surface; Infinity where no source can be reached. */
  distance: Float32Array;
  /** Largest finite distance. */
  maxDistance: number;
  /** Welded vertices that no source reaches. */
  unreachableVertices: number;
  solveMs: number;
}

export interface SurfacePath {
  /** #P × 3, from the start to the source. */
  points: Float32Array;
  /** #P × 3, unit surface normals at the points. */
  normals: Float32Array;
  length: number;
}

export interface Progress {
  /** In words: "Factoring" */
  stage: string;
  /** 0 to 1 over the whole opening. */
  fraction: number;
  vertices: number;
}

export type ProgressListener = (progress: Progress) => void;

/** Calls run one after another. A call that fails rejects with a one-sentence message and changes nothing. */
export interface SolverApi {
  /** Reads, welds, factors. `parts`: the indices to walk on, empty for all. The last mesh stays if this fails. */
  open(input: MeshInput, parts: number[], parameters: Parameters, progress: ProgressListener): Promise<OpenedMesh>;
  /** Factors again what the change needs. */
  configure(parameters: Parameters): Promise<Timings>;
  solve(sources: SurfacePoint[]): Promise<DistanceField>;
  /** The way down the last distance field to the nearest source. */
  path(from: SurfacePoint): Promise<SurfacePath>;
  /** Names that `{ kind: 'shape' }` takes. */
  shapes(): Promise<string[]>;
}
