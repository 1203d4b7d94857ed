/** Distance from curves as wholes, on both sides; loaded with the first of them. */
import { ofModel } from '../../length';
import type { CurveDistances, CurveFile, CurveWish } from '../../protocol';
import type * as writer from '../../wasm/writer/heatwalk_writer';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { loaded } from './curves';
import { exactSurface } from './exact';
import type { Bytes } from './files';
import type { ShownAs } from './mesh';

/** What was found last. */
let found: writer.CurveDistance | undefined;

export async function curveDistances(
  solver: wasm.Solver,
  wish: CurveWish,
  { transform }: ShownAs,
): Promise<CurveDistances> {
  const { counts, closed, places, period } = wish;
  const surface = await exactSurface(solver, wish);
  found?.free();
  found = undefined;
  found = surface.curve_distance(counts, closed, places.triangles, places.weights);
  const [least = 0, most = 0] = found.range();
  found.trace(period * Math.max(-least, most));
  return {
    values: found.values(solver.faces().length / 3),
    range: [ofModel(least), ofModel(most)],
    ends: found.ends(transform),
    tiles: found.tiles(),
    corners: found.corners(),
  };
}

export async function offsetFile({ kind, towardEye, unit }: CurveFile, { transform }: ShownAs): Promise<Bytes> {
  const { FileUnit } = await loaded();
  if (!found) throw new Error('No distance from curves was found.');
  const toward = Float64Array.from(towardEye);
  return found.file(kind, toward, transform.up, new FileUnit(unit.scale, unit.symbol)) as Bytes;
}
