/** The worker: the solver's wasm module behind the interface of protocol.ts. */
import { expose, transfer } from 'comlink';
import type {
  Convergence,
  DistanceField,
  DrawMesh,
  DrawTransform,
  EdgeKind,
  Enclosure,
  FaceField,
  GroundChange,
  Factoring,
  InnerCut,
  InnerDistanceFile,
  InnerView,
  Leg,
  SurfaceLeg,
  Moment,
  OpenedMesh,
  Parameters,
  Plain,
  Posed,
  Solved,
  SolverApi,
  Source,
  Timings,
  TracedPath,
  Tracks,
  PathRequest,
  MeshPoint,
} from '../../protocol';
import initialise, * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { AUTOMATIC, DEFAULT_WINDOWS, type Up } from '../../wasm/contract';
import { Latest } from '../latest';
import { isOutOfMemory, isTrap } from '../trap';
import type { ShownAs } from './curves';
import { innerSolver, interiorBytes, interiorOf } from './interior';
import { innerMesh, type Mesh, messageOf, type SolvedField, surfaceMesh } from './mesh';
import { FILLED_FROM, lookOf, openingOf, sourceOf } from './opening';
import { plain, through } from './plain';

/** Where building, drawing and what comes after begin in the time that opening takes, for the progress bar. */
const BUILD_FROM = 0.1;
const DRAW_FROM = 0.3;
const SOLVE_FROM = 0.4;

/**
 * A slice of refining lasts about this long. It lasts longer where what comes after it takes longer: this many solves by heat,
 * since each slice ends with one, or else as long as showing the field takes, but no longer than finding it took.
 */
const SLICE_MS = 150;
const SLICE_SOLVES = 2;
/** Windows of the first slice, and of any slice at least. */
const FIRST_WORK = 20_000;
const LEAST_WORK = 2_000;

/** How far the second of two meshes to warm up on is from the first; their longest sides are 1 to 2. */
const BESIDE = 0.3;

/** Calls that arrive while the module is still being compiled wait for it. */
const { promise: ready, resolve: begin } = Promise.withResolvers<wasm.InitOutput>();

interface Current extends Mesh {
  timings: Timings;
  /** Windows of the next slice of refining. */
  work: number;
  /** Whether the field is by heat: each slice of refining then ends with a solve. */
  isByHeat: boolean;
  solveMs: number;
  refineMs: number;
  /** When the last slice of refining ended. */
  refinedAt: number;
}

/** What is drawn of a mesh that is not prepared yet, and what answers on its tetrahedra, if any. */
let opened:
  | { drawing: wasm.Drawing; timings: Timings; vertices: number; inside: ReturnType<typeof innerSolver> | null }
  | undefined;
let current: Current | undefined;
let shownAs: ShownAs | undefined;
/** Fields that are asked for while the pointer drags. */
const moves = new Latest();
/** The inactive parts that move. */
let movingScenery: { part: number; scenery: wasm.Scenery }[] = [];

