/** Isolines and files of distances, by a module that is loaded with the first of them. */
import { transfer } from 'comlink';
import type { CurveFile, DistanceFile, DrawTransform, Isolines, IsolineWish, MeshInput } from '../../protocol';
import { fileName } from '../../files/paths';
import type * as curves from '../../wasm/curves/heatwalk_curves';
import curvesAddress from '../../wasm/curves/heatwalk_curves_bg.wasm?url';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import { onDemand } from './demand';
import { filesOf, unpackedOf, withFiles } from './files';
import { through } from './plain';

/** How the mesh is drawn, and the file and its parts that it is; null where it was simplified or filled. */
export interface ShownAs {
  transform: DrawTransform;
  from: { input: MeshInput; parts: Uint32Array } | null;
}

/** In place of the vertex that one of the input became, where no triangle uses it. */
const NONE = 0xffffffff;

const loaded = onDemand(async () => {
  const module = await import('../../wasm/curves/heatwalk_curves.js');
  await module.default({ module_or_path: curvesAddress });
  return module;
});

/** The isolines that were traced last. */
let traced: curves.Curves | undefined;

/** Traces isolines of the last field on the surface as it is shown. */
async function trace(solver: wasm.Solver, { values, spacing }: IsolineWish): Promise<curves.Curves> {
  const { Curves } = await loaded();
  traced?.free();
  traced = undefined;
  traced = new Curves(solver.positions(), solver.faces(), solver.distances(), Float64Array.from(values), spacing);
  return traced;
}

export async function isolines(solver: wasm.Solver, wish: IsolineWish, shownAs?: ShownAs): Promise<Isolines> {
  const { center, scale, up } = open(shownAs).transform;
  const found = await trace(solver, wish);
  const numbers = found.table();
  const rows = Array.from({ length: numbers.length / 5 }, (_, row) => {
    const [value = NaN, length = NaN, area = NaN, count = 0, closed = 0] = numbers.subarray(5 * row, 5 * row + 5);
    return { value, length, area, curves: count, closed };
  });
  const ends = found.ends(Float64Array.from(center), scale, up);
  return transfer({ rows, ends }, [ends.buffer]);
}

export async function curveFile(
  solver: wasm.Solver,
  wish: IsolineWish,
  { kind, towardEye }: CurveFile,
  shownAs?: ShownAs,
): Promise<Bytes> {
  const { up } = open(shownAs).transform;
  const found = await trace(solver, wish);
  return sent(kind === 'svg' ? found.svg(Float64Array.from(towardEye), up) : found.file(kind));
}

export async function distanceFile(solver: wasm.Solver, kind: DistanceFile, shownAs?: ShownAs): Promise<Bytes> {
  const { from } = open(shownAs);
  const module = await loaded();
  const vertices = solver.vertices_of_inputs();
  const values = solver.distances();
  // NONE is an index of no value.
  const distances = Float64Array.from(vertices, (vertex) => values[vertex] ?? Infinity);
  const input = from?.input;
  if (from && (input?.kind === 'files' || input?.kind === 'archive')) {
    const { mesh } = input;
    const files = input.kind === 'files' ? filesOf(input.files) : await unpackedOf(input.archive);
    const bytes = files.read(mesh);
    return withFiles(mesh, files, (resource) =>
      sent(module.distance_file_of(kind, fileName(mesh), bytes, resource, from.parts, distances)),
    );
  }
  return sent(module.distance_file(kind, ...ofInputs(solver, vertices), distances));
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

type Bytes = Uint8Array<ArrayBuffer>;

/** Bytes of the module, which has copied them for the page. */
function sent(bytes: Uint8Array): Bytes {
  const own = bytes as Bytes;
  return transfer(own, [own.buffer]);
}

function open(shownAs: ShownAs | undefined): ShownAs {
  if (!shownAs) throw new Error('No mesh is open.');
  return shownAs;
}
