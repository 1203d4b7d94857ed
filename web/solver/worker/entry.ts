/** The worker: the solver's wasm module behind the interface of protocol.ts. */
import { expose, transfer } from 'comlink';
import type {
  Appearance,
  DistanceField,
  DrawMesh,
  DrawTransform,
  EdgeKind,
  FaceField,
  GroundChange,
  Factoring,
  MeshInput,
  Moment,
  OpenedMesh,
  Parameters,
  Plain,
  Posed,
  ProgressListener,
  Simplified,
  Solved,
  SolverApi,
  Source,
  SurfacePath,
  Timings,
  TracedPath,
  PathRequest,
  SurfacePoint,
} from '../../protocol';
import initialise, * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { AUTOMATIC, DEFAULT_WINDOWS, type Up } from '../../wasm/contract';
import { fileName } from '../../files/paths';
import { isOutOfMemory, isTrap } from '../trap';
import { decodeImages } from './images';
import { simplify } from './simplify';
import { type Files, filesOf, readMesh, unpackedOf } from './files';

/** Where simplifying, building, drawing and what comes after begin in the time that opening takes, for the progress bar. */
const SIMPLIFY_FROM = 0.05;
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

/** Ten thousand points: enough for every kernel to run often, and over before anybody opens a mesh. */
const WARM_UP_SHAPE = 'icosphere';

/** Calls that arrive while the module is still being compiled wait for it. */
const { promise: ready, resolve: begin } = Promise.withResolvers<wasm.InitOutput>();

