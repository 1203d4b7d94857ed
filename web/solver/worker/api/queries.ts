/** What an open mesh can be asked beside the field: each function here is a call of the page's, by `Engine.queries`. */
import type {
  CellWish,
  CurveDistances,
  CurveFile,
  CurveWish,
  DecalWish,
  DistanceFile,
  DrawPath,
  EdgeKind,
  Enclosure,
  FoundCells,
  DirectionWish,
  FoundPaths,
  PathCurves,
  PathWish,
  FaceField,
  InnerDistanceFile,
  Isolines,
  IsolineWish,
  LaidDecal,
  Leg,
  MeshPoint,
  SavedCurves,
  GirthFile,
  Plane,
  SpreadWish,
  SurfaceLeg,
} from '../../../protocol';
import type { LengthUnit } from '../../../length';
import type * as wasm from '../../../wasm/solver/heatwalk_worker.js';
import { nextWork, SLICE_MS, stopwatch } from '../clock';
import type { Bytes } from '../files';
import { known, openMesh, openSurface, pathOf } from '../mesh';

const curves = () => import('../curves');

/** #F × 3, the drawn triangles beside each; itself at the boundary. */
export function neighbors(): Uint32Array {
  return openMesh().solver.neighbors();
}

/** The shortest line along edges from one vertex of the input to another, both included. */
export function line(from: number, to: number): Uint32Array {
  return openMesh().solver.line(from, to);
}

/**
 * With how many links, at least, the sources of the last field reach more than they do; as many as there are where nothing is
 * left to link.
 */
export function linksToReachMore(): number {
  return openSurface().links_to_reach_more();
}

/** Whether what is factored is the same for every operator. */
export function operatorsAgree(): boolean {
  return openMesh().surface?.operators_agree() ?? false;
}

/**
 * The last field at places of a surface, in the file's unit, Infinity where no source reaches them; null until all of it is exact,
 * and inside of tetrahedra.
 */
export function exactDistances(places: readonly MeshPoint[]): Float64Array | null {
  return openMesh().surface?.exact_distances(places.map(known)) ?? null;
}

/** The last field at a place, in the file's unit, Infinity where no source reaches it: the best that is known there. */
export function distanceAt(place: MeshPoint): number {
  return openMesh().solver.distance_at(known(place));
}

/**
 * One step of searching the exact path between two places, of 100 to 200 ms, beside the last field; null: it is not found yet,
 * and the next call goes on. Its `leg` is null where no path leads there. Inside of tetrahedra a shortest path is found at once.
 */
export function measure(from: MeshPoint, to: MeshPoint): { leg: Leg | null } | null {
  const mesh = openMesh();
  const clock = stopwatch();
  const [start, end] = [known(from), known(to)];
  const { inside } = mesh;
  if (inside) return { leg: pathOf(() => inside.solver.measure(start, end) as DrawPath | undefined) ?? null };
  const leg = pathOf(() => openSurface().measure(start, end, mesh.work));
  mesh.work = nextWork(mesh.work, clock(), SLICE_MS);
  return leg === undefined ? null : { leg: leg as SurfaceLeg | null };
}

/** A locally shortest path between two places of a surface, or one of locally least cost; null where none leads there. */
export function estimate(from: MeshPoint, to: MeshPoint): SurfaceLeg | null {
  return pathOf(() => openSurface().estimate(known(from), known(to)) as SurfaceLeg | undefined) ?? null;
}

/** What the closed curve of these legs encloses. */
export function enclosed(legs: readonly SurfaceLeg[]): Enclosure {
  const triangles = Uint32Array.from(legs.flatMap((leg) => [...leg.triangles]));
  const weights = Float64Array.from(legs.flatMap((leg) => [...leg.weights]));
  const counts = Uint32Array.from(legs, (leg) => leg.triangles.length);
  return openSurface().enclosed(triangles, weights, counts) as Enclosure;
}

/**
 * #F × 3, one vector a drawn triangle, by the last field: the gradient of distance, or the unit vector along the
 * gradient of heat (towards the sources); 0 where there is none.
 */
export function gradients(kind: FaceField): Float32Array {
  return openMesh().solver.gradients(kind);
}

/** One value a drawn vertex, or a corner as in the field, of a field by heat: log10 of its heat over its maximum; −Infinity where there is none. */
export function heat(): Float32Array {
  return openMesh().solver.heat();
}

/**
 * How many walkers take the path to the sources by the last field, wherever they start; 0: none. Those who are out stay
 * out. `height`: of those who set out, in bounding radii of the surface.
 */
export function crowd(count: number, height: number): void {
  openMesh().solver.set_crowd(count, height);
}

/**
 * Moves each walker by `step` and gives 10 numbers a walker: position, unit surface normal and unit heading (three
 * each), and the length that it has walked, as they are drawn. Who arrives starts again elsewhere, with length 0. Walkers keep their
 * places in the array. Empty without a field or a crowd.
 */
export function stepCrowd(step: number): Float32Array {
  return openMesh().solver.step_crowd(step);
}

