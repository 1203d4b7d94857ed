import { expect, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { MODEL } from '../../web/length';
import { type Painted, stripesGlb } from '../../web/session/stripes';
import { DEFAULT_STYLE, findStyle, type Style } from '../../web/state/styles';
import { NO_MESH } from '../../web/view/layers';
import { complaints } from '../gltf';

const TRANSFORM = { center: [1, 2, 3] as [number, number, number], scale: 2, up: 'z' as const };
const DISTANCES = [0, 0.375, 0.5, 0.9, 1, Infinity];

/** A fan of triangles in the plane, two of them reached. */
function painted(style: Style, period = 0.5): Painted {
  const positions = Float32Array.from(DISTANCES.flatMap((_, i) => [i, i % 2, 0]));
  const normals = Float32Array.from(DISTANCES.flatMap(() => [0, 0, 1]));
  const triangles = Uint32Array.of(0, 1, 2, 2, 3, 4, 3, 4, 5);
  const field = {
    distance: Float32Array.from(DISTANCES),
    tangents: new Int8Array(),
    maxDistance: 1,
    byCorner: false,
  };
  const surface = { ...NO_MESH, positions, normals, triangles };
  return { surface, pose: surface, field, style, most: 1, period, offset: 0.25 };
}

interface Document {
  accessors: { bufferView: number; count: number; min: number[]; max: number[] }[];
  bufferViews: { byteOffset: number; byteLength: number }[];
  images: { bufferView: number }[];
  materials: {
    emissiveTexture?: { index: number };
    extensions?: { KHR_materials_emissive_strength: { emissiveStrength: number } };
    pbrMetallicRoughness: { baseColorTexture?: { index: number }; metallicRoughnessTexture?: { index: number } };
  }[];
  meshes: { primitives: { attributes: Record<string, number>; indices: number; material: number }[] }[];
}

function read(glb: Uint8Array) {
  const bytes = Buffer.from(glb);
  const end = 20 + bytes.readUInt32LE(12);
  const document = JSON.parse(bytes.subarray(20, end).toString()) as Document;
  const view = (index: number) => {
    const { byteOffset, byteLength } = document.bufferViews[index];
    return bytes.subarray(end + 8 + byteOffset, end + 8 + byteOffset + byteLength);
  };
  const numbers = (accessor: number) => {
    const data = view(document.accessors[accessor].bufferView);
    return Array.from({ length: data.length / 4 }, (_, i) => data.readFloatLE(4 * i));
  };
  /** As samplers of glTF do, with the nearest texel: U repeats, V does not. */
  const sample = (texture: number, u: number, v: number) => {
    const { width, height, data } = PNG.sync.read(view(document.images[texture].bufferView));
    const [x, y] = [Math.floor((u - Math.floor(u)) * width), Math.min(height - 1, Math.floor(v * height))];
    return [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)];
  };
  return { document, numbers, sample };
}

test('stripes are in a texture that any program shows', async () => {
  const style = { ...DEFAULT_STYLE, ramp: 'viridis', stripe: '#ff8000', sharpness: 1 } as const;
  const glb = stripesGlb(painted(style), TRANSFORM, { ...MODEL, scale: 0.1 }, 'fan');
  expect(await complaints(glb)).toEqual([]);
  const { document, numbers, sample } = read(glb);
  const [reached, unreached] = document.meshes[0].primitives;
  expect([reached, unreached].map(({ indices }) => document.accessors[indices].count)).toEqual([6, 3]);
  // In the axes and the place of the file, in meters.
  const position = document.accessors[reached.attributes['POSITION']];
  const expected = [
    [0.1, 0.2, 0.3],
    [0.1 * (1 + 5 / 2), 0.2, 0.1 * (3 + 1 / 2)],
  ];
  [position.min, position.max].forEach((corner, end) =>
    corner.forEach((value, axis) => expect(value).toBeCloseTo(expected[end][axis], 6)),
  );
  const places = numbers(reached.attributes['TEXCOORD_0']);
  const { baseColorTexture } = document.materials[reached.material].pbrMetallicRoughness;
  const colors = DISTANCES.slice(0, 5).map((_, vertex) =>
    sample(baseColorTexture?.index ?? -1, places[2 * vertex], places[2 * vertex + 1]),
  );
  // Phases −0.25, 0.5, 0.75, 1.55 and 1.75: stripes are at a quarter to three quarters of a period.
  expect(colors[1]).toEqual([255, 128, 0]);
  expect(colors[3]).toEqual([255, 128, 0]);
  expect(places.slice(0, 8)).toEqual([
    -0.25,
    expect.closeTo(0, 3),
    0.5,
    expect.closeTo(0.375, 2),
    0.75,
    0.5,
    expect.closeTo(1.55, 6),
    expect.closeTo(0.9, 3),
  ]);
  // Ends of viridis, between stripes that begin there.
  const ground = stripesGlb(painted({ ...style, pattern: 'none' }), TRANSFORM, MODEL, 'fan');
  const plain = read(ground);
  expect(plain.sample(0, places[0], places[1])).toEqual([68, 1, 84]);
  expect(plain.sample(0, places[8], places[9])).toEqual([253, 231, 37]);
});

test('what light makes of stripes, and what they give off, are there too', async () => {
  const neon = findStyle('neon') ?? DEFAULT_STYLE;
  const glb = stripesGlb(painted(neon), TRANSFORM, MODEL, 'neon');
  expect(await complaints(glb)).toEqual([]);
  const { document, sample } = read(glb);
  const [{ emissiveTexture, extensions, pbrMetallicRoughness }] = document.materials;
  expect(extensions?.KHR_materials_emissive_strength.emissiveStrength).toBe(neon.stripes.glow);
  const finish = (phase: number) => sample(pbrMetallicRoughness.metallicRoughnessTexture?.index ?? -1, phase, 0.5);
  expect(finish(0.5)).toEqual([255, Math.round(255 * neon.stripes.roughness), 0]);
  expect(finish(0)).toEqual([255, Math.round(255 * neon.surface.roughness), Math.round(255 * neon.surface.metalness)]);
  expect(sample(emissiveTexture?.index ?? -1, 0, 0)).toEqual([0, 0, 0]);
  expect(Math.max(...sample(emissiveTexture?.index ?? -1, 0.5, 0))).toBeGreaterThan(200);

  // Lines are at whole phases, with thinner ones at fifths.
  const lines = { ...DEFAULT_STYLE, ramp: 'chalk', stripe: '#000000', pattern: 'lines', width: 0.5 } as const;
  const drawn = read(stripesGlb(painted(lines), TRANSFORM, MODEL, 'lines'));
  const shade = (phase: number) => drawn.sample(0, phase, 0)[0];
  expect([shade(0), shade(0.5)]).toEqual([0, 255]);
  expect(shade(0.2)).toBeGreaterThan(100);
  expect(shade(0.2)).toBeLessThan(220);
});

test('where walls part vertices each corner has its own distance', async () => {
  const whole = painted(DEFAULT_STYLE);
  const distance = Float32Array.from(
    whole.surface.triangles,
    (vertex, corner) => DISTANCES[vertex] + (corner === 3 ? 7 : 0),
  );
  const glb = stripesGlb({ ...whole, field: { ...whole.field, distance, byCorner: true } }, TRANSFORM, MODEL, 'fan');
  expect(await complaints(glb)).toEqual([]);
  const { document, numbers } = read(glb);
  const places = numbers(document.meshes[0].primitives[0].attributes['TEXCOORD_0']);
  expect(places).toHaveLength(18);
  expect([places[4], places[6]]).toEqual([0.75, 14.75]);
});
