/** Which parts of a file the triangles of its surface belong to. Triangles keep the order of the file, in which a part has ranges. */
import type { OpenedMesh } from '../protocol';
import { entry } from './entry';

/** The parts of a file, and which of them are the surface. */
type Parts = Pick<OpenedMesh, 'parts' | 'active'>;

/** What tells the parts of triangles. */
interface Parted extends Parts {
  surface: Pick<OpenedMesh['surface'], 'triangles'>;
}

/** Triangles of a part that follow each other in the file. */
interface Range {
  part: number;
  first: number;
  count: number;
}

/** #F, the part of each triangle; null where triangles of the file were removed, which leaves it unknown. */
export function partsOfFaces({ parts, active, surface }: Parted): Uint32Array | null {
  const ranges = rangesOf({ parts, active });
  const all = ranges.reduce((sum, { count }) => sum + count, 0);
  if (3 * all !== surface.triangles.length) return null;
  const found = new Uint32Array(all);
  let face = 0;
  for (const { part, count } of ranges) {
    found.fill(part, face, face + count);
    face += count;
  }
  return found;
}

/** The triangle of the file that a triangle of the surface is, where none was removed. */
export function triangleOfFile(opened: Parts, face: number): number {
  let left = face;
  for (const { first, count } of rangesOf(opened)) {
    if (left < count) return first + left;
    left -= count;
  }
  return face;
}

function rangesOf({ parts, active }: Parts): Range[] {
  const ranges = active.flatMap((part) => {
    const { ranges: ends } = entry(parts, part);
    return Array.from({ length: ends.length / 2 }, (_, index) => {
      const first = entry(ends, 2 * index);
      return { part, first, count: entry(ends, 2 * index + 1) - first };
    });
  });
  return ranges.toSorted((a, b) => a.first - b.first);
}
