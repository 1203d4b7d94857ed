/** Simplified models in the place of meshes that do not fit, by meshoptimizer, which is loaded where one is wanted. */
import type { SimplifierFlags } from 'meshoptimizer/simplifier';
import type { Simplified } from '../../protocol';
import { ofModel } from '../../length';
import type { MeshFile } from '../../wasm/solver/heatwalk_worker.js';
import { through } from './through';

/**
 * Over half the longest side of the box. Where edges would have to be collapsed over more, or larger components be taken away,
 * clusters of vertices keep more of the shape.
 */
const LARGEST_ERROR = 0.02;

/** As many times what was wanted still fits. */
const STILL_FITS = 1.05;

/** Clusters are as large as they have to be. */
const ANY_ERROR = Number.MAX_VALUE;

/** The parts `active` of a file in `triangles` triangles. */
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
    const whole = through(outline.triangles(), welded);
    const wanted = 3 * triangles;
    // Sparse: welding leaves vertices without triangles, which would pass for seams.
    const how: SimplifierFlags[] = ['Sparse', 'ErrorAbsolute', 'Prune'];
    let [kept, error] = simplifier.simplify(whole, positions, 3, wanted, LARGEST_ERROR, how);
    if (kept.length > STILL_FITS * wanted) {
      [kept, error] = simplifier.simplifySloppy(whole, positions, 3, null, wanted, ANY_ERROR);
      error *= simplifier.getScale(positions, 3);
    }
    const scale = outline.scale();
    const simplified = {
      triangles: whole.length / 3,
      error: ofModel(error * scale),
      diagonal: ofModel(diagonalOf(positions) * scale),
    };
    return { file: file.simplified(outline, name, kept), simplified };
  } finally {
    outline.free();
  }
}

/** Of the box around positions, #V × 3. */
function diagonalOf(positions: Float32Array): number {
  const sides = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let at = axis; at < positions.length; at += 3) {
      const coordinate = positions[at] ?? 0;
      low = Math.min(low, coordinate);
      high = Math.max(high, coordinate);
    }
    return high - low;
  });
  return Math.hypot(...sides);
}
