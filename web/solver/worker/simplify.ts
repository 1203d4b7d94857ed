/** Simplified models in the place of meshes that do not fit, by meshoptimizer, which is loaded where one is wanted. */
import type { Simplified } from '../../protocol';
import type { MeshFile } from '../../wasm/solver/heatwalk_worker.js';

/** More than a simplifier keeps above what it was told is too much: it then gives up how triangles are connected. */
const MOST_ABOVE = 1.1;

/** No triangle is kept for the sake of its error: so many are wanted. */
const ANY_ERROR = Number.MAX_VALUE;

/** The parts `active` of a file in so many triangles. */
export async function simplify(
  file: MeshFile,
  active: Uint32Array,
  name: string,
  triangles: number,
): Promise<{ file: MeshFile; simplified: Simplified }> {
  const { MeshoptSimplifier: simplifier } = await import('meshoptimizer/simplifier');
  await simplifier.ready;
  const outline = file.outline(active);
  try {
    const positions = outline.positions();
    const welded = simplifier.generatePositionRemap(positions, 3);
    const whole = outline.triangles().map((vertex) => welded[vertex]);
    const wanted = 3 * triangles;
    let [kept, error] = simplifier.simplify(whole, positions, 3, wanted, ANY_ERROR, ['ErrorAbsolute', 'Prune']);
    if (kept.length > MOST_ABOVE * wanted) {
      [kept, error] = simplifier.simplifySloppy(whole, positions, 3, null, wanted, ANY_ERROR);
      error *= simplifier.getScale(positions, 3);
    }
    const scale = outline.scale();
    const simplified = { triangles: whole.length / 3, error: error * scale, diagonal: diagonalOf(positions) * scale };
    return { file: outline.with_triangles(name, kept), simplified };
  } finally {
    outline.free();
  }
}

/** Of the box around positions, #V × 3. */
function diagonalOf(positions: Float32Array): number {
  const [low, high] = [Infinity, -Infinity].map((end) => [end, end, end]);
  for (let at = 0; at < positions.length; at++) {
    const axis = at % 3;
    low[axis] = Math.min(low[axis], positions[at]);
    high[axis] = Math.max(high[axis], positions[at]);
  }
  return Math.hypot(...high.map((end, axis) => end - low[axis]));
}
