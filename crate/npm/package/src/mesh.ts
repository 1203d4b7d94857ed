import type {
  Answer,
  Cells,
  Floats,
  Isoline,
  LogMap,
  Matrix,
  Mean,
  Path,
  Report,
  Samples,
  Snapped,
  Walk,
} from './answers.ts';
import { Agents } from './agents.ts';
import { floats, integers } from './arrays.ts';
import { withInitial } from './initial.ts';
import { Connection } from './connection.ts';
import { HeatwalkError } from './errors.ts';
import type { Opening } from './messages.ts';
import type {
  DistanceOptions,
  FileOptions,
  Levels,
  MeshOptions,
  Method,
  PathOptions,
  QueryOptions,
  SampleCount,
} from './options.ts';
import { modules } from './parts.ts';
import { encodePlace, encodePlaces, encodeVector, index, type Place, type Places, type Vector } from './places.ts';

/** Triangles in memory: three coordinates a vertex, three vertices a triangle; without these, each three vertices in turn are one. */
export interface Triangles {
  positions: ArrayLike<number>;
  indices?: ArrayLike<number> | null | undefined;
}

/** Triangles, or the bytes of a file. */
export type Source = Triangles | ArrayBuffer | Uint8Array | Blob;

/** Loads and compiles the solver, which the first mesh does otherwise. */
export async function init(): Promise<void> {
  await modules(false);
}

/**
 * A triangle mesh in a worker of its own, and what answers questions on it. Answers are by the vertices and faces as they were given, in the unit of
 * the positions. Questions are answered in turn; what goes wrong is a `HeatwalkError`.
 */
export class Mesh<F extends Floats = Float64Array> {
  /** What it is, and what was done when it was made of triangles. */
  readonly report: Report;
  readonly #connection: Connection;

  private constructor(connection: Connection, report: Report) {
    this.#connection = connection;
    this.report = report;
  }

  /**
   * Makes a mesh of triangles, or of the bytes of a file: glTF and GLB, OBJ, OFF, PLY, STL, 3MF, VTK. Arrays are copied.
   *
   * Vertices of equal position become one, triangles without area and duplicates are left out, and orientations are made to agree, as `report`
   * tells; vertices and faces keep their numbers.
   */
  static from(source: Source, options: FileOptions & { precision: 'float32' }): Promise<Mesh<Float32Array>>;
  static from(source: Source, options?: FileOptions): Promise<Mesh>;
  static async from(source: Source, options: FileOptions = {}): Promise<Mesh<Floats>> {
    const { signal, progress, precision = 'float64', ...rest } = options;
    if (precision !== 'float64' && precision !== 'float32') {
      throw refused(`there is no precision ${String(precision)}; choose one of float64, float32`);
    }
    const opening = { ...(await given(source, rest)), isSingle: precision === 'float32' };
    const connection = new Connection(opening);
    try {
      return new Mesh(connection, (await connection.ask('about', [], { signal, progress })) as Report);
    } catch (error) {
      connection.dispose();
      throw error;
    }
  }

  /** Three coordinates a vertex, as given or in the file. */
  positions(options?: QueryOptions): Promise<F> {
    return this.#ask('positions', [], options);
  }

  /** Three vertices a triangle, as given or in the file. */
  indices(options?: QueryOptions): Promise<Uint32Array> {
    return this.#ask('indices', [], options);
  }

  /** The places that are nearest to points in space, three coordinates each. */
  snap(points: ArrayLike<number>, options?: QueryOptions): Promise<Snapped<F>> {
    return this.#ask('snap', [floats(points, 'points', 3)], options);
  }

  /** The distance of each vertex from the nearest source. */
  async distance(sources: Places, options: DistanceOptions = {}): Promise<F> {
    return (await this.solve(sources, options)).distances;
  }

  /** As `distance`, with how it was found. */
  async solve(sources: Places, options: DistanceOptions = {}): Promise<Answer<F>> {
    const { signal, progress, ...method } = withInitial(options);
    return this.#ask('solve', [encodePlaces(sources, 'source'), method], { signal, progress });
  }

