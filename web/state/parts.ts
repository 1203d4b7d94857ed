/** Which parts of a file the triangles of its surface belong to. */
import type { OpenedMesh } from '../protocol';

/** What tells the parts of triangles. */
export interface Parted extends Pick<OpenedMesh, 'parts' | 'active'> {
  surface: Pick<OpenedMesh['surface'], 'triangles'>;
}

/**
 * #F, the part of each triangle; null where triangles of the file were removed, for then it cannot be told. Triangles keep the order of
 * the file, in which a part has ranges.
 */
export function partsOfFaces({ parts, active, surface }: Parted): Uint32Array | null {
  const ranges = active.flatMap((part) => {
    const ends = Array.from(parts[part].ranges);
    return ends.flatMap((first, index) => (index % 2 === 0 ? [{ part, first, count: ends[index + 1] - first }] : []));
  });
  const all = ranges.reduce((sum, { count }) => sum + count, 0);
  if (3 * all !== surface.triangles.length) return null;
  const found = new Uint32Array(all);
  let face = 0;
  for (const { part, count } of ranges.toSorted((a, b) => a.first - b.first)) {
    found.fill(part, face, face + count);
    face += count;
  }
  return found;
}
