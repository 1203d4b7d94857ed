// The models that `npm run bench -- --models` measures, made in code: GLB files of balls.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import draco from 'draco3d';
import { MeshoptEncoder } from 'meshoptimizer';
import { PNG } from 'pngjs';
import { GlbWriter, pack } from '../glb.mjs';
import { root } from '../steps.mjs';

const folder = join(root, 'target', 'bench', 'models');

/** Centres of neighbouring balls of radius 1 in an assembly: they pierce each other a little. */
const APART = 1.9;
/** A near copy is larger by this share, and turned by this angle: it lies within the tolerance of contacts everywhere. */
const LARGER = 5e-4;
const TURNED = 0.3;
/** Texels along a side of an image of noise, which hardly compresses: 3.6 MB. */
const TEXELS = 1100;
/** Bits of a compressed coordinate. */
const BITS = 14;
/** Bytes of three coordinates of 16 bits, padded to whole words. */
const STRIDE = 8;

/** Of several parts, with the milliseconds in which contacts are to be found. */
export function assemblies() {
  const copy = { radius: 1 + LARGER, turn: TURNED };
  return [
    { name: '14 parts', bar: 100, file: write('14_parts.glb', assembly(lattice(2, 7, 1), 44, 24)) },
    { name: '112 parts', bar: 500, file: write('112_parts.glb', assembly(lattice(4, 4, 7), 33, 16)) },
    { name: 'near copies', bar: 100, file: write('near_copies.glb', glb([ball(120, 60), ball(120, 60, copy)])) },
  ];
}

/** A ball of 14,960 triangles under an image, in 4 MB. */
export function textured() {
  return write('textured.glb', glb([ball(88, 86)], image()));
}

/** Of about so many triangles, as Draco and as meshopt compress it. */
export async function compressed(triangles) {
  const rows = Math.round(Math.sqrt(triangles / 2));
  const mesh = ball(rows, rows + 1);
  const count = mesh.triangles.length / 3;
  await MeshoptEncoder.ready;
  return [
    {
      name: 'Draco',
      triangles: count,
      file: write(`draco_${count}.glb`, byDraco(mesh, await draco.createEncoderModule())),
    },
    { name: 'meshopt', triangles: count, file: write(`meshopt_${count}.glb`, byMeshopt(mesh)) },
  ];
}

function write(name, content) {
  mkdirSync(folder, { recursive: true });
  const file = join(folder, name);
  writeFileSync(file, content);
  return file;
}

function lattice(x, y, z) {
  return Array.from({ length: x * y * z }, (_, index) =>
    [index % x, Math.floor(index / x) % y, Math.floor(index / (x * y))].map((step) => APART * step),
  );
}

function assembly(centres, columns, rows) {
  return glb(centres.map((centre) => ball(columns, rows, { centre })));
}

/** 2 · columns · (rows − 1) triangles, with a seam for texture coordinates; vertices on both sides of it are equal. */
function ball(columns, rows, { centre = [0, 0, 0], radius = 1, turn = 0 } = {}) {
  const [positions, normals, uv, triangles] = [[], [], [], []];
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) {
      // At the poles exactly, so that these are one vertex each.
      const ring = row % rows === 0 ? 0 : Math.sin((Math.PI * row) / rows);
      const angle = turn + (2 * Math.PI * (column % columns)) / columns;
      const normal = [ring * Math.cos(angle), Math.cos((Math.PI * row) / rows), -ring * Math.sin(angle)];
      normals.push(...normal);
      positions.push(...normal.map((along, axis) => centre[axis] + radius * along));
      uv.push(column / columns, row / rows);
    }
  }
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const a = row * (columns + 1) + column;
      const b = a + columns + 1;
      if (row < rows - 1) triangles.push(a, b, b + 1);
      if (row > 0) triangles.push(a, b + 1, a + 1);
    }
  }
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    uv: Float32Array.from(uv),
    triangles: Uint32Array.from(triangles),
  };
}

/** A part of each mesh; with normals and texture coordinates where there is an image, a PNG file. */
function glb(meshes, texture) {
  const writer = new GlbWriter();
  const material = texture && {
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } }],
    textures: [{ source: 0 }],
    images: [{ bufferView: writer.view(texture), mimeType: 'image/png' }],
  };
  const primitive = (mesh) => ({
    attributes: {
      POSITION: writer.accessor(mesh.positions, 'VEC3', bounds(mesh)),
      ...(texture && { NORMAL: writer.accessor(mesh.normals, 'VEC3'), TEXCOORD_0: writer.accessor(mesh.uv, 'VEC2') }),
    },
    indices: writer.accessor(mesh.triangles, 'SCALAR'),
    ...(texture && { material: 0 }),
  });
  return writer.pack({
    nodes: meshes.map((_, mesh) => ({ mesh, name: `part ${mesh + 1}` })),
    meshes: meshes.map((mesh) => ({ primitives: [primitive(mesh)] })),
    ...material,
  });
}

