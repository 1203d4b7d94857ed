/** Opens the mesh of this worker, and makes it ready to be asked. */
import { ofModel, type WithLengths } from '../../../length';
import type {
  BuildReport,
  Factoring,
  FinerPlaces,
  MemoryBudget,
  MeshInput,
  OpenedMesh,
  ProgressListener,
  Timings,
} from '../../../protocol';
import type { InnerSolver } from '../../../wasm/interior/heatwalk_interior';
import { AUTOMATIC, type Parameters, type Stage, type Up } from '../../../wasm/contract';
import initialise, * as wasm from '../../../wasm/solver/heatwalk_worker.js';
import { stopwatch } from '../clock';
import { innerSolver, interiorBytes, interiorOf } from '../interior';
import { type Mesh, openMesh, openSurface, type ShownAs, setMesh } from '../mesh';
import { FILLED_FROM, lookOf, openingOf, sourceOf } from '../opening';
import { through } from '../through';
import { readTriangle } from '../reader';
import { solveSmallShapes } from '../warming';

/** Where building, drawing and what comes after begin in the time that opening takes, for the progress bar. */
const BUILD_FROM = 0.1;
const DRAW_FROM = 0.3;
const SOLVE_FROM = 0.4;

/** Of a mesh that has no components to join. */
const NOT_JOINED: wasm.Joined = {
  groups: 0,
  contacts: 0,
  contactsComplete: true,
  crackPortals: 0,
  crackGap: 0,
  links: 0,
  linkedGap: 0,
};

/** Calls that arrive while the module is still being compiled wait for it. */
const { promise: ready, resolve: begin } = Promise.withResolvers<wasm.InitOutput>();

/** What is drawn of a mesh that is not prepared yet, and what answers on its tetrahedra, if any. */
let opened:
  | {
      drawing: wasm.Drawing;
      shownAs: ShownAs;
      timings: Timings;
      vertices: number;
      inside: InnerSolver | null;
    }
  | undefined;

/** The solver's module, compiled once by the page for all its workers. */
export async function start(module: WebAssembly.Module): Promise<void> {
  begin(initialise({ module_or_path: module }));
  await ready;
}

/** Solves small shapes and reads a small file, so that the browser has optimised this code before a mesh comes. */
export async function warmUp(): Promise<void> {
  await ready;
  solveSmallShapes();
  // Where the reader is not to be had, the next file says so.
  await readTriangle().catch(() => undefined);
}

/**
 * Reads and welds a mesh, the only one of this worker, where it fits into memory. `parts`: the indices to walk on, empty
 * for all. `wantedUp`: the axis that points up where it is drawn. `most`: a mesh of more triangles is simplified to this number, as
 * one part without materials. `fill`: what the surface encloses is filled with about this number of tetrahedra.
 */
export async function open(
  input: MeshInput,
  parts: number[],
  budget: MemoryBudget,
  progress: ProgressListener,
  wantedUp: Up | typeof AUTOMATIC = AUTOMATIC,
  most: number | null = null,
  fill: number | null = null,
): Promise<OpenedMesh> {
  await ready;
  progress({ stage: 'Reading', fraction: 0, vertices: 0 });
  const source = await sourceOf(input);
  const { name, hash } = source;
  const clock = stopwatch();
  const { file, isCloud, chosen, simplified, unit, inner } = await openingOf(source, { parts, most, fill }, progress);
  const look = lookOf(file);
  const readMs = clock();
  progress({ stage: 'Welding', fraction: inner ? FILLED_FROM : BUILD_FROM, vertices: 0 });
  const contents = file.contents();
  file.require_room(chosen, budget.windows, budget.memory === AUTOMATIC ? undefined : budget.memory);
  const surface = file.surface(chosen, wantedUp === AUTOMATIC ? contents.upright : wantedUp);
  const report = surface.report();
  const buildMs = clock();
  const { vertices } = report;
  progress({ stage: 'Drawing', fraction: DRAW_FROM, vertices });
  const inactive = [...contents.parts.keys()].filter((part) => !chosen.includes(part));
  const sceneries = inactive.map((part) => ({ part, scenery: file.scenery(part, surface) }));
  const scenery = sceneries.map(({ part, scenery: drawn }) => ({ part, mesh: drawn.take_mesh() }));
  // The file's triangles go before those that are drawn come.
  file.free();
  const drawing = surface.draw();
  const drawTransform = surface.draw_transform();
  const drawn = drawing.input_vertices();
  const interior = inner && interiorOf(inner.mesh, drawTransform);
  const inputVertices = inner ? through(drawn, inner.vertices) : drawn;
  const mesh: OpenedMesh = {
    name,
    hash,
    ...contents,
    ...unit,
    active: [...chosen],
    cameras: drawing.cameras(),
    lights: drawing.lights(),
    simplified,
    isCloud,
    shade: scenery.length === 0 ? drawing.shade() : null,
    surface: drawing.take_mesh(),
    ...(await look),
    inputVertices,
    drawTransform,
    scenery,
    report: (interior ? { ...report, inputVertices: interior.report.inputVertices } : report) as BuildReport,
    meanEdge: ofModel(interior?.report.meanEdge ?? surface.mean_edge()),
    interior,
    weights: surface.weights() ?? null,
  };
  surface.free();
  opened = {
    drawing,
    shownAs: {
      transform: drawTransform,
      from: simplified || inner ? null : { input, parts: chosen },
      moving: sceneries.filter(({ scenery: other }) => other.moves()),
    },
    timings: { readMs, buildMs, drawMs: clock(), joinMs: 0, precomputeMs: 0 },
    vertices,
    inside: inner && innerSolver(inner.mesh, inputVertices, mesh.surface.triangles, drawTransform),
  };
  return mesh;
}

