/** How far two fields of one mesh are apart. */
import type { DistanceField } from '../../protocol';
import { entry } from '../../state/entry';

type Values = Pick<DistanceField, 'distance' | 'inner' | 'maxDistance'>;

/** Over the drawn vertices that both reach, of tetrahedra over all vertices; shares of the largest distance on the left. Null where there is none. */
export function difference(left: Values, right: Values): { mean: number; most: number } | null {
  const [ofLeft, ofRight] = [left.inner ?? left.distance, right.inner ?? right.distance];
  if (ofLeft.length !== ofRight.length || left.maxDistance === 0) return null;
  let [sum, most, vertices] = [0, 0, 0];
  ofLeft.forEach((one, i) => {
    const apart = Math.abs(one - entry(ofRight, i));
    if (!Number.isFinite(apart)) return;
    sum += apart;
    most = Math.max(most, apart);
    vertices += 1;
  });
  return vertices > 0 ? { mean: sum / vertices / left.maxDistance, most: most / left.maxDistance } : null;
}
