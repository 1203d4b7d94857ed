/** A glTF file that moves. */
import { GlbWriter } from '../tools/glb.mjs';

/** Rings of the arm and vertices of each. */
const [RINGS, AROUND] = [41, 24];
/** Of the arm, along y from 0. */
export const ARM_LENGTH = 4;

/** A vertex of the arm: of its axis at one end or the other, or of a ring. */
export const ARM = { start: 0, end: 1, ring: (ring: number, place: number) => 2 + ring * AROUND + (place % AROUND) };

const floats = (rows: readonly (readonly number[])[]) => Float32Array.from(rows.flat());

/**
 * A closed round arm with a joint in its middle, and a box beside it as a part of its own. In the first animation the arm
 * bends to a right angle in a second, in the second arm and box become twice as large in two, in the third the box comes into
 * the arm in a second. A camera looks at the arm from +x.
 */
export function armGlb(): Buffer {
  const writer = new GlbWriter();
  const positions: number[][] = [
    [0, 0, 0],
    [0, ARM_LENGTH, 0],
  ];
  const triangles: number[][] = [];
  for (let ring = 0; ring < RINGS; ring++) {
    for (let place = 0; place < AROUND; place++) {
      const angle = (2 * Math.PI * place) / AROUND;
      positions.push([0.5 * Math.cos(angle), (ARM_LENGTH * ring) / (RINGS - 1), 0.5 * Math.sin(angle)]);
      const [a, b] = [ARM.ring(ring, place), ARM.ring(ring, place + 1)];
      if (ring === 0) triangles.push([ARM.start, a, b]);
      if (ring === RINGS - 1) triangles.push([ARM.end, b, a]);
      else triangles.push([a, a + AROUND, b], [b, a + AROUND, b + AROUND]);
    }
  }
  // The bend is spread over the middle fifth.
  const bent = ([, y]: number[]) => Math.min(1, Math.max(0, 5 * (y / ARM_LENGTH - 0.5) + 0.5));
  const half = ARM_LENGTH / 2;
  const back = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -half, 0, 1];
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const bounds = { min: [-0.5, 0, -0.5], max: [0.5, ARM_LENGTH, 0.5] };
  const attributes = {
    POSITION: writer.accessor(floats(positions), 'VEC3', bounds),
    JOINTS_0: writer.accessor(Uint8Array.from(positions.flatMap(() => [0, 1, 0, 0])), 'VEC4'),
    WEIGHTS_0: writer.accessor(floats(positions.map((place) => [1 - bent(place), bent(place), 0, 0])), 'VEC4'),
  };
  const indices = writer.accessor(Uint32Array.from(triangles.flat()), 'SCALAR');
  const cube = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [0.4 * x, 0.4 * y, 0.4 * z])));
  const sides = [
    0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3,
  ];
  const box = {
    attributes: { POSITION: writer.accessor(floats(cube), 'VEC3', { min: [-0.4, -0.4, -0.4], max: [0.4, 0.4, 0.4] }) },
    indices: writer.accessor(Uint32Array.from(sides), 'SCALAR'),
  };
  const turn = Math.SQRT1_2;
  return writer.pack({
    scenes: [{ nodes: [0, 4] }],
    cameras: [{ type: 'perspective', perspective: { yfov: 0.3, znear: 0.1 } }],
    nodes: [
      { name: 'root', children: [1, 2, 3] },
      { name: 'arm', mesh: 0, skin: 0 },
      { name: 'joint', translation: [0, half, 0] },
      { name: 'box', mesh: 1, translation: [2, 0.4, 0] },
      { name: 'from the side', camera: 0, translation: [20, 2, 0], rotation: [0, turn, 0, turn] },
    ],
    meshes: [{ primitives: [{ attributes, indices }] }, { primitives: [box] }],
    skins: [{ joints: [0, 2], inverseBindMatrices: writer.accessor(floats([identity, back]), 'MAT4') }],
    animations: [
      {
        name: 'Bend',
        channels: [{ sampler: 0, target: { node: 2, path: 'rotation' } }],
        samplers: [
          {
            input: writer.accessor(Float32Array.of(0, 1), 'SCALAR', { min: [0], max: [1] }),
            output: writer.accessor(Float32Array.of(0, 0, 0, 1, 0, 0, -turn, turn), 'VEC4'),
          },
        ],
      },
      {
        name: 'Grow',
        channels: [{ sampler: 0, target: { node: 0, path: 'scale' } }],
        samplers: [
          {
            input: writer.accessor(Float32Array.of(0, 2), 'SCALAR', { min: [0], max: [2] }),
            output: writer.accessor(Float32Array.of(1, 1, 1, 2, 2, 2), 'VEC3'),
          },
        ],
      },
      {
        name: 'Reach',
        channels: [{ sampler: 0, target: { node: 3, path: 'translation' } }],
        samplers: [
          {
            input: writer.accessor(Float32Array.of(0, 1), 'SCALAR', { min: [0], max: [1] }),
            output: writer.accessor(Float32Array.of(2, 0.4, 0, 0.85, 0.4, 0), 'VEC3'),
          },
        ],
      },
    ],
  });
}