const api: SolverApi = {
  async start(module) {
    begin(initialise({ module_or_path: module }));
    await ready;
  },

  async warmUp() {
    await ready;
    const file = wasm.MeshFile.sphere();
    const surface = file.surface(Uint32Array.of(0), file.up());
    const drawing = surface.draw();
    drawing.shade().free();
    const solver = drawing.factor({}, () => undefined);
    const sources = [{ vertex: 0 }];
    for (const quick of [false, true]) solver.solve(sources, quick).free();
    for (const windows of [1, DEFAULT_WINDOWS]) solver.propagate(sources, windows, windows === 1).free();
    solver.refine(FIRST_WORK).free();
    lookForContacts(plain(drawing.take_mesh()));
    for (const used of [solver, drawing, surface, file]) used.free();
  },

  async open(input, parts, budget, progress, wantedUp = AUTOMATIC, most = null, fill = null) {
    await ready;
    progress({ stage: 'Reading', fraction: 0, vertices: 0 });
    const source = await sourceOf(input);
    const { name, hash } = source;
    const clock = stopwatch();
    const { file, chosen, simplified, unit, inner } = await openingOf(source, { parts, most, fill }, progress);
    const look = lookOf(file);
    const readMs = clock();
    progress({ stage: 'Welding', fraction: inner ? FILLED_FROM : BUILD_FROM, vertices: 0 });
    const names = file.part_names();
    const triangles = file.part_triangles();
    const ranges = names.map((_, part) => file.part_ranges(part));
    file.require_room(chosen, budget.windows, budget.memory === AUTOMATIC ? undefined : budget.memory);
    const upright = file.up();
    const up = wantedUp === AUTOMATIC ? upright : wantedUp;
    const surface = file.surface(chosen, up);
    const report = plain(surface.report());
    const buildMs = clock();
    const { vertices } = report;
    progress({ stage: 'Drawing', fraction: DRAW_FROM, vertices });
    const inactive = names.map((_, part) => part).filter((part) => !chosen.includes(part));
    const sceneries = inactive.map((part) => ({ part, scenery: file.scenery(part, surface) }));
    const scenery = sceneries.map(({ part, scenery: drawn }) => ({ part, mesh: plain(drawn.take_mesh()) }));
    movingScenery = sceneries.filter(({ scenery: drawn }) => drawn.moves());
    const clips = file.clips().map(plain);
    const missing = file.missing();
    const warnings = file.warnings().map(plain);
    // The file's triangles go before those that are drawn come.
    file.free();
    const drawing = surface.draw();
    const drawTransform = drawTransformOf(surface, up);
    shownAs = { transform: drawTransform, from: simplified || inner ? null : { input, parts: chosen } };
    const drawn = drawing.input_vertices();
    const interior = inner && interiorOf(inner.mesh, drawTransform);
    const inputVertices = inner ? through(drawn, inner.vertices) : drawn;
    const mesh: OpenedMesh = {
      name,
      hash,
      parts: names.map((part, index) => ({
        name: part,
        triangles: triangles[index] ?? 0,
        ranges: ranges[index] ?? new Uint32Array(),
      })),
      active: [...chosen],
      cameras: drawing.cameras().map(plain),
      lights: drawing.lights(),
      simplified,
      shade: scenery.length === 0 ? plain(drawing.shade()) : null,
      surface: plain(drawing.take_mesh()),
      ...(await look),
      clips,
      missing,
      warnings,
      ...unit,
      inputVertices,
      drawTransform,
      upright,
      scenery,
      report: interior ? { ...report, inputVertices: interior.report.inputVertices } : report,
      meanEdge: interior?.report.meanEdge ?? surface.mean_edge(),
      interior,
      weights: weightsOf(surface),
    };
    surface.free();
    const inside = inner && innerSolver(inner.mesh, inputVertices, mesh.surface.triangles, drawTransform);
    opened = { drawing, timings: { readMs, buildMs, drawMs: clock(), joinMs: 0, precomputeMs: 0 }, vertices, inside };
    return transfer(mesh, [
      ...buffersOf(mesh.surface),
      ...mesh.scenery.flatMap((part) => buffersOf(part.mesh)),
      mesh.inputVertices.buffer,
      mesh.lights.buffer,
      ...(mesh.weights ? [mesh.weights.values.buffer] : []),
      ...(interior ? [interior.positions.buffer, interior.tetrahedra.buffer] : []),
      ...(mesh.appearance?.images.filter((image) => image !== null) ?? []),
    ]);
  },

  async prepare(parameters, progress) {
    const { memory } = await ready;
    if (!opened) throw new Error('No mesh is open.');
    const { drawing, timings, vertices, inside } = opened;
    const clock = stopwatch();
    const report = (stage: string, fraction: number) => {
      progress({ stage, fraction: SOLVE_FROM + (1 - SOLVE_FROM) * fraction, vertices });
    };
    if (inside) {
      if (parameters) inside.configure(parameters, report);
      else report('Marching', 0);
      current = currentOf(innerMesh(inside), { ...timings, precomputeMs: parameters ? clock() : 0 });
    } else if (parameters) {
      const solver = drawing.factor(parameters, report);
      current = currentOf(surfaceMesh(solver), { ...timings, precomputeMs: clock() });
    } else {
      report('Propagating', 0);
      const solver = drawing.solver();
      current = currentOf(surfaceMesh(solver), { ...timings, buildMs: timings.buildMs + clock() });
    }
    drawing.free();
    opened = undefined;
    return factoringOf(current, memory);
  },

  async configure(parameters: Parameters): Promise<Factoring> {
    const { memory } = await ready;
    const mesh = openMesh();
    const clock = stopwatch();
    mesh.solver.configure(parameters, () => undefined);
    mesh.timings = { ...mesh.timings, precomputeMs: clock() };
    return factoringOf(mesh, memory);
  },

  async bridge(rule: string, links: number, posed: boolean): Promise<Factoring> {
    const { memory } = await ready;
    const mesh = openMesh();
    const clock = stopwatch();
    openSurface().bridge(rule, links, posed);
    mesh.timings = { ...mesh.timings, joinMs: clock() };
    return factoringOf(mesh, memory);
  },

  ground({ triangles, costs, lines, slope, highest }: GroundChange): Promise<void> {
    openSurface().set_ground(triangles, costs, lines, slope, highest);
    return Promise.resolve();
  },

  look(cut: InnerCut | null): Promise<InnerView | null> {
    const mesh = openMesh();
    if (mesh.inside) mesh.inside.cut = cut;
    const view = seen(mesh);
    return Promise.resolve(view ? transfer(view, viewBuffersOf(view)) : null);
  },

  neighbors(): Promise<Uint32Array> {
    const neighbors = openMesh().solver.neighbors();
    return Promise.resolve(transfer(neighbors, [neighbors.buffer]));
  },

  line(from: number, to: number): Promise<Uint32Array> {
    return Promise.resolve(openMesh().solver.line(from, to));
  },

  linksToReachMore(): Promise<number> {
    return Promise.resolve(openSurface().links_to_reach_more());
  },

  pose(moment: Moment | null, measured: boolean): Promise<Posed | null> {
    const solver = openMesh().surface;
    const surface = solver?.pose(moment?.clip, moment?.seconds ?? 0, measured);
    if (!solver || !surface) return Promise.resolve(null);
    const scenery = movingScenery.flatMap(({ part, scenery: moving }) => {
      const pose = moving.pose(moment?.clip, moment?.seconds ?? 0);
      return pose ? [{ part, pose: plain(pose) }] : [];
    });
    const path = solver.posed_path();
    const posed: Posed = { surface: plain(surface), scenery, path: path ? plain(path) : null };
    const poses = [posed.surface, ...scenery.map(({ pose }) => pose)];
    const buffers = poses.flatMap(({ positions, normals }) => [positions.buffer, normals.buffer]);
    return Promise.resolve(transfer(posed, [...buffers, ...pathBuffersOf(posed)]));
  },

  async solve(sources: Source[], quick: boolean, request: PathRequest | null): Promise<Solved | null> {
    if (quick && !(await moves.isLast())) return null;
    return firstField(true, ({ solver }) => messageOf(solver.solve(sources.map(known), quick)), request);
  },

  async propagate(
    sources: Source[],
    windows: number,
    quick: boolean,
    request: PathRequest | null,
  ): Promise<Solved | null> {
    if (quick && !(await moves.isLast())) return null;
    return firstField(false, ({ solver }) => messageOf(solver.propagate(sources.map(known), windows, quick)), request);
  },

  refine(request: PathRequest | null): Promise<Solved> {
    const mesh = openMesh();
    const clock = stopwatch();
    const shownMs = mesh.refineMs > 0 ? performance.now() - mesh.refinedAt : 0;
    const field = messageOf(openSurface().refine(mesh.work));
    const passed = clock();
    mesh.refineMs += passed;
    mesh.refinedAt = performance.now();
    const afterwards = mesh.isByHeat ? SLICE_SOLVES * mesh.solveMs : Math.min(shownMs, mesh.solveMs);
    if (field.exactBelow < Infinity) mesh.work = nextWork(mesh.work, passed, Math.max(SLICE_MS, afterwards));
    return solvedOf(field, mesh, request);
  },

  exactDistances(places: readonly MeshPoint[]): Promise<Float64Array | null> {
    const distances = openMesh().surface?.exact_distances(places.map(known)) ?? null;
    return Promise.resolve(distances && transfer(distances, [distances.buffer]));
  },

  path(request: PathRequest): Promise<TracedPath> {
    const traced = trace(openMesh(), request);
    return Promise.resolve(transfer(traced, pathBuffersOf(traced)));
  },

  searchPath(from: MeshPoint): Promise<TracedPath | null> {
    const mesh = openMesh();
    const clock = stopwatch();
    const path = pathOf(() => openSurface().search_path(known(from), mesh.work));
    const pathMs = clock();
    mesh.work = nextWork(mesh.work, pathMs, SLICE_MS);
    if (path === undefined) return Promise.resolve(null);
    const traced = { path, pathMs };
    return Promise.resolve(transfer(traced, pathBuffersOf(traced)));
  },

  measure(from: MeshPoint, to: MeshPoint): Promise<{ leg: Leg | null } | null> {
    const mesh = openMesh();
    const clock = stopwatch();
    const [start, end] = [known(from), known(to)];
    const { inside } = mesh;
    if (inside) return Promise.resolve({ leg: pathOf(() => inside.solver.measure(start, end)) ?? null });
    const leg = pathOf(() => openSurface().measure(start, end, mesh.work));
    mesh.work = nextWork(mesh.work, clock(), SLICE_MS);
    return Promise.resolve(leg === undefined ? null : { leg });
  },

  estimate(from: MeshPoint, to: MeshPoint): Promise<SurfaceLeg | null> {
    return Promise.resolve(pathOf(() => openSurface().estimate(known(from), known(to))) ?? null);
  },

  enclosed(legs: readonly SurfaceLeg[]): Promise<Enclosure> {
    const triangles = Uint32Array.from(legs.flatMap((leg) => [...leg.triangles]));
    const weights = Float64Array.from(legs.flatMap((leg) => [...leg.weights]));
    const counts = Uint32Array.from(legs, (leg) => leg.triangles.length);
    return Promise.resolve(plain(openSurface().enclosed(triangles, weights, counts)));
  },

  gradients(kind: FaceField): Promise<Float32Array> {
    const vectors = openMesh().solver.gradients(kind);
    return Promise.resolve(transfer(vectors, [vectors.buffer]));
  },

  heat(): Promise<Float32Array> {
    const heat = openMesh().solver.heat();
    return Promise.resolve(transfer(heat, [heat.buffer]));
  },

  crowd(count: number, height: number): Promise<void> {
    openMesh().solver.set_crowd(count, height);
    return Promise.resolve();
  },

  stepCrowd(step: number): Promise<Float32Array> {
    const poses = openMesh().solver.step_crowd(step);
    return Promise.resolve(transfer(poses, [poses.buffer]));
  },

  crowdTracks(): Promise<Tracks> {
    return Promise.resolve(plain(openSurface().crowd_tracks()));
  },

  edges(kind: EdgeKind): Promise<Float32Array> {
    const edges = openMesh().solver.edges(kind);
    return Promise.resolve(transfer(edges, [edges.buffer]));
  },

  errors(): Promise<Float32Array | null> {
    const errors = openMesh().surface?.errors();
    return Promise.resolve(errors ? transfer(errors, [errors.buffer]) : null);
  },

  convergence(): Promise<Convergence> {
    return Promise.resolve(plain(openSurface().convergence()));
  },

  pathProfile(): Promise<Float64Array | null> {
    return Promise.resolve(openSurface().path_profile() ?? null);
  },

  async isolines(wish) {
    return (await curves()).isolines(openSurface(), wish, shownAs);
  },

  async curveFile(wish, file) {
    return (await curves()).curveFile(openSurface(), wish, file, shownAs);
  },

  async distanceFile(kind) {
    return (await curves()).distanceFile(openSurface(), kind, shownAs);
  },

  innerDistanceFile(kind: InnerDistanceFile) {
    const { inside } = openMesh();
    if (!inside) throw new Error('Only tetrahedra can be asked this, and the mesh is a surface.');
    const bytes = inside.solver.file(kind) as Uint8Array<ArrayBuffer>;
    return Promise.resolve(transfer(bytes, [bytes.buffer]));
  },
};

