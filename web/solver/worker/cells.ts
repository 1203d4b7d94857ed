/** Cells of sources; loaded with the first of them. */
import { ofModel } from '../../length';
import type { CellWish, CurveFile, FoundCells, SpreadWish } from '../../protocol';
import type * as writer from '../../wasm/writer/heatwalk_writer';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { nextWork, SLICE_MS, stopwatch } from './clock';
import { loaded } from './curves';
import { exactSurface } from './exact';
import type { Bytes } from './files';
import { FIRST_WORK, type ShownAs } from './mesh';

/** The search under way, or that ended last; on which surface, and the question under way. */
let last: { finder: writer.CellFinder; surface: writer.ExactSurface; question: number | null } | undefined;
/** The cells found last. */
let found: writer.Cells | undefined;
let work = FIRST_WORK;

async function finderOn(surface: writer.ExactSurface): Promise<NonNullable<typeof last>> {
  const { CellFinder } = await loaded();
  if (last?.surface === surface) return last;
  last?.finder.free();
  last = undefined;
  last = { finder: new CellFinder(surface), surface, question: null };
  return last;
}

export async function cells(solver: wasm.Solver, wish: CellWish, { transform }: ShownAs): Promise<FoundCells | null> {
  const { question, places, initial, cells: of, count } = wish;
  const asked = await finderOn(await exactSurface(solver, wish));
  const { finder } = asked;
  if (asked.question !== question) {
    asked.question = null;
    finder.begin(places.triangles, places.weights, initial);
    asked.question = question;
  }
  const clock = stopwatch();
  const isFound = finder.advance(work);
  work = nextWork(work, clock(), SLICE_MS);
  if (!isFound) return null;
  asked.question = null;
  found?.free();
  found = undefined;
  found = finder.take(of, count);
  const areas = Array.from(found.areas(), (area) => ofModel<2>(area));
  return { areas, ends: found.ends(transform), tiles: found.tiles(), corners: found.corners() };
}

export async function spread(solver: wasm.Solver, wish: SpreadWish): Promise<Float64Array> {
  const surface = await exactSurface(solver, wish);
  const { triangles, weights } = wish.places;
  switch (wish.wanted) {
    case 'middles':
      return surface.relaxed(triangles, weights);
    case 'mean':
      return surface.mean(triangles, weights);
    default:
      return surface.spread(triangles[0] ?? 0, weights.subarray(0, 3), wish.wanted);
  }
}

export async function cellFile({ kind, towardEye, unit }: CurveFile, { transform }: ShownAs): Promise<Bytes> {
  const { FileUnit } = await loaded();
  if (!found) throw new Error('No cells were found.');
  const toward = Float64Array.from(towardEye);
  return found.file(kind, toward, transform.up, new FileUnit(unit.scale, unit.symbol)) as Bytes;
}
