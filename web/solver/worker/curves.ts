/** Isolines and files of distances, by a module that is loaded with the first of them. */
import type {
  CurveFile,
  DistanceFile,
  IsolineRow,
  Isolines,
  IsolineWish,
  SavedCurves,
  GirthFile,
  Plane,
} from '../../protocol';
import { type LengthUnit, MODEL, typed } from '../../length';
import { fileName } from '../../files/paths';
import type * as writer from '../../wasm/writer/heatwalk_writer';
import writerAddress from '../../wasm/writer/heatwalk_writer_bg.wasm?url';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { moduleOnDemand } from './demand';
import { type Bytes, filesOf, unpackedOf, withFiles } from './files';
import type { ShownAs } from './mesh';
import { through } from './through';

/** In place of the vertex that one of the input became, where no triangle uses it. */
const NONE = 0xffffffff;

export const loaded = moduleOnDemand(() => import('../../wasm/writer/heatwalk_writer.js'), writerAddress);

/** The distances at places, in a unit; nothing where they are not known. */
function distancesAt(
  solver: wasm.Solver,
  unit: LengthUnit,
): (faces: Uint32Array, weights: Float64Array) => Float64Array | undefined {
  return (faces, weights) => {
    const found = solver.exact_distances_in(faces, weights);
    return found && scaled(found, unit);
  };
}

/** What is made of isolines of the last field on the surface as it is shown: all in a unit, along the distance itself or as chords. */
interface Tracing<T> {
  wish: IsolineWish;
  unit: LengthUnit;
  /** Where it is exact. */
  alongDistance: boolean;
  make: (found: writer.Curves) => T;
}

async function traced<T>(
  solver: wasm.Solver,
  { wish: { values, spacing }, unit, alongDistance, make }: Tracing<T>,
): Promise<T> {
  const { Curves } = await loaded();
  const levels = Float64Array.from(values, (value) => typed(value, unit));
  const found = new Curves(
    scaled(solver.positions(), unit),
    solver.faces(),
    scaled(solver.distances(), unit),
    levels,
    typed(spacing, unit),
    alongDistance ? distancesAt(solver, unit) : undefined,
  );
  return used(found, make);
}

/** What is made of curves, whose memory is free afterwards. */
function used<T>(found: writer.Curves, make: (found: writer.Curves) => T): T {
  try {
    return make(found);
  } finally {
    found.free();
  }
}

/** What is made of the curves in which a plane cuts the surface: isolines of the height over it. */
async function cutBy<T>(
  solver: wasm.Solver,
  { normal, offset }: Plane,
  unit: LengthUnit,
  make: (found: writer.Curves) => T,
): Promise<T> {
  const { Curves } = await loaded();
  const positions = scaled(solver.positions(), unit);
  const heights = new Float64Array(positions.length / 3).fill(-offset * unit.scale);
  positions.forEach((value, index) => {
    const vertex = Math.floor(index / 3);
    heights[vertex] = (heights[vertex] ?? 0) + (normal[index % 3] ?? 0) * value;
  });
  return used(new Curves(positions, solver.faces(), heights, Float64Array.of(0), 0, undefined).into_girth(), make);
}

/** #segments × 2 × 3, ends of the segments of all curves in which a plane cuts the surface, one curve after another, as they are drawn. */
export function girth(solver: wasm.Solver, plane: Plane, { transform }: ShownAs): Promise<Float32Array> {
  return cutBy(solver, plane, MODEL, (found) => found.ends(transform));
}

/** A file of them. */
export function girthFile(solver: wasm.Solver, plane: Plane, kind: GirthFile, unit: LengthUnit): Promise<Bytes> {
  return cutBy(solver, plane, unit, (found) => found.file(kind, unit.symbol) as Bytes);
}

/** Lengths in another unit. */
function scaled(lengths: Float64Array, { scale }: LengthUnit): Float64Array {
  return scale === 1 ? lengths : lengths.map((length) => scale * length);
}

/** The ends of all segments of isolines, as they are drawn: chords, where these are not seen to be straight. */
export function isolineEnds(
  solver: wasm.Solver,
  wish: IsolineWish,
  { transform, between }: ShownAs,
): Promise<Float32Array> {
  const make = (found: writer.Curves) => found.ends(transform);
  return traced(solver, { wish, unit: MODEL, alongDistance: between !== undefined, make });
}

export function isolines(solver: wasm.Solver, wish: IsolineWish): Promise<Isolines> {
  return traced(solver, { wish, unit: MODEL, alongDistance: true, make: tableOf });
}

function tableOf(found: writer.Curves): Isolines {
  return { rows: found.rows() as IsolineRow[], isTrue: found.is_true };
}

export function curveFile(
  solver: wasm.Solver,
  wish: IsolineWish,
  { kind, towardEye, unit }: CurveFile,
  { transform }: ShownAs,
): Promise<SavedCurves> {
  const make = (found: writer.Curves): SavedCurves => {
    const bytes =
      kind === 'svg' || kind === 'pdf'
        ? found.picture(kind, Float64Array.from(towardEye), transform.up, unit.symbol)
        : found.file(kind, unit.symbol);
    const bounds = Array.from(found.left_out(), (bound) => (bound < 0 ? null : bound));
    const leftOut = Array.from(
      { length: bounds.length / 2 },
      (_, strip) => [bounds[2 * strip] ?? null, bounds[2 * strip + 1] ?? null] as const,
    );
    return { bytes: bytes as Bytes, leftOut, flatSpacing: found.flat_spacing ?? null };
  };
  return traced(solver, { wish, unit, alongDistance: true, make });
}

export async function distanceFile(
  solver: wasm.Solver,
  kind: DistanceFile,
  { scale, symbol }: LengthUnit,
  { from }: ShownAs,
): Promise<Bytes> {
  const module = await loaded();
  const unit = new module.FileUnit(scale, symbol);
  const vertices = solver.vertices_of_inputs();
  const values = solver.distances();
  // NONE is an index of no value.
  const distances = Float64Array.from(vertices, (vertex) => values[vertex] ?? Infinity);
  const input = from?.input;
  if (from && (input?.kind === 'files' || input?.kind === 'archive')) {
    const { mesh } = input;
    const files = input.kind === 'files' ? filesOf(input.files) : await unpackedOf(input.archive);
    const bytes = files.read(mesh);
    return withFiles(
      mesh,
      files,
      (resource) =>
        module.distance_file_of(kind, fileName(mesh), bytes, resource, from.parts, distances, unit) as Bytes,
    );
  }
  // Corners of arrays stay those that they have, so that vertices keep their numbers.
  const own: [Float64Array, Uint32Array] =
    input?.kind === 'arrays' ? [Float64Array.from(input.positions), input.triangles] : ofInputs(solver, vertices);
  return module.distance_file(kind, ...own, distances, unit) as Bytes;
}

/** Positions of the vertices of the input, 0 of those that no triangle uses, and triangles. */
function ofInputs(solver: wasm.Solver, vertices: Uint32Array): [Float64Array, Uint32Array] {
  const welded = solver.positions();
  const positions = new Float64Array(3 * vertices.length);
  const inputOf = new Uint32Array(welded.length / 3);
  vertices.forEach((vertex, input) => {
    if (vertex === NONE) return;
    positions.set(welded.subarray(3 * vertex, 3 * vertex + 3), 3 * input);
    inputOf[vertex] = input;
  });
  return [positions, through(solver.faces(), inputOf)];
}
