/**
 * The surface as it is painted, with its stripes in a texture that any program shows: along U goes the pattern, once a period and
 * repeated, along V the colors over the distance. Both grow with distance, which is linear in a triangle, so stripes are as sharp where
 * they are narrower than edges. Relief is left out: no tangents belong to coordinates that are along one line.
 */
import { zlibSync } from 'fflate';
import type { DrawnSurface, DrawPose, DrawTransform } from '../protocol';
import type { LengthUnit } from '../length';
import { entry } from '../state/entry';
import { rampBytes, stripeFinish, type Style, WIDEST_LINE } from '../state/styles';
import { type Vector, vectorAt } from '../state/vector';
import { posed } from '../view/finer';
import type { ShownField } from '../view/layers';
import { GlbFile, joined } from './glb';
import { filePlace } from './nearest';

/** What is painted, and how. */
export interface Painted {
  surface: DrawnSurface;
  /** As it stands. */
  pose: DrawPose;
  field: ShownField;
  style: Style;
  /** The value that the last color is for. */
  most: number;
  /** Of the pattern, in the unit of the field. */
  period: number;
  /** By which the pattern has moved, in periods. */
  offset: number;
}

/** Texels of a period, and over all distances: many, so that colors still differ where the pattern is far away and its mean is shown. */
const [ACROSS, ALONG] = [256, 1024] as const;
/** Pixels of a diameter of the model where lines are as wide as they are given. */
const PIXELS = 800;
/** Of thin lines between two others: how many periods there are, how wide they are and how opaque; see surface.wgsl. */
const [SUBDIVISIONS, THINNER, FAINTER] = [5, 0.55, 0.45] as const;
/** The least half width of a flank, in periods; see style.rs. */
const LEAST_FLANK = 1e-3;
/** Of emission beyond 1. */
const EMISSION = 'KHR_materials_emissive_strength';
/** Of PNG: the first bytes, and the filter of rows that are told by the one above. */
const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const UP = 2;
/** Of what no source reaches, linear. */
const UNREACHED = { baseColorFactor: [0.4, 0.41, 0.42, 1], metallicFactor: 0, roughnessFactor: 0.6 };
/** A GLB file; `unit` is that of its lengths. */
export function stripesGlb(
  painted: Painted,
  transform: DrawTransform,
  { scale }: LengthUnit,
  name: string,
): Uint8Array<ArrayBuffer> {
  const { field, style } = painted;
  const { pose, triangles: corners, distances } = asDrawn(painted);
  // Where walls part vertices, each corner is a vertex of its own.
  const vertexOf = field.byCorner ? corners : Uint32Array.from(distances.keys());
  const turn: DrawTransform = { ...transform, center: [0, 0, 0], scale: 1 };
  const rows = (place: (vertex: number) => readonly number[]) => Float32Array.from(Array.from(vertexOf, place).flat());
  const positions = rows((vertex) =>
    filePlace(vectorAt(pose.positions, vertex), transform).map((value) => scale * value),
  );
  const normals = rows((vertex) => filePlace(vectorAt(pose.normals, vertex), turn));
  const coordinates = Float32Array.from(Array.from(distances, (value) => placeOf(value, painted)).flat());

  const file = new GlbFile();
  const attributes = {
    POSITION: file.vertices(positions, 'VEC3'),
    NORMAL: file.vertices(normals, 'VEC3'),
    TEXCOORD_0: file.vertices(coordinates, 'VEC2'),
  };
  const [reached, unreached]: [number[], number[]] = [[], []];
  for (let first = 0; first < corners.length; first += 3) {
    const triangle = [0, 1, 2].map((k) => (field.byCorner ? first + k : entry(corners, first + k)));
    const isReached = triangle.every((vertex) => Number.isFinite(entry(distances, vertex)));
    (isReached ? reached : unreached).push(...triangle);
  }
  const primitives = [reached, unreached].flatMap((triangles, material) =>
    triangles.length > 0 ? [{ attributes, indices: file.indices(Uint32Array.from(triangles)), material }] : [],
  );
  const materials = [materialOf(file, style), { pbrMetallicRoughness: UNREACHED, doubleSided: true }];
  const strongest = strongestGlow(style);
  return file.finish({
    ...(strongest > 1 ? { extensionsUsed: [EMISSION] } : {}),
    nodes: [{ name, mesh: 0 }],
    meshes: [{ primitives }],
    materials: unreached.length > 0 ? materials : materials.slice(0, 1),
  });
}

/** The triangles with a distance at each vertex, or corner: those that are drawn where the surface is coarse. */
function asDrawn({ surface, pose, field }: Painted): {
  pose: DrawPose;
  triangles: Uint32Array;
  distances: Float32Array;
} {
  const { finer } = surface;
  if (!finer || !field.finer) return { pose, triangles: surface.triangles, distances: field.distance };
  const [positions, normals] = posed(finer, pose.positions, pose.normals);
  return { pose: { positions, normals }, triangles: finer.mesh.triangles, distances: field.finer.distance };
}

/** Where a distance is in the textures. */
function placeOf(distance: number, { most, period, offset }: Painted): [number, number] {
  if (!Number.isFinite(distance)) return [0, 0];
  const share = most > 0 ? distance / most : 0;
  return [(period > 0 ? distance / period : 0) - offset, (Math.min(1, share) * (ALONG - 1) + 0.5) / ALONG];
}

function strongestGlow(style: Style): number {
  return Math.max(style.surface.glow, stripeFinish(style).glow);
}

