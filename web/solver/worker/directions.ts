/** Directions at places, carried over the surface and as axes of a log map; loaded when they are first wanted. */
import type { DirectionWish } from '../../protocol';
import type { LengthUnit } from '../../length';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { exactSurface } from './exact';
import type { Bytes } from './files';
import type { ShownAs } from './mesh';

/** #F × 3, unit vectors of the drawn triangles as they are drawn; zero where no direction comes. */
export async function carried(solver: wasm.Solver, wish: DirectionWish, { transform }: ShownAs): Promise<Float32Array> {
  const surface = await exactSurface(solver, wish);
  const { triangles, weights } = wish.places;
  const vectors = new Float32Array(solver.faces().length);
  vectors.set(surface.carried(triangles, weights, wish.directions, transform));
  return vectors;
}

/** A table of u and v, the log map of the first place, by the vertices of the file. */
export async function logMapFile(
  solver: wasm.Solver,
  wish: DirectionWish,
  { scale, symbol }: LengthUnit,
  { transform }: ShownAs,
): Promise<Bytes> {
  const surface = await exactSurface(solver, wish);
  const [triangle = 0] = wish.places.triangles;
  const { weights } = wish.places;
  const map = surface.log_map(triangle, weights.subarray(0, 3), wish.directions.subarray(0, 3), transform.up);
  const column = (name: string) => (symbol ? `${name} (${symbol})` : name);
  const lines = [`vertex,${column('u')},${column('v')}`];
  const told = (value = NaN) => (Number.isNaN(value) ? 'nan' : String(scale * value));
  solver.vertices_of_inputs().forEach((vertex, input) => {
    lines.push([input, told(map[2 * vertex]), told(map[2 * vertex + 1])].join());
  });
  return new TextEncoder().encode(`${lines.join('\n')}\n`);
}
