/** Cells of sources, on a surface of their own in the module of curves; loaded with the first of them. */
import { ofModel } from '../../length';
import type { CellWish, CurveFile, FoundCells } from '../../protocol';
import type * as curves from '../../wasm/curves/heatwalk_curves';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { nextWork, SLICE_MS, stopwatch } from './clock';
import { loaded } from './curves';
import type { Bytes } from './files';
import { FIRST_WORK, type ShownAs } from './mesh';

/** The surface asked last. */
let asked: { surface: curves.CellSurface; number: number; question: number | null } | undefined;
/** The cells found last. */
let found: curves.Cells | undefined;
let work = FIRST_WORK;

export async function cells(
  solver: wasm.Solver,
  { surface: number, question, bridge, links, places, initial, cells: of, count }: CellWish,
  { transform }: ShownAs,
): Promise<FoundCells | null> {
  const { CellSurface } = await loaded();
  if (asked?.number !== number) {
    asked?.surface.free();
    asked = undefined;
    const surface = new CellSurface(solver.positions(), solver.faces(), bridge, links);
    asked = { surface, number, question: null };
  }
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

export async function cellFile({ kind, towardEye, unit }: CurveFile, { transform }: ShownAs): Promise<Bytes> {
  const { FileUnit } = await loaded();
  if (!found) throw new Error('No cells were found.');
  const toward = Float64Array.from(towardEye);
  return found.file(kind, toward, transform.up, new FileUnit(unit.scale, unit.symbol)) as Bytes;
}
