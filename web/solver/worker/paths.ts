/** Curves of paths on the surface; loaded when they are first wanted. */
import { ofModel } from '../../length';
import type { CurveFile, FoundPaths, PathCurves, PathWish } from '../../protocol';
import type * as writer from '../../wasm/writer/heatwalk_writer';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { loaded } from './curves';
import { exactSurface } from './exact';
import type { Bytes } from './files';
import type { ShownAs } from './mesh';

/** What was found last. */
const found = new Map<PathCurves, writer.Paths>();

export async function pathCurves(solver: wasm.Solver, wish: PathWish, { transform }: ShownAs): Promise<FoundPaths> {
  const { kind, places } = wish;
  const surface = await exactSurface(solver, wish);
  found.get(kind)?.free();
  found.delete(kind);
  const paths = pathsOf(surface, kind, places);
  found.set(kind, paths);
  return { lengths: Array.from(paths.lengths(), (length) => ofModel(length)), ends: paths.ends(transform) };
}

function pathsOf(
  surface: writer.ExactSurface,
  kind: PathCurves,
  { triangles, weights }: PathWish['places'],
): writer.Paths {
  if (kind === 'loops') return surface.handle_loops();
  return kind === 'loop' ? surface.loop_through(triangles, weights) : surface.bezier(triangles, weights);
}

export async function pathFile(
  curve: PathCurves,
  { kind, towardEye, unit }: CurveFile,
  { transform }: ShownAs,
): Promise<Bytes> {
  const { FileUnit } = await loaded();
  const paths = found.get(curve);
  if (!paths) throw new Error('No such curves were found.');
  const toward = Float64Array.from(towardEye);
  return paths.file(kind, toward, transform.up, new FileUnit(unit.scale, unit.symbol)) as Bytes;
}
