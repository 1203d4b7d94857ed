/** Images on the surface; loaded with the first of them. */
import type { DecalWish, LaidDecal } from '../../protocol';
import type * as writer from '../../wasm/writer/heatwalk_writer';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { nextWork, SLICE_MS, stopwatch } from './clock';
import { loaded } from './curves';
import { exactSurface } from './exact';
import { FIRST_WORK, type ShownAs } from './mesh';

/** What was asked last: on which surface, and around which place the search is under way. */
let last: { on: writer.ExactSurface; surface: writer.DecalSurface; place: string } | undefined;
let work = FIRST_WORK;

/** One step; null: it is not laid yet, and the next call goes on. */
export async function decal(solver: wasm.Solver, wish: DecalWish, { transform }: ShownAs): Promise<LaidDecal | null> {
  const { place, half, right, bridge, links } = wish;
  const [least, [triangle = 0]] = [Math.min(...half), place.triangles];
  const on = await exactSurface(solver, wish);
  const { DecalSurface } = await loaded();
  if (last?.on !== on || !last.surface.suits(least)) {
    last?.surface.free();
    last = undefined;
    const surface = new DecalSurface(on, solver.positions(), solver.faces(), bridge, links, least);
    last = { on, surface, place: '' };
  }
  const { surface } = last;
  const at = [triangle, ...place.weights].join();
  if (last.place !== at) {
    last.place = '';
    surface.begin(triangle, place.weights);
    last.place = at;
  }
  const clock = stopwatch();
  const isFound = surface.advance(...half, work);
  work = nextWork(work, clock(), SLICE_MS);
  if (!isFound) return null;
  const laid = surface.lay(...half, Float64Array.from(right), transform.up);
  const answer = { triangles: laid.triangles(), corners: laid.corners(), image: laid.image() };
  laid.free();
  return answer;
}