function currentOf(mesh: Mesh, timings: Timings): Current {
  return { ...mesh, timings, work: FIRST_WORK, isByHeat: false, solveMs: 0, refineMs: 0, refinedAt: 0 };
}

function openMesh(): Current {
  if (!current) throw new Error('No mesh is open.');
  return current;
}

/** The solver rejects a place that the mesh does not have. */
function known(place: MeshPoint): wasm.Source {
  return place as unknown as wasm.Source;
}

const curves = () => import('./curves');

function openSurface(): wasm.Solver {
  const { surface } = openMesh();
  if (!surface) throw new Error('Only a surface can be asked this, and the mesh is one of tetrahedra.');
  return surface;
}

function factoringOf({ solver, surface, timings }: Current, memory: WebAssembly.Memory): Factoring {
  return {
    timings,
    groups: surface?.groups() ?? 0,
    contacts: surface?.contacts() ?? 0,
    contactsComplete: surface?.contacts_complete() ?? true,
    crackPortals: surface?.crack_portals() ?? 0,
    crackGap: surface?.crack_gap() ?? 0,
    links: surface?.links() ?? 0,
    linkedGap: surface?.linked_gap() ?? 0,
    factorNonzeros: solver.factor_nonzeros(),
    memoryBytes: memory.buffer.byteLength + interiorBytes(),
  };
}

