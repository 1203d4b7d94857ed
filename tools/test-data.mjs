// node tools/test-data.mjs: writes crate/solver/tests/data anew: exact distances by pygeodesic, and the errors of
// geometry-central's robust heat method by potpourri3d, on the meshes of crate/solver/tests/common/meshes.rs.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { POTPOURRI3D, pythonWith, PYGEODESIC } from './peers.mjs';
import { prepare } from './needs.mjs';
import { cargo, root, run } from './steps.mjs';

const DATA = join(root, 'crate', 'solver', 'tests', 'data');
const MESHES = join(root, 'target', 'bench', 'test-meshes');

prepare();
const { default: bunny } = await import('bunny');
writeFileSync(join(DATA, 'bunny.ply'), ply(bunny));
const python = pythonWith(PYGEODESIC, POTPOURRI3D);
mkdirSync(MESHES, { recursive: true });
cargo('Writing the meshes', ['run', '-p', 'heatwalk', '--example', 'test_meshes', '--', MESHES], 'See above.');
run('Computing their distances', python, [join(root, 'tools', 'test_data.py'), MESHES, DATA], 'See above.');

/** A binary file of 32-bit coordinates, which is what the package has. */
function ply({ positions, cells }) {
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `element vertex ${positions.length}`,
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    `element face ${cells.length}`,
    'property list uchar ushort vertex_indices',
    'end_header\n',
  ].join('\n');
  const vertices = Buffer.from(Float32Array.from(positions.flat()).buffer);
  const faces = cells.map((cell) => {
    const face = Buffer.alloc(7);
    face.writeUInt8(3);
    cell.forEach((vertex, corner) => face.writeUInt16LE(vertex, 1 + 2 * corner));
    return face;
  });
  return Buffer.concat([Buffer.from(header), vertices, ...faces]);
}
