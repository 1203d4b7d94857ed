/** Told while something is computed: the fraction that is done, 0 to 1, and the stage. */
export type Progress = (fraction: number, stage: string) => void;

/** What every question takes. */
export interface QueryOptions {
  /** Ends the work: the question is rejected with the reason of the signal. */
  signal?: AbortSignal | undefined;
  progress?: Progress | undefined;
}

/** How a mesh is made of triangles. */
export interface MeshOptions extends QueryOptions {
  /** The type of the numbers in answers; `float64` if not given. All is computed in float64. */
  precision?: 'float64' | 'float32' | undefined;
  /** What becomes one beside vertices of equal position: what cracks part that are too narrow to be seen (`auto`), nothing (`exact`), or cracks up to a width. */
  weld?: 'auto' | 'exact' | number | undefined;
  /** Components that paths cross between: those that pierce, touch or nearly touch (`auto`), none (`off`), or those no farther apart than this. */
  bridges?: 'auto' | 'off' | number | undefined;
  /** So many components more are joined, nearest first; 0 if not given. */
  links?: number | undefined;
  /** What a unit of length costs in each face, 0.001 to 1000; distances are then least costs. */
  costs?: ArrayLike<number> | undefined;
  /** Faces that nobody enters. */
  walls?: ArrayLike<number> | undefined;
}

/** How a file is read. */
export interface FileOptions extends MeshOptions {
  /** Of the file: its extension tells the format where the first bytes do not. A `File` has one. */
  name?: string | undefined;
  /** Parts of the file that are wanted, counted from 0; vertices and faces keep their numbers. */
  parts?: ArrayLike<number> | undefined;
  /** Files that it refers to, by the names that it has for them. */
  resources?: Readonly<Record<string, Uint8Array | ArrayBuffer>> | undefined;
}

/** How distances are found. */
export interface Method {
  /** `auto` is exact while that takes about a second, and propagates a few windows beyond. */
  method?: 'auto' | 'exact' | 'propagation' | 'heat' | undefined;
  /** Vertices farther than this stay at Infinity, and no work is done there; not with heat. */
  maxDistance?: number | undefined;
  /** With auto and propagation: windows of each half-edge that are kept. */
  windows?: number | 'all' | undefined;
  /** With heat, as are the following: what diffuses. */
  operator?: 'delaunay' | 'plain' | 'relocate' | undefined;
  solver?: 'cholesky' | 'cg' | undefined;
  /** m in t = m h², h the mean edge. */
  timeStep?: number | 'auto' | undefined;
  boundary?: 'neumann' | 'dirichlet' | 'average' | undefined;
  multiSource?: 'exact' | 'summed' | undefined;
  /** In mean edges: what is nearer to a source is exact. */
  exactRadius?: number | 'auto' | undefined;
}

/** What is asked of distances. */
export interface DistanceOptions extends Method, QueryOptions {
  /** Distances that sources start from, one each; 0 if not given. */
  initial?: ArrayLike<number> | undefined;
}

export interface PathOptions extends Method, QueryOptions {
  /** `straight` (if not given) is locally shortest, and the shortest where distances are exact; `descent` goes down the distances as they are; `exact` is a shortest path whatever the method. */
  kind?: 'straight' | 'descent' | 'exact' | undefined;
}

/** Which isolines: one of the three. */
export type Levels = { levels: ArrayLike<number> } | { count: number } | { spacing: number };

/** How many samples: one of the two. */
export type SampleCount = { count: number } | { radius: number };
