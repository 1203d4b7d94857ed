/** Cells of sources, on a surface of their own in the module of curves; loaded with the first of them. */
import { ofModel } from '../../length';
import type { CellSurface, CellWish, CurveFile, FoundCells, SpreadWish } from '../../protocol';
import type * as curves from '../../wasm/curves/heatwalk_curves';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { nextWork, SLICE_MS, stopwatch } from './clock';
import { loaded } from './curves';
import type { Bytes } from './files';
import { FIRST_WORK, type ShownAs } from './mesh';

interface Asked {
  surface: curves.CellSurface;
  number: number;
  /** The one under way. */
  question: number | null;
}

/** The surface asked last. */
let last: Asked | undefined;
/** The cells found last. */
let found: curves.Cells | undefined;
let work = FIRST_WORK;

/** The surface that a wish is for, kept for the next one. */
async function surfaceOf(solver: wasm.Solver, { surface: number, bridge, links }: CellSurface): Promise<Asked> {
  const { CellSurface: Surface } = await loaded();
  if (last?.number === number) return last;
  last?.surface.free();
  last = undefined;
  last = { surface: new Surface(solver.positions(), solver.faces(), bridge, links), number, question: null };
  return last;
}

export async function cells(solver: wasm.Solver, wish: CellWish, { transform }: ShownAs): Promise<FoundCells | null> {
  const { question, places, initial, cells: of, count } = wish;
  const asked = await surfaceOf(solver, wish);
  const { surface } = asked;
  if (asked.question !== question) {
    asked.question = null;
    surface.begin(places.triangles, places.weights, initial);
    asked.question = question;
  }
  const clock = stopwatch();
  const isFound = surface.advance(work);
  work = nextWork(work, clock(), SLICE_MS);
  if (!isFound) return null;
  asked.question = null;
  found?.free();
  found = undefined;
  found = surface.take(of, count);
  const areas = Array.from(found.areas(), (area) => ofModel<2>(area));
  return { areas, ends: found.ends(transform), tiles: found.tiles(), corners: found.corners() };
}

export async function spread(solver: wasm.Solver, wish: SpreadWish): Promise<Float64Array> {
  const { surface } = await surfaceOf(solver, wish);
  const { triangles, weights } = wish.places;
  return wish.count === null
    ? surface.relaxed(triangles, weights)
    : surface.spread(triangles[0] ?? 0, weights.subarray(0, 3), wish.count);
}

export async function cellFile({ kind, towardEye, unit }: CurveFile, { transform }: ShownAs): Promise<Bytes> {
  const { FileUnit } = await loaded();
  if (!found) throw new Error('No cells were found.');
  const toward = Float64Array.from(towardEye);
  return found.file(kind, toward, transform.up, new FileUnit(unit.scale, unit.symbol)) as Bytes;
}
