/** A surface of its own in the module of curves, for what is found by exact distances beside the field; loaded when it is first wanted. */
import type { ExactSurface } from '../../protocol';
import type * as writer from '../../wasm/writer/heatwalk_writer';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { loaded } from './curves';

/** The surface asked last. */
let last: { surface: writer.ExactSurface; number: number } | undefined;

/** The surface that a wish is for, kept for the next one. What is made of another one is to be forgotten. */
export async function exactSurface(
  solver: wasm.Solver,
  { surface: number, bridge, links }: ExactSurface,
): Promise<writer.ExactSurface> {
  const { ExactSurface: Surface } = await loaded();
  if (last?.number === number) return last.surface;
  last?.surface.free();
  last = undefined;
  last = { surface: new Surface(solver.positions(), solver.faces(), bridge, links), number };
  return last.surface;
}