/** From now on answers have the exact distances at these places, too, where they are known. To be called before `prepare`. */
export async function drawBetween(places: FinerPlaces): Promise<void> {
  const { distancesAt } = await import('../between');
  if (opened) opened.shownAs.between = distancesAt(places);
}

/** Factors the mesh for the heat method with these parameters; with null, for propagation alone, nothing. To be called once. */
export function prepare(parameters: Parameters | null, progress: ProgressListener): Promise<Factoring> {
  if (!opened) throw new Error('No mesh is open.');
  const { drawing, shownAs, timings, vertices, inside } = opened;
  const clock = stopwatch();
  const report = (stage: Stage | 'Marching' | 'Propagating', fraction: number) => {
    progress({ stage, fraction: SOLVE_FROM + (1 - SOLVE_FROM) * fraction, vertices });
  };
  let mesh: Mesh;
  if (inside) {
    if (parameters) inside.configure(parameters, report);
    else report('Marching', 0);
    mesh = setMesh({ inside }, shownAs, { ...timings, precomputeMs: parameters ? clock() : 0 });
  } else if (parameters) {
    const surface = drawing.factor(parameters, report);
    mesh = setMesh({ surface }, shownAs, { ...timings, precomputeMs: clock() });
  } else {
    report('Propagating', 0);
    const surface = drawing.solver();
    mesh = setMesh({ surface }, shownAs, { ...timings, buildMs: timings.buildMs + clock() });
  }
  drawing.free();
  opened = undefined;
  return factoringOf(mesh);
}

/** Factors again what the change needs, where anything is factored. The last field is forgotten. */
export function configure(parameters: Parameters): Promise<Factoring> {
  const mesh = openMesh();
  const clock = stopwatch();
  mesh.solver.configure(parameters, () => undefined);
  mesh.timings = { ...mesh.timings, precomputeMs: clock() };
  return factoringOf(mesh);
}

/**
 * Joins components between which paths are to lead: "auto" those that pierce or nearly touch each other, "off" none, else
 * those no farther apart than so much, in the unit of the file. Of the groups that stay apart, so many pairs are linked, the
 * nearest first. `posed`: where they meet in the pose that is shown, not in that of the file. The last field is forgotten.
 */
export function bridge(rule: string, links: number, posed: boolean): Promise<Factoring> {
  const mesh = openMesh();
  const clock = stopwatch();
  openSurface().bridge(rule, links, posed);
  mesh.timings = { ...mesh.timings, joinMs: clock() };
  return factoringOf(mesh);
}

async function factoringOf({ solver, surface, timings }: Mesh): Promise<Factoring> {
  const { memory } = await ready;
  return {
    timings,
    ...((surface?.joined() ?? NOT_JOINED) as WithLengths<wasm.Joined, 'crackGap' | 'linkedGap'>),
    factorNonzeros: solver.factor_nonzeros(),
    memoryBytes: memory.buffer.byteLength + interiorBytes(),
  };
}