function materialOf(file: GlbFile, style: Style): object {
  const shares = Array.from({ length: ACROSS }, (_, texel) => shareOf((texel + 0.5) / ACROSS, style));
  const { surface } = style;
  const stripes = stripeFinish(style);
  const ramps = rampBytes(style);
  const opacity = style.maps.includes('colour') ? 1 : 0;
  const color = (row: number, at: number): Vector => {
    const place = (at / (ALONG - 1)) * 255;
    const low = Math.min(254, Math.floor(place));
    const texel = (index: number, k: number) => linear(entry(ramps, 4 * (256 * row + index) + k));
    const channel = (k: number) => mixed(texel(low, k), texel(low + 1, k), place - low);
    return [channel(0), channel(1), channel(2)];
  };
  const between = Array.from({ length: ALONG }, (_, at) => color(0, at));
  const on = Array.from({ length: ALONG }, (_, at) => color(1, at));
  const baseColor = image(ACROSS, ALONG, (x, y) => {
    const share = opacity * entry(shares, x);
    return [0, 1, 2].map((k) => encoded(mixed(entry(entry(between, y), k), entry(entry(on, y), k), share)));
  });
  const finishes = image(ACROSS, 1, (x) => {
    const of = (part: 'metalness' | 'roughness') => 255 * mixed(surface[part], stripes[part], entry(shares, x));
    return [255, of('roughness'), of('metalness')];
  });
  const strongest = strongestGlow(style);
  const material = {
    pbrMetallicRoughness: {
      baseColorTexture: { index: file.texture(baseColor) },
      metallicRoughnessTexture: { index: file.texture(finishes) },
    },
    doubleSided: true,
  };
  if (strongest === 0) return material;
  const emission = image(ACROSS, ALONG, (x, y) => {
    const share = entry(shares, x);
    const light = (k: number) =>
      (entry(entry(between, y), k) * surface.glow * (1 - share) + entry(entry(on, y), k) * stripes.glow * share) /
      Math.max(1, strongest);
    return [0, 1, 2].map((k) => encoded(light(k)));
  });
  return {
    ...material,
    emissiveFactor: [1, 1, 1],
    emissiveTexture: { index: file.texture(emission) },
    ...(strongest > 1 ? { extensions: { [EMISSION]: { emissiveStrength: strongest } } } : {}),
  };
}

/** How much of a texel in the period stripes cover, as in surface.wgsl. */
function shareOf(at: number, { pattern, width, sharpness, period }: Style): number {
  if (pattern === 'none') return 0;
  if (pattern === 'lines') {
    const half = (width * WIDEST_LINE) / 2 / (period * PIXELS);
    const thin = lineShare(SUBDIVISIONS * at, THINNER * SUBDIVISIONS * half, SUBDIVISIONS / ACROSS);
    return Math.max(lineShare(at, half, 1 / ACROSS), FAINTER * thin);
  }
  const flank = Math.max(LEAST_FLANK, 0.5 * Math.min(width, 1 - width) * (1 - sharpness));
  const integral = (x: number) => rampUp(x - 0.5 + 0.5 * width, flank) - rampUp(x - 0.5 - 0.5 * width, flank);
  return ACROSS * (integral(at + 0.5 / ACROSS) - integral(at - 0.5 / ACROSS));
}

/** The share of a texel that lines at whole numbers cover. */
function lineShare(at: number, half: number, texel: number): number {
  const away = Math.abs(at - Math.round(at));
  return Math.min(1, Math.max(0, (half - away) / texel + 0.5));
}

/** The integral of a smooth step from 0 to 1 around zero, over a flank to either side. */
function rampUp(x: number, flank: number): number {
  const t = Math.min(1, Math.max(0, (x + flank) / (2 * flank)));
  return 2 * flank * t ** 3 * (1 - 0.5 * t) + Math.max(x - flank, 0);
}

function mixed(from: number, to: number, share: number): number {
  return from + (to - from) * share;
}

/** From a byte of sRGB to a linear value, and back (IEC 61966-2-1). */
function linear(byte: number): number {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

function encoded(value: number): number {
  return 255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);
}

/** A PNG (ISO/IEC 15948) of red, green and blue, each 0 to 255. */
function image(width: number, height: number, colorOf: (x: number, y: number) => readonly number[]): Uint8Array {
  const row = 1 + 3 * width;
  const pixels = new Uint8Array(height * row);
  let above: Uint8Array = new Uint8Array(row);
  for (let y = 0; y < height; y++) {
    const bytes = new Uint8Array(row);
    for (let x = 0; x < width; x++) bytes.set(colorOf(x, y).map(Math.round), 1 + 3 * x);
    // What differs from the row above: nothing where a color is the same at all distances.
    for (let at = 1; at < row; at++) pixels[y * row + at] = entry(bytes, at) - entry(above, at);
    pixels[y * row] = UP;
    above = bytes;
  }
  const header = new Uint8Array(13);
  new DataView(header.buffer).setUint32(0, width);
  new DataView(header.buffer).setUint32(4, height);
  header.set([8, 2, 0, 0, 0], 8);
  const data = zlibSync(pixels);
  return joined([Uint8Array.from(SIGNATURE), chunk('IHDR', header), chunk('IDAT', data), chunk('IEND', [])]);
}

function chunk(type: string, data: ArrayLike<number>): Uint8Array {
  const bytes = new Uint8Array(12 + data.length);
  const numbers = new DataView(bytes.buffer);
  numbers.setUint32(0, data.length);
  bytes.set(
    Array.from(type, (letter) => letter.charCodeAt(0)),
    4,
  );
  bytes.set(data, 8);
  numbers.setUint32(8 + data.length, checksum(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

/** Of a chunk: CRC-32, bit by bit. */
function checksum(bytes: Uint8Array): number {
  let rest = -1;
  for (const byte of bytes) {
    rest ^= byte;
    for (let bit = 0; bit < 8; bit++) rest = (rest >>> 1) ^ (rest & 1 ? 0xedb88320 : 0);
  }
  return ~rest >>> 0;
}
