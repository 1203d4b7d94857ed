import { floats, integers } from './arrays.ts';
import type { Triangles } from './mesh.ts';

const FACE_BYTES = 13;

/** Triangles as a file of PLY in double precision, whose vertices and faces have the same numbers. */
export function plyOf({ positions, indices }: Triangles): Blob {
  const coordinates = floats(positions, 'positions', 3);
  const vertices = coordinates.length / 3;
  const corners = integers(indices ?? Uint32Array.from({ length: vertices }, (_, k) => k), 'vertex of a triangle', 3);
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `element vertex ${vertices}`,
    ...['x', 'y', 'z'].map((axis) => `property double ${axis}`),
    `element face ${corners.length / 3}`,
    'property list uchar uint vertex_indices',
    'end_header\n',
  ].join('\n');
  const faces = new DataView(new ArrayBuffer((corners.length / 3) * FACE_BYTES));
  corners.forEach((vertex, corner) => {
    const [face, k] = [Math.floor(corner / 3), corner % 3];
    if (k === 0) faces.setUint8(face * FACE_BYTES, 3);
    faces.setUint32(face * FACE_BYTES + 1 + 4 * k, vertex, true);
  });
  const points = new DataView(new ArrayBuffer(8 * coordinates.length));
  coordinates.forEach((coordinate, k) => points.setFloat64(8 * k, coordinate, true));
  return new Blob([header, points, faces]);
}