function bounds({ positions }) {
  const along = (axis) => positions.filter((_, index) => index % 3 === axis);
  const extreme = (of) => [0, 1, 2].map((axis) => along(axis).reduce((most, value) => of(most, value)));
  return { min: extreme(Math.min), max: extreme(Math.max) };
}

/** Noise, the same at every run (the generator of Park and Miller, "Random number generators: good ones are hard to find", 1988). */
function image() {
  const png = new PNG({ width: TEXELS, height: TEXELS, colorType: 2 });
  let state = 1;
  for (let index = 0; index < png.data.length; index++) {
    state = (state * 48271) % 0x7fffffff;
    png.data[index] = index % 4 === 3 ? 255 : state & 255;
  }
  return PNG.sync.write(png, { colorType: 2, filterType: 0 });
}

/** As glTF-Transform compresses by default: Edgebreaker, positions of 14 bits. */
function byDraco(mesh, module) {
  const [encoder, builder, shape] = [new module.Encoder(), new module.MeshBuilder(), new module.Mesh()];
  const vertices = mesh.positions.length / 3;
  const faces = mesh.triangles.length / 3;
  builder.AddFacesToMesh(shape, faces, mesh.triangles);
  const attribute = builder.AddFloatAttributeToMesh(shape, module.POSITION, vertices, 3, mesh.positions);
  encoder.SetEncodingMethod(module.MESH_EDGEBREAKER_ENCODING);
  encoder.SetAttributeQuantization(module.POSITION, BITS);
  const content = new module.DracoInt8Array();
  const length = encoder.EncodeMeshToDracoBuffer(shape, content);
  const bytes = padded(Buffer.from(Array.from({ length }, (_, index) => content.GetValue(index))));
  const primitive = {
    attributes: { POSITION: 0 },
    indices: 1,
    extensions: { KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: attribute } } },
  };
  const document = {
    ...onePart(primitive, ['KHR_draco_mesh_compression']),
    buffers: [{ byteLength: bytes.length }],
    bufferViews: [{ buffer: 0, byteLength: length }],
    accessors: [
      { componentType: 5126, type: 'VEC3', count: vertices, ...bounds(mesh) },
      { componentType: 5125, type: 'SCALAR', count: 3 * faces },
    ],
  };
  return pack(JSON.stringify(document), bytes);
}

/** Normalized positions of 16 bits, ordered for compression. */
function byMeshopt({ positions, triangles }) {
  const [order, count] = MeshoptEncoder.reorderMesh(triangles, true, true);
  const largest = positions.reduce((most, along) => Math.max(most, Math.abs(along)), 0);
  const vertices = Buffer.alloc(STRIDE * count);
  for (const [vertex, place] of order.entries()) {
    for (const axis of place < count ? [0, 1, 2] : []) {
      const level = Math.round((32767 * positions[3 * vertex + axis]) / largest);
      vertices.writeInt16LE(level, STRIDE * place + 2 * axis);
    }
  }
  const parts = [
    encoded('ATTRIBUTES', vertices, count, STRIDE),
    encoded('TRIANGLES', Buffer.from(triangles.buffer), triangles.length, 4),
  ];
  let [packedAt, plainAt] = [0, 0];
  const bufferViews = parts.map(({ mode, plain, elements, size, bytes }) => {
    const place = { buffer: 0, byteOffset: packedAt, byteLength: bytes.length };
    const compression = { ...place, byteStride: size, count: elements, mode };
    const view = {
      buffer: 1,
      byteOffset: plainAt,
      byteLength: plain.length,
      ...(mode === 'ATTRIBUTES' && { byteStride: size }),
      extensions: { EXT_meshopt_compression: compression },
    };
    packedAt += padded(bytes).length;
    plainAt += plain.length;
    return view;
  });
  const primitive = { attributes: { POSITION: 0 }, indices: 1 };
  const document = {
    ...onePart(primitive, ['EXT_meshopt_compression', 'KHR_mesh_quantization']),
    buffers: [
      { byteLength: packedAt },
      { byteLength: plainAt, extensions: { EXT_meshopt_compression: { fallback: true } } },
    ],
    bufferViews,
    accessors: [
      {
        bufferView: 0,
        componentType: 5122,
        normalized: true,
        type: 'VEC3',
        count,
        min: [-32767, -32767, -32767],
        max: [32767, 32767, 32767],
      },
      { bufferView: 1, componentType: 5125, type: 'SCALAR', count: triangles.length },
    ],
  };
  return pack(JSON.stringify(document), Buffer.concat(parts.map(({ bytes }) => padded(bytes))));
}

function encoded(mode, plain, elements, size) {
  const bytes = Buffer.from(MeshoptEncoder.encodeGltfBuffer(plain, elements, size, mode));
  return { mode, plain, elements, size, bytes };
}

function onePart(primitive, extensions) {
  return {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [primitive] }],
    extensionsUsed: extensions,
    extensionsRequired: extensions,
  };
}

function padded(bytes) {
  return Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4)]);
}
