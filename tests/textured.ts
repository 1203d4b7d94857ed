/** Files with textures: glTF with vertex colors and two materials, OBJ with a material library. */
import { readFileSync } from 'node:fs';
import { PNG } from 'pngjs';
import { type Mesh, sphere } from './fixtures';
import { GlbWriter } from '../tools/glb.mjs';

/** `size²` texels, as a PNG file. */
function image(size: number, texel: (u: number, v: number) => readonly [number, number, number]): Buffer {
  const png = new PNG({ width: size, height: size });
  for (let i = 0; i < size * size; i++) {
    png.data.set([...texel(((i % size) + 0.5) / size, (Math.floor(i / size) + 0.5) / size), 255], 4 * i);
  }
  return PNG.sync.write(png);
}

/** Red and white squares. */
const squares = () => image(16, (u, v) => (u < 0.5 === v < 0.5 ? [200, 30, 40] : [245, 240, 230]));

/** The same squares, as a Basis Universal image. */
export const basisSquares = (kind: 'etc1s' | 'uastc-zstd') =>
  readFileSync(new URL(`../crate/basis/tests/data/${kind}.ktx2`, import.meta.url));

/** Round bumps. */
const bumps = () =>
  image(32, (u, v) => {
    const [x, y] = [0.7 * Math.sin(2 * Math.PI * u), -0.7 * Math.sin(2 * Math.PI * v)];
    const length = Math.hypot(x, y, 1);
    return [x, y, 1].map((part) => Math.round(255 * (0.5 + (0.5 * part) / length))) as [number, number, number];
  });

/** Black on the left, white on the right. */
const halves = () => image(16, (u) => (u < 0.5 ? [0, 0, 0] : [255, 255, 255]));

/** Waves, as heights. */
const waves = () =>
  image(64, (u) => {
    const height = Math.round(127.5 * (1 + Math.sin(16 * Math.PI * u)));
    return [height, height, height];
  });

/** A ball in red squares with a seam, in an OBJ file; `statements` are added to its material. */
export function texturedObj(statements: string): [string, Buffer | string][] {
  const { positions, triangles } = sphere(24);
  const lines = positions.map((p) => `v ${p.join(' ')}`);
  for (const triangle of triangles) {
    const angles = triangle.map((vertex) => Math.atan2(positions[vertex][0], positions[vertex][2]));
    // Beyond the seam, angles go on.
    const far = Math.max(...angles) - Math.min(...angles) > Math.PI;
    const at = angles.map((angle) => (far && angle < 0 ? angle + 2 * Math.PI : angle));
    lines.push(...at.map((angle, k) => `vt ${angle / Math.PI} ${positions[triangle[k]][1]}`));
    lines.push(`f ${[-3, -2, -1].map((texcoord, k) => `${triangle[k] + 1}/${texcoord}`).join(' ')}`);
  }
  const library = `newmtl ball\nmap_Kd squares.png\n${statements}\n`;
  return [
    ['ball.obj', `mtllib ball.mtl\nusemtl ball\n${lines.join('\n')}\n`],
    ['ball.mtl', library],
    ['squares.png', squares()],
    ['halves.png', halves()],
    ['waves.png', waves()],
  ];
}

const floats = (rows: readonly (readonly number[])[]) => Float32Array.from(rows.flat());

/**
 * A big ball in bumpy squares, and a small one on its top in the colors of its vertices. `texture` replaces the squares; they
 * are named as an extension has them, where one is given.
 */
export function texturedGlb(texture: Buffer = squares(), extension?: 'KHR_texture_basisu'): Buffer {
  const [big, small] = [sphere(24), sphere(16)];
  small.positions = small.positions.map(([x, y, z]) => [0.4 * x, 0.4 * y + 1.38, 0.4 * z]);
  const writer = new GlbWriter();
  const primitive = ({ positions, triangles }: Mesh, attributes: Record<string, number>, material: number) => ({
    attributes: {
      POSITION: writer.accessor(floats(positions), 'VEC3', { min: [-2, -2, -2], max: [2, 2, 2] }),
      ...attributes,
    },
    indices: writer.accessor(Uint32Array.from(triangles.flat()), 'SCALAR'),
    material,
  });
  const uv = big.positions.map(([x, y, z]) => [Math.atan2(x, z) / Math.PI, -y]);
  const colors = small.positions.map(([x, y]) => [0.5 + x, 0.9, 0.2 + 0.4 * (y - 1)]);
  return writer.pack({
    nodes: [
      { mesh: 0, name: 'squares' },
      { mesh: 1, name: 'colors' },
    ],
    meshes: [
      { primitives: [primitive(big, { TEXCOORD_0: writer.accessor(floats(uv), 'VEC2') }, 0)] },
      { primitives: [primitive(small, { COLOR_0: writer.accessor(floats(colors), 'VEC3') }, 1)] },
    ],
    materials: [
      {
        pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: 0.5 },
        normalTexture: { index: 1, extensions: { KHR_texture_transform: { scale: [4, 4] } } },
      },
      { pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.3 } },
    ],
    textures: [extension ? { extensions: { [extension]: { source: 0 } } } : { source: 0 }, { source: 1 }],
    images: [
      { name: 'squares', bufferView: writer.view(texture), mimeType: extension ? 'image/ktx2' : 'image/png' },
      { name: 'bumps', bufferView: writer.view(bumps()), mimeType: 'image/png' },
    ],
    extensionsUsed: ['KHR_texture_transform', ...(extension ? [extension] : [])],
  });
}
