/** Loops around handles; loaded when they are first wanted. */
import { ofModel } from '../../length';
import type { CurveFile, ExactSurface, FoundLoops } from '../../protocol';
import type * as curves from '../../wasm/curves/heatwalk_curves';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { loaded } from './curves';
import { exactSurface } from './exact';
import type { Bytes } from './files';
import type { ShownAs } from './mesh';

/** What was found last. */
let found: curves.Loops | undefined;

export async function handleLoops(
  solver: wasm.Solver,
  wish: ExactSurface,
  { transform }: ShownAs,
): Promise<FoundLoops> {
  const surface = await exactSurface(solver, wish);
  found?.free();
  found = undefined;
  found = surface.handle_loops();
  return { lengths: Array.from(found.lengths(), (length) => ofModel(length)), ends: found.ends(transform) };
}

export async function loopFile({ kind, towardEye, unit }: CurveFile, { transform }: ShownAs): Promise<Bytes> {
  const { FileUnit } = await loaded();
  if (!found) throw new Error('No loops were found.');
  const toward = Float64Array.from(towardEye);
  return found.file(kind, toward, transform.up, new FileUnit(unit.scale, unit.symbol)) as Bytes;
}