  /** Distances from each source by itself, all vertices if none are given, to the vertices that are `targets`, all if none are given. */
  async matrix(
    sources?: Places,
    targets?: ArrayLike<number>,
    { signal, progress, ...method }: Method & QueryOptions = {},
  ): Promise<Matrix<F>> {
    const all = () => Uint32Array.from({ length: this.report.vertices }, (_, vertex) => vertex);
    const to = targets ? integers(targets, 'target') : all();
    return this.#ask('matrix', [encodePlaces(sources ?? all(), 'source'), to, method], { signal, progress });
  }

  /** The path from a place to another. */
  async path(start: Place, end: Place, { signal, progress, ...options }: PathOptions = {}): Promise<Path<F>> {
    const ends = Float64Array.of(...encodePlace(start, 'start'), ...encodePlace(end, 'end'));
    return this.#ask('path', [ends, options], { signal, progress });
  }

  /** A locally shortest path beside the one that goes through places in turn: only the first and the last are still on it. */
  async pathThrough(places: Places, options?: QueryOptions): Promise<Path<F>> {
    return this.#ask('path_through', [encodePlaces(places, 'place')], options);
  }

  /** The Bézier curve of control places, by exact shortest paths: from the first to the last. */
  async bezier(places: Places, options?: QueryOptions): Promise<Path<F>> {
    return this.#ask('bezier', [encodePlaces(places, 'place')], options);
  }

  /** The closed curve through places in turn; through one or two, around a handle or a hole. `isFree`: what it tightens to once it may leave them. */
  async loop(places: Places, { isFree = false, ...options }: QueryOptions & { isFree?: boolean } = {}): Promise<Path<F>> {
    return this.#ask('loop_through', [encodePlaces(places, 'place'), isFree], options);
  }

  /** Closed geodesics around the handles and through them, two of each, the shortest first. */
  handleLoops(options?: QueryOptions): Promise<Path<F>[]> {
    return this.#ask('handle_loops', [], options);
  }

  /** Walks as straight as the surface lets one, in a direction whose part along the surface counts: along `face` where that is given, else along the face at the start that agrees with it best. */
  async walk(
    start: Place,
    direction: Vector,
    length: number,
    { face, ...options }: QueryOptions & { face?: number } = {},
  ): Promise<Walk<F>> {
    const along = face === undefined ? undefined : index(face, 'face');
    return this.#ask('walk', [encodePlace(start, 'start'), encodeVector(direction, 'direction'), Number(length), along], options);
  }

  /** In which direction shortest paths leave a source, and how long they are. Without a direction, u is along the x axis, or the y axis where the surface faces along x. */
  async logMap(
    source: Place,
    {
      direction,
      method = 'exact',
      ...options
    }: QueryOptions & { direction?: Vector; method?: 'exact' | 'propagation' | 'heat' } = {},
  ): Promise<LogMap<F>> {
    const along = direction && encodeVector(direction, 'direction');
    return this.#ask('log_map', [encodePlace(source, 'source'), along, method], options);
  }

  /** Three coordinates a vertex: tangent vectors carried from sources, three coordinates each, parallel along the surface. By heat they go over into each other. */
  async transport(
    sources: Places,
    vectors: ArrayLike<number>,
    { method = 'exact', ...options }: QueryOptions & { method?: 'exact' | 'heat' } = {},
  ): Promise<F> {
    return this.#ask('transport', [encodePlaces(sources, 'source'), floats(vectors, 'vectors', 3), method], options);
  }

  /** Numbers carried from sources to all vertices by heat: near each the number is its own, and between they go over into each other. */
  async extend(sources: Places, values: ArrayLike<number>, options?: QueryOptions): Promise<F> {
    return this.#ask('extend', [encodePlaces(sources, 'source'), floats(values, 'values')], options);
  }

  /** The exact distance of each vertex from the nearest point of curves, each through places by shortest paths, or from all boundaries. */
  curveDistance(
    curves: readonly Places[] | 'boundary',
    { isClosed = false, ...options }: QueryOptions & { isClosed?: boolean } = {},
  ): Promise<F> {
    return this.#curves(curves, isClosed, undefined, options);
  }

