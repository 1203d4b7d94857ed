/** glTF files with lights and with glass. */
import { type Mesh, sphere } from './fixtures';
import { GlbWriter } from '../tools/glb.mjs';

function primitive(writer: GlbWriter, { positions, triangles }: Mesh) {
  const bounds = { min: [-1, -1, -1], max: [1, 1, 1] };
  return {
    attributes: { POSITION: writer.accessor(Float32Array.from(positions.flat()), 'VEC3', bounds) },
    indices: writer.accessor(Uint32Array.from(triangles.flat()), 'SCALAR'),
  };
}

const light = (number: number) => ({ extensions: { KHR_lights_punctual: { light: number } } });

const lights = (...all: readonly object[]) => ({
  extensionsUsed: ['KHR_lights_punctual'],
  extensions: { KHR_lights_punctual: { lights: all } },
});

/** A ball, a red lamp to its right, a blue spot to its left that shines on it, and a camera that sees all of 8 along y from +z. */
export function litGlb(): Buffer {
  const writer = new GlbWriter();
  const turn = Math.SQRT1_2;
  return writer.pack({
    ...lights({ type: 'point', color: [1, 0, 0], intensity: 4 }, { type: 'spot', color: [0, 0, 1], intensity: 4 }),
    cameras: [{ type: 'orthographic', orthographic: { xmag: 4, ymag: 4, znear: 0.1, zfar: 20 } }],
    nodes: [
      { mesh: 0, name: 'ball' },
      { translation: [3, 0, 0], ...light(0) },
      { translation: [-3, 0, 0], rotation: [0, -turn, 0, turn], ...light(1) },
      { name: 'ahead', camera: 0, translation: [0, 0, 9] },
    ],
    meshes: [{ primitives: [primitive(writer, sphere(24))] }],
  });
}

const pbr = (baseColorFactor: readonly number[]) => ({
  pbrMetallicRoughness: { baseColorFactor, metallicFactor: 0, roughnessFactor: 0.3 },
});

const glass = (...color: readonly number[]) => ({ ...pbr([...color, 0.4]), alphaMode: 'BLEND', doubleSided: true });

/** Three balls of colored glass that pierce each other around a small one of clay, under a sun and a lamp. */
export function glassGlb(): Buffer {
  const writer = new GlbWriter();
  const ball = primitive(writer, sphere(16));
  return writer.pack({
    ...lights(
      { type: 'directional', color: [1, 0.9, 0.7], intensity: 3 },
      { type: 'point', color: [0.3, 0.5, 1], intensity: 20 },
    ),
    nodes: [
      { mesh: 0, translation: [0, 0, 1.2] },
      { mesh: 1, translation: [0.8, 0, 0] },
      { mesh: 2, translation: [-0.6, 0.4, -1] },
      { mesh: 3, translation: [0, -0.2, 0], scale: [0.4, 0.4, 0.4] },
      { rotation: [-0.5, 0, 0, 0.866], ...light(0) },
      { translation: [-3, 2, 2], ...light(1) },
    ],
    meshes: [0, 1, 2, 3].map((material) => ({ primitives: [{ ...ball, material }] })),
    materials: [glass(0.9, 0.1, 0.1), glass(0.1, 0.8, 0.2), glass(0.1, 0.2, 0.9), pbr([0.9, 0.8, 0.6, 1])],
  });
}