/** The way of each walker down the last field, from where it is to its source; none without a crowd. */
export function crowdTracks(): wasm.Tracks {
  return openSurface().crowd_tracks();
}

/**
 * #E × 2 × 3, ends of lines on the surface, as they are drawn: edges between faces, edges with one face, the edges of the triangles that
 * carry the operators, or the marks of where components meet.
 */
export function edges(kind: EdgeKind): Float32Array {
  return openMesh().solver.edges(kind);
}

/** One value a drawn vertex, or a corner as in the field: relative error of the last field before it was made exact; null until it is. */
export function errors(): Float32Array | null {
  return openMesh().surface?.errors() ?? null;
}

/** Residuals of both linear solvers in the systems of the last field, which is by heat. */
export function convergence(): wasm.Convergence {
  return openSurface().convergence();
}

/** #P × 2, points of the path traced last: the length up to each, and the last field there, in the unit of the file; null without a path. */
export function pathProfile(): Float64Array | null {
  return openSurface().path_profile() ?? null;
}

/** Isolines of the last field, as chords of triangles: #segments × 2 × 3, the ends of all segments, as they are drawn. */
export async function isolineEnds(wish: IsolineWish): Promise<Float32Array> {
  return (await curves()).isolineEnds(openSurface(), wish, openMesh().shownAs);
}

/** Isolines of the last field, along the distance itself where that is exact. */
export async function isolines(wish: IsolineWish): Promise<Isolines> {
  return (await curves()).isolines(openSurface(), wish);
}

/** A file of isolines of the last field. */
export async function curveFile(wish: IsolineWish, file: CurveFile): Promise<SavedCurves> {
  return (await curves()).curveFile(openSurface(), wish, file, openMesh().shownAs);
}

/** The curves in which a plane cuts the surface: #segments × 2 × 3, their ends, as they are drawn. */
export async function girth(plane: Plane): Promise<Float32Array> {
  return (await curves()).girth(openSurface(), plane, openMesh().shownAs);
}

/** A file of them. */
export async function girthFile(plane: Plane, kind: GirthFile, unit: LengthUnit): Promise<Bytes> {
  return (await curves()).girthFile(openSurface(), plane, kind, unit);
}

/** One step of finding cells, of 100 to 200 ms; null: they are not found yet, and the next call goes on. */
export async function cells(wish: CellWish): Promise<FoundCells | null> {
  return (await import('../cells')).cells(openSurface(), wish, openMesh().shownAs);
}

/** #P × 4: each a drawn triangle, and the weights of its corners. */
export async function spread(wish: SpreadWish): Promise<Float64Array> {
  return (await import('../cells')).spread(openSurface(), wish);
}

/** A file of the borders of the cells that were found last. */
export async function cellFile(file: CurveFile): Promise<Bytes> {
  return (await import('../cells')).cellFile(file, openMesh().shownAs);
}

/** Distance from curves, which takes as long as an exact field or, for the sides of open curves, a few. */
export async function curveDistances(wish: CurveWish): Promise<CurveDistances> {
  return (await import('../offsets')).curveDistances(openSurface(), wish, openMesh().shownAs);
}

/** A file of the isolines of the distance from curves that was found last. */
export async function offsetFile(file: CurveFile): Promise<Bytes> {
  return (await import('../offsets')).offsetFile(file, openMesh().shownAs);
}

/** Curves of paths on a surface. */
export async function pathCurves(wish: PathWish): Promise<FoundPaths> {
  return (await import('../paths')).pathCurves(openSurface(), wish, openMesh().shownAs);
}

/** A file of those that were found last. */
export async function pathFile(curve: PathCurves, file: CurveFile): Promise<Bytes> {
  return (await import('../paths')).pathFile(curve, file, openMesh().shownAs);
}

/** Directions at places, carried to all triangles. */
export async function carried(wish: DirectionWish): Promise<Float32Array> {
  return (await import('../directions')).carried(openSurface(), wish, openMesh().shownAs);
}

/** The log map of a place as a table, with u along its direction and lengths in a unit. */
export async function logMapFile(wish: DirectionWish, unit: LengthUnit): Promise<Bytes> {
  return (await import('../directions')).logMapFile(openSurface(), wish, unit, openMesh().shownAs);
}

/** One step of laying an image on the surface; null: it is not laid yet, and the next call goes on. */
export async function decal(wish: DecalWish): Promise<LaidDecal | null> {
  return (await import('../decals')).decal(openSurface(), wish, openMesh().shownAs);
}

/** A file of the last field, with lengths in a unit; of a mesh that is as in its file, with all that this holds. */
export async function distanceFile(kind: DistanceFile, unit: LengthUnit): Promise<Bytes> {
  return (await curves()).distanceFile(openSurface(), kind, unit, openMesh().shownAs);
}

/** The same of tetrahedra. */
export function innerDistanceFile(kind: InnerDistanceFile, { scale, symbol }: LengthUnit): Bytes {
  const { inside } = openMesh();
  if (!inside) throw new Error('Only tetrahedra can be asked this, and the mesh is a surface.');
  return inside.solver.file(kind, scale, symbol) as Bytes;
}