  /** As `curveDistance`, negative on the left of curves: inside of those that run counterclockwise, seen from outside. Heat closes gaps. */
  signedDistance(
    curves: readonly Places[] | 'boundary',
    {
      isClosed = false,
      sign = 'auto',
      ...options
    }: QueryOptions & { isClosed?: boolean; sign?: 'auto' | 'nearest' | 'heat' } = {},
  ): Promise<F> {
    return this.#curves(curves, isClosed, sign, options);
  }

  /** Isolines of values at vertices, linear on each face: at `levels`, `count` of them that part the largest into equal shares, or at multiples of `spacing`. */
  async isolines(values: ArrayLike<number>, levels: Levels, options?: QueryOptions): Promise<Isoline<F>[]> {
    return this.#ask('isolines', [floats(values, 'values'), { ...levels }], options);
  }

  /** What is nearest to each of several sources, by exact distance. */
  async cells(sources: Places, options: QueryOptions & Pick<DistanceOptions, 'initial'> = {}): Promise<Cells<F>> {
    const { signal, progress, ...rest } = withInitial(options);
    return this.#ask('cells', [encodePlaces(sources, 'source'), rest], { signal, progress });
  }

  /** Farthest samples: so many, or as many as leave no vertex farther than `radius` from one. `relax`: rounds in which they move to the middles of their cells. */
  async sample(
    wanted: SampleCount,
    { start, relax = 0, ...options }: QueryOptions & { start?: number; relax?: number } = {},
  ): Promise<Samples<F>> {
    const first = start === undefined ? undefined : index(start, 'start');
    return this.#ask('sample', [first, { ...wanted, relax }], options);
  }

  /** Where squared distances from places, weighted if weights are given, sum to least. */
  async mean(sources: Places, weights?: ArrayLike<number>, options?: QueryOptions): Promise<Mean<F>> {
    const places = encodePlaces(sources, 'source');
    const each = weights ? floats(weights, 'weights') : new Float64Array(places.length / 5).fill(1);
    return this.#ask('mean', [places, each], options);
  }

  /** Agents that walk on it, none yet. */
  agents(): Agents {
    return new Agents(this.#connection);
  }

  /** Gives its memory back; what waits for an answer is rejected. */
  dispose() {
    this.#connection.dispose();
  }

  [Symbol.dispose]() {
    this.dispose();
  }

  async #curves(curves: readonly Places[] | 'boundary', isClosed: boolean, sign: string | undefined, options: QueryOptions): Promise<F> {
    const through = curves === 'boundary' ? undefined : curves.map((places, k) => encodePlaces(places, `place of curve ${k}:`));
    const areClosed = new Uint8Array(through?.length ?? 0).fill(isClosed ? 1 : 0);
    return this.#ask('curve_distance', [through, areClosed, sign], options);
  }

  #ask<T>(method: string, args: unknown[], options?: QueryOptions): Promise<T> {
    return this.#connection.ask(method, args, options) as Promise<T>;
  }
}

async function given(source: Source, { name, resources, ...options }: FileOptions): Promise<Omit<Opening, 'isSingle'> & Opening> {
  const own: MeshOptions = {
    ...options,
    ...(options.costs && { costs: floats(options.costs, 'costs') }),
    ...(options.walls && { walls: integers(options.walls, 'wall') }),
  };
  if (typeof source !== 'object' || source === null) throw refused('a mesh is made of { positions, indices } or of the bytes of a file');
  if ('positions' in source) {
    const positions = floats(source.positions, 'positions', 3);
    const corners = source.indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
    return { positions, indices: integers(corners, 'vertex of a triangle', 3), options: own, isSingle: false };
  }
  const bytes = source instanceof Blob ? await source.arrayBuffer() : source;
  if (!(bytes instanceof ArrayBuffer) && !(bytes instanceof Uint8Array)) {
    throw refused('a mesh is made of { positions, indices } or of the bytes of a file');
  }
  const known = Object.entries(resources ?? {}).map(([uri, held]) => [uri, new Uint8Array(held)]);
  const called = name ?? (typeof File !== 'undefined' && source instanceof File ? source.name : 'mesh');
  return { name: called, bytes: new Uint8Array(bytes), resources: Object.fromEntries(known), options: own, isSingle: false };
}

const refused = (sentence: string) => new HeatwalkError(sentence, 'bad-parameter');