/** What a field is before any refinement. */
function firstField(
  isByHeat: boolean,
  answer: (mesh: Mesh) => SolvedField,
  request: PathRequest | null,
): Promise<Solved> {
  const mesh = openMesh();
  const clock = stopwatch();
  const field = answer(mesh);
  if (mesh.inside) mesh.inside.hasField = true;
  mesh.solveMs = clock();
  mesh.refineMs = 0;
  mesh.isByHeat = isByHeat;
  return solvedOf(field, mesh, request);
}

function solvedOf(found: SolvedField, mesh: Current, request: PathRequest | null): Promise<Solved> {
  const solved: Solved = { field: fieldOf(found, mesh), inside: seen(mesh), ...trace(mesh, request) };
  const { distance, tangents, inner } = solved.field;
  return Promise.resolve(
    transfer(solved, [
      distance.buffer,
      tangents.buffer,
      ...(inner ? [inner.buffer] : []),
      ...(solved.inside ? viewBuffersOf(solved.inside) : []),
      ...pathBuffersOf(solved),
    ]),
  );
}

function fieldOf(found: SolvedField, { solver, solveMs, refineMs }: Current): DistanceField {
  const { meanError: mean, maxError: max, inner = null, ...solved } = found;
  const error = mean !== undefined && max !== undefined ? { mean, max } : null;
  return { ...solved, inner, tangents: solver.tangents(), error, solveMs, refineMs };
}

