/** What answers of the engine are made of, which alone calls this: the field, paths on it, and what both depend on. */
import type {
  DistanceField,
  DrawPath,
  GroundChange,
  InnerCut,
  InnerView,
  MeshPoint,
  Moment,
  PathRequest,
  Posed,
  Solved,
  Source,
  TracedPath,
} from '../../../protocol';
import type * as wasm from '../../../wasm/solver/heatwalk_worker.js';
import type { WithLengths } from '../../../length';
import { Latest } from '../../latest';
import { nextWork, SLICE_MS, stopwatch } from '../clock';
import { known, type Mesh, openMesh, openSurface, pathOf } from '../mesh';

/**
 * A slice of refining lasts longer than others where what comes after it takes longer: this many solves by heat, since each slice
 * ends with one, or else as long as showing the field takes, but no longer than finding it took.
 */
const SLICE_SOLVES = 2;

/** Fields that are asked for while the pointer drags. */
const moves = new Latest();

/**
 * By heat, which needs factors. `quick`: with a small exact region whatever the parameters, during a drag; null: another
 * quick field was asked for before this one was begun.
 */
export async function solve(sources: Source[], quick: boolean, request: PathRequest | null): Promise<Solved | null> {
  if (quick && !(await moves.isLast())) return null;
  return firstField(true, quick, ({ solver }) => solver.solve(sources.map(known), quick), request);
}

/** By `windows` of each half-edge, with or without factors. Quick ones are overtaken as those by heat are. */
export async function propagate(
  sources: Source[],
  windows: number,
  quick: boolean,
  request: PathRequest | null,
): Promise<Solved | null> {
  if (quick && !(await moves.isLast())) return null;
  return firstField(false, quick, ({ solver }) => solver.propagate(sources.map(known), windows, quick), request);
}

/**
 * One step of making the last field exact, from the sources outward: exact inside, as it was beyond. Takes 100 to
 * 200 ms, more where a solve by heat or showing the field takes longer; the next call goes on. Once all is exact, the
 * field stays as it is.
 */
export function refine(request: PathRequest | null): Solved {
  const mesh = openMesh();
  const clock = stopwatch();
  const shownMs = mesh.refineMs > 0 ? performance.now() - mesh.refinedAt : 0;
  const field = openSurface().refine(mesh.work);
  const passed = clock();
  mesh.refineMs += passed;
  mesh.refinedAt = performance.now();
  const afterwards = mesh.isByHeat ? SLICE_SOLVES * mesh.solveMs : Math.min(shownMs, mesh.solveMs);
  if (field.exactBelow < Infinity) mesh.work = nextWork(mesh.work, passed, Math.max(SLICE_MS, afterwards));
  return solvedOf(field, mesh, request);
}

/** A path on the last field. */
export function path(request: PathRequest): TracedPath {
  return trace(openMesh(), request);
}

/** One step of searching the exact path, of 100 to 200 ms; null: it is not found yet, and the next call goes on. */
export function searchPath(from: MeshPoint): TracedPath | null {
  const mesh = openMesh();
  const clock = stopwatch();
  const found = pathOf(() => openSurface().search_path(known(from), mesh.work));
  const pathMs = clock();
  mesh.work = nextWork(mesh.work, pathMs, SLICE_MS);
  return found === undefined ? null : { path: found as DrawPath | null, pathMs };
}

/**
 * Changes the ground: triangles that are painted anew and their costs, Infinity for walls; all closed walls along edges; and
 * what slope and height cost. The last field is forgotten, and what is factored is factored anew by the next `solve`.
 */
export function ground({ triangles, costs, lines, slope, highest }: GroundChange): void {
  openSurface().set_ground(triangles, costs, lines, slope, highest);
}

/** How the inside of tetrahedra is looked into from now on; null: not at all. What is seen of it with the last field. */
export function look(cut: InnerCut | null): InnerView | null {
  const mesh = openMesh();
  if (mesh.inside) mesh.inside.cut = cut;
  return seen(mesh);
}

/**
 * Shows the mesh as it is at a moment, with null as in its file; null where it does not move. What the other calls give is
 * drawn there. Distances are `measured` in that pose from now on, and the last field is forgotten; or in that of the file.
 */
export function pose(moment: Moment | null, measured: boolean): Posed | null {
  const { surface: solver, shownAs } = openMesh();
  const [clip, seconds] = [moment?.clip, moment?.seconds ?? 0];
  const surface = solver?.pose(clip, seconds, measured);
  if (!solver || !surface) return null;
  const scenery = shownAs.moving.flatMap(({ part, scenery: moving }) => {
    const posed = moving.pose(clip, seconds);
    return posed ? [{ part, pose: posed }] : [];
  });
  return { surface, scenery, path: (solver.posed_path() as DrawPath | undefined) ?? null };
}

/** What a field is before any refinement. */
function firstField(
  isByHeat: boolean,
  quick: boolean,
  answer: (mesh: Mesh) => wasm.Field,
  request: PathRequest | null,
): Solved {
  const mesh = openMesh();
  const clock = stopwatch();
  const field = answer(mesh);
  if (mesh.inside) mesh.inside.hasField = true;
  mesh.solveMs = clock();
  mesh.refineMs = 0;
  mesh.isByHeat = isByHeat;
  return solvedOf(field, mesh, request, quick);
}

function solvedOf(found: wasm.Field, mesh: Mesh, request: PathRequest | null, quick = false): Solved {
  const field = fieldOf(found, mesh);
  const finer = mesh.shownAs.between?.(field, mesh.surface, quick);
  return { field: finer ? { ...field, finer } : field, inside: seen(mesh), ...trace(mesh, request) };
}

/** What is seen of the inside with the last field. */
function seen({ inside }: Mesh): InnerView | null {
  return inside?.cut && inside.hasField ? inside.solver.view(inside.cut) : null;
}

function fieldOf({ inner, error, ...found }: wasm.Field, { solver, solveMs, refineMs }: Mesh): DistanceField {
  const measured = found as WithLengths<typeof found, 'maxDistance' | 'exactBelow'>;
  return { ...measured, inner: inner ?? null, error: error ?? null, tangents: solver.tangents(), solveMs, refineMs };
}

function trace({ solver }: Mesh, request: PathRequest | null): TracedPath {
  const clock = stopwatch();
  const found = request && pathOf(() => solver.path(known(request.from), request.kind));
  return { path: (found ?? null) as DrawPath | null, pathMs: clock() };
}