interface Current {
  solver: wasm.Solver;
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

/** What is drawn of a mesh that is not prepared yet. */
let opened: { drawing: wasm.Drawing; timings: Timings; vertices: number } | undefined;
let current: Current | undefined;
/** The inactive parts that move. */
let movingScenery: { part: number; scenery: wasm.Scenery }[] = [];

const api: SolverApi = {
  async start(module) {
    begin(initialise({ module_or_path: module }));
    await ready;
  },

  async warmUp() {
    await ready;
    const file = wasm.MeshFile.shape(WARM_UP_SHAPE);
    const surface = file.surface(Uint32Array.of(0), file.up());
    const drawing = surface.draw();
    drawing.shade().free();
    const solver = drawing.factor({}, () => undefined);
    const sources = [{ vertex: 0 }];
    for (const quick of [false, true]) solver.solve(sources, quick).free();
    for (const windows of [1, DEFAULT_WINDOWS]) solver.propagate(sources, windows).free();
    solver.refine(FIRST_WORK).free();
    for (const used of [solver, drawing, surface, file]) used.free();
  },

  async open(input, parts, room, progress, wantedUp = AUTOMATIC, most = null) {
    await ready;
    progress({ stage: 'Reading', fraction: 0, vertices: 0 });
    const { name, hash, read } = await sourceOf(input);
    const clock = stopwatch();
    const { file, chosen, simplified } = await fewer(read(), name, parts, most, progress);
    const look = lookOf(file);
    const readMs = clock();
    progress({ stage: 'Welding', fraction: BUILD_FROM, vertices: 0 });
    const names = file.part_names();
    const triangles = file.part_triangles();
    file.require_room(chosen, room.windows, room.memory === AUTOMATIC ? undefined : room.memory);
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
    const [missing, unit, unitAssumed] = [file.missing(), file.unit(), file.is_unit_assumed()];
    // The file's triangles go before those that are drawn come.
    file.free();
    const drawing = surface.draw();
    const mesh: OpenedMesh = {
      name,
      hash,
      parts: names.map((part, index) => ({ name: part, triangles: triangles[index] ?? 0 })),
      active: [...chosen],
      cameras: drawing.cameras().map(plain),
      lights: drawing.lights(),
      simplified,
      shade: scenery.length === 0 ? plain(drawing.shade()) : null,
      surface: plain(drawing.take_mesh()),
      ...(await look),
      clips,
      missing,
      unit,
      unitAssumed,
      inputVertices: drawing.input_vertices(),
      drawTransform: drawTransformOf(surface, up),
      upright,
      scenery,
      report,
      meanEdge: surface.mean_edge(),
    };
    surface.free();
    opened = { drawing, timings: { readMs, buildMs, drawMs: clock(), joinMs: 0, precomputeMs: 0 }, vertices };
    return transfer(mesh, [
      ...buffersOf(mesh.surface),
      ...mesh.scenery.flatMap((part) => buffersOf(part.mesh)),
      mesh.inputVertices.buffer,
      mesh.lights.buffer,
      ...(mesh.appearance?.images.filter((image) => image !== null) ?? []),
    ]);
  },

  async prepare(parameters, progress) {
    const { memory } = await ready;
    if (!opened) throw new Error('No mesh is open.');
    const { drawing, timings, vertices } = opened;
    const clock = stopwatch();
    if (parameters) {
      const solver = drawing.factor(parameters, (stage: string, fraction: number) => {
        progress({ stage, fraction: SOLVE_FROM + (1 - SOLVE_FROM) * fraction, vertices });
      });
      current = currentOf(solver, { ...timings, precomputeMs: clock() });
    } else {
      progress({ stage: 'Propagating', fraction: SOLVE_FROM, vertices });
      const solver = drawing.solver();
      current = currentOf(solver, { ...timings, buildMs: timings.buildMs + clock() });
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

  async bridge(rule: string, links: number): Promise<Factoring> {
    const { memory } = await ready;
    const mesh = openMesh();
    const clock = stopwatch();
    mesh.solver.bridge(rule, links);
    mesh.timings = { ...mesh.timings, joinMs: clock() };
    return factoringOf(mesh, memory);
  },

  ground({ triangles, costs, lines, slope, highest }: GroundChange): Promise<void> {
    openMesh().solver.set_ground(triangles, costs, lines, slope, highest);
    return Promise.resolve();
  },

  neighbors(): Promise<Uint32Array> {
    const neighbors = openMesh().solver.neighbors();
    return Promise.resolve(transfer(neighbors, [neighbors.buffer]));
  },

  line(from: number, to: number): Promise<Uint32Array> {
    return Promise.resolve(openMesh().solver.line(from, to));
  },

  linksToReachMore(): Promise<number> {
    return Promise.resolve(openMesh().solver.links_to_reach_more());
  },

  pose(moment: Moment | null, measured: boolean): Promise<Posed | null> {
    const { solver } = openMesh();
    const surface = solver.pose(moment?.clip, moment?.seconds ?? 0, measured);
    if (!surface) return Promise.resolve(null);
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

  solve(sources: Source[], quick: boolean, request: PathRequest | null): Promise<Solved> {
    return firstField(true, (solver) => solver.solve(sources, quick), request);
  },

  propagate(sources: Source[], windows: number, request: PathRequest | null): Promise<Solved> {
    return firstField(false, (solver) => solver.propagate(sources, windows), request);
  },

  refine(request: PathRequest | null): Promise<Solved> {
    const mesh = openMesh();
    const clock = stopwatch();
    const shownMs = mesh.refineMs > 0 ? performance.now() - mesh.refinedAt : 0;
    const field = mesh.solver.refine(mesh.work);
    const passed = clock();
    mesh.refineMs += passed;
    mesh.refinedAt = performance.now();
    const afterwards = mesh.isByHeat ? SLICE_SOLVES * mesh.solveMs : Math.min(shownMs, mesh.solveMs);
    if (field.exactBelow < Infinity) mesh.work = nextWork(mesh.work, passed, Math.max(SLICE_MS, afterwards));
    return solvedOf(field, mesh, request);
  },

  path(request: PathRequest): Promise<TracedPath> {
    const traced = trace(openMesh(), request);
    return Promise.resolve(transfer(traced, pathBuffersOf(traced)));
  },

  searchPath(from: SurfacePoint): Promise<TracedPath | null> {
    const mesh = openMesh();
    const clock = stopwatch();
    const path = pathOf(() => mesh.solver.search_path(from, mesh.work));
    const pathMs = clock();
    mesh.work = nextWork(mesh.work, pathMs, SLICE_MS);
    if (path === undefined) return Promise.resolve(null);
    const traced = { path, pathMs };
    return Promise.resolve(transfer(traced, pathBuffersOf(traced)));
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

  edges(kind: EdgeKind): Promise<Float32Array> {
    const edges = openMesh().solver.edges(kind);
    return Promise.resolve(transfer(edges, [edges.buffer]));
  },

  errors(): Promise<Float32Array | null> {
    const errors = openMesh().solver.errors();
    return Promise.resolve(errors ? transfer(errors, [errors.buffer]) : null);
  },

  async shapes(): Promise<string[]> {
    await ready;
    return wasm.shape_names();
  },
};

function currentOf(solver: wasm.Solver, timings: Timings): Current {
  return { solver, timings, work: FIRST_WORK, isByHeat: false, solveMs: 0, refineMs: 0, refinedAt: 0 };
}

function openMesh(): Current {
  if (!current) throw new Error('No mesh is open.');
  return current;
}

function factoringOf({ solver, timings }: Current, memory: WebAssembly.Memory): Factoring {
  return {
    timings,
    groups: solver.groups(),
    contacts: solver.contacts(),
    links: solver.links(),
    linkedGap: solver.linked_gap(),
    factorNonzeros: solver.factor_nonzeros(),
    memoryBytes: memory.buffer.byteLength,
  };
}

/** What a field is before any refinement. */
function firstField(
  isByHeat: boolean,
  answer: (solver: wasm.Solver) => wasm.Field,
  request: PathRequest | null,
): Promise<Solved> {
  const mesh = openMesh();
  const clock = stopwatch();
  const field = answer(mesh.solver);
  mesh.solveMs = clock();
  mesh.refineMs = 0;
  mesh.isByHeat = isByHeat;
  return solvedOf(field, mesh, request);
}

function solvedOf(field: wasm.Field, mesh: Current, request: PathRequest | null): Promise<Solved> {
  const solved: Solved = { field: fieldOf(field, mesh), ...trace(mesh, request) };
  return Promise.resolve(
    transfer(solved, [solved.field.distance.buffer, solved.field.tangents.buffer, ...pathBuffersOf(solved)]),
  );
}

function fieldOf(field: wasm.Field, { solver, solveMs, refineMs }: Current): DistanceField {
  const { meanError: mean, maxError: max, ...solved } = plain(field);
  const error = mean !== undefined && max !== undefined ? { mean, max } : null;
  return { ...solved, tangents: solver.tangents(), error, solveMs, refineMs };
}

function trace({ solver }: Current, request: PathRequest | null): TracedPath {
  const clock = stopwatch();
  const path = request && pathOf(() => solver.path(request.from, request.kind));
  return { path: path ?? null, pathMs: clock() };
}

/** Null where there is no path: no source is reached from there. Undefined where none is found yet. */
function pathOf(find: () => wasm.SurfacePath | undefined): SurfacePath | null | undefined {
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

interface MeshSource {
  name: string;
  hash: string;
  read: () => wasm.MeshFile;
}

async function sourceOf(input: MeshInput): Promise<MeshSource> {
  switch (input.kind) {
    case 'files':
      return sourceIn(filesOf(input.files), input.mesh);
    case 'archive':
      return sourceIn(await unpackedOf(input.archive), input.mesh);
    case 'shape':
      return { name: input.shape, hash: '', read: () => wasm.MeshFile.shape(input.shape) };
    case 'arrays': {
      const { name, positions, triangles } = input;
      return { name, hash: '', read: () => wasm.MeshFile.arrays(name, positions, triangles) };
    }
  }
}

async function sourceIn(files: Files, mesh: string): Promise<MeshSource> {
  const bytes = files.read(mesh);
  return { name: fileName(mesh), hash: await hashOf(bytes), read: () => readMesh(mesh, bytes, files) };
}

/** What the module gave, as a message; its memory is given back. */
function plain<T extends { toJSON(): object; free(): void }>(given: T): Plain<T> {
  const message = given.toJSON() as Plain<T>;
  given.free();
  return message;
}

/** The chosen parts of a file; a simplified model of these as the only part where they have more triangles than are wanted. */
async function fewer(
  file: wasm.MeshFile,
  name: string,
  parts: readonly number[],
  most: number | null,
  progress: ProgressListener,
): Promise<{ file: wasm.MeshFile; chosen: Uint32Array; simplified: Simplified | null }> {
  const sizes = file.part_triangles();
  const chosen = Uint32Array.from(parts.length > 0 ? parts : sizes.keys());
  if (most === null || chosen.reduce((sum, part) => sum + (sizes[part] ?? 0), 0) <= most) {
    return { file, chosen, simplified: null };
  }
  progress({ stage: 'Simplifying', fraction: SIMPLIFY_FROM, vertices: 0 });
  const less = await simplify(file, chosen, name, most);
  file.free();
  return { ...less, chosen: Uint32Array.of(0) };
}

/** What a file says of its looks; its images are decoded while the surface is built. */
async function lookOf(file: wasm.MeshFile): Promise<{ appearance: Appearance | null; undecoded: string[] }> {
  if (!file.has_appearance()) return { appearance: null, undecoded: [] };
  const materials = file.materials().map(plain);
  const { images, undecoded } = await decodeImages(file.images().map(plain));
  return { appearance: { materials, images }, undecoded };
}

function drawTransformOf(surface: wasm.ActiveSurface, up: Up): DrawTransform {
  const [x, y, z, scale] = surface.draw_transform();
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

/** SHA-256 of a file; empty where the browser offers none (pages that are not served over HTTPS). */
async function hashOf(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  if (!('subtle' in crypto)) return '';
  const digest = await crypto.subtle.digest('SHA-256', bytes);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

expose(api);