/** What is seen of the inside with the last field. */
function seen({ inside }: Mesh): InnerView | null {
  return inside?.cut && inside.hasField ? plain(inside.solver.view(inside.cut)) : null;
}

function viewBuffersOf(view: InnerView): Transferable[] {
  return Object.values(view).flatMap((part) => (typeof part === 'boolean' ? [] : [part.buffer]));
}

function trace({ solver }: Current, request: PathRequest | null): TracedPath {
  const clock = stopwatch();
  const path = request && pathOf(() => solver.path(known(request.from), request.kind));
  return { path: path ?? null, pathMs: clock() };
}

/** Between a mesh and the same one beside it, which it pierces. */
function lookForContacts({ positions, triangles }: Pick<DrawMesh, 'positions' | 'triangles'>): void {
  const both = new Float32Array(2 * positions.length);
  both.set(positions);
  both.set(
    positions.map((coordinate, index) => coordinate + (index % 3 === 0 ? BESIDE : 0)),
    positions.length,
  );
  const faces = new Uint32Array(2 * triangles.length);
  faces.set(triangles);
  faces.set(
    triangles.map((vertex) => vertex + positions.length / 3),
    triangles.length,
  );
  const file = wasm.MeshFile.arrays('', both, faces);
  const surface = file.surface(Uint32Array.of(0), file.up());
  const drawing = surface.draw();
  const solver = drawing.solver();
  solver.bridge('auto', 0, false);
  for (const used of [solver, drawing, surface, file]) used.free();
}

/** Null where there is no path: no source is reached from there. Undefined where none is found yet. */
function pathOf<T extends { toJSON(): object; free(): void }>(find: () => T | undefined): Plain<T> | null | undefined {
  try {
    const found = find();
    return found && plain(found);
  } catch (error) {
    if (error instanceof Error && (isTrap(error) || isOutOfMemory(error))) throw error;
    return null;
  }
}

/** Windows of the next slice: one that was held up must not make the next ones tiny, nor a quick one the next endless. */
function nextWork(work: number, passed: number, wanted: number): number {
  const change = Math.min(2, Math.max(0.5, wanted / Math.max(1, passed)));
  return Math.max(LEAST_WORK, Math.round(work * change));
}

function pathBuffersOf({ path }: Pick<TracedPath, 'path'>): Transferable[] {
  return path ? [path.points.buffer, path.normals.buffer, path.segmentCosts.buffer] : [];
}

function weightsOf(surface: wasm.ActiveSurface): OpenedMesh['weights'] {
  const name = surface.weights_name();
  return name === undefined ? null : { name, values: surface.weights() };
}

function drawTransformOf(surface: wasm.ActiveSurface, up: Up): DrawTransform {
  const [x = NaN, y = NaN, z = NaN, scale = NaN] = surface.draw_transform();
  return { center: [x, y, z], scale, up };
}

function buffersOf({ positions, normals, triangles, order, boxes, texcoords, colors, runs }: DrawMesh): Transferable[] {
  return [positions, normals, triangles, order, boxes, texcoords, colors, runs].map(({ buffer }) => buffer);
}

/** Milliseconds since the last call. */
function stopwatch(): () => number {
  let before = performance.now();
  return () => {
    const now = performance.now();
    const passed = now - before;
    before = now;
    return passed;
  };
}

expose(api);
