/** What leaves the page: the direction that curves are seen from, and paths as files. */
import type { DrawTransform, DrawPath, Tracks } from '../protocol';
import { headOf, type LengthUnit, unitOfFile } from '../length';
import { type Vector, distance, scaled, vectorAt, vectorsIn } from '../state/vector';
import { filePlace } from './nearest';

/** Kinds of files of a path. */
export type PathFile = 'csv' | 'obj' | 'glb';

/** From the target to the eye as it is drawn, by the numbers of a camera. */
export function towardEye(camera: readonly number[] | null): Vector {
  const [yaw = 0, pitch = 0] = camera ?? [];
  return [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
}

/** The points of a path in the unit of the file. */
export function pathPoints({ points }: DrawPath, transform: DrawTransform): Vector[] {
  return vectorsIn(points).map((drawn) => filePlace(drawn, transform));
}

/** The points of each track. */
export function trackPoints({ points, counts }: Tracks): Vector[][] {
  let at = 0;
  return Array.from(counts, (count) => Array.from({ length: count }, () => vectorAt(points, at++)));
}

/** A path as rows of a table, with the length walked so far, as a line, or as one of glTF; `points` of the model, told in a unit. */
export function pathFile(
  kind: PathFile,
  points: readonly Vector[],
  unit: LengthUnit,
): string | Uint8Array<ArrayBuffer> {
  const told = inUnitOfFile(kind, [points], unit);
  if (kind !== 'csv') return linesFile(kind, 'path', told, unit);
  return [headOf(['length', 'x', 'y', 'z'], unit), ...told.flatMap(rowsOf), ''].join('\n');
}

/** The same of many, whose rows begin with the number of the track. */
export function tracksFile(
  kind: PathFile,
  tracks: readonly (readonly Vector[])[],
  unit: LengthUnit,
): string | Uint8Array<ArrayBuffer> {
  const told = inUnitOfFile(kind, tracks, unit);
  if (kind !== 'csv') return linesFile(kind, 'tracks', told, unit);
  const rows = told.flatMap((points, number) => rowsOf(points).map((row) => `${number},${row}`));
  return [`walker,${headOf(['length', 'x', 'y', 'z'], unit)}`, ...rows, ''].join('\n');
}

function inUnitOfFile(kind: PathFile, lines: readonly (readonly Vector[])[], unit: LengthUnit): Vector[][] {
  const { scale } = unitOfFile(kind, unit);
  return lines.map((points) => points.map((point) => scaled(point, scale)));
}

function linesFile(
  kind: 'obj' | 'glb',
  name: string,
  lines: readonly (readonly Vector[])[],
  unit: LengthUnit,
): string | Uint8Array<ArrayBuffer> {
  return kind === 'obj' ? linesObj(name, lines, unit) : linesGlb(name, lines);
}

function rowsOf(points: readonly Vector[]): string[] {
  let walked = 0;
  return points.map((point, index) => {
    walked += distance(point, points[index - 1] ?? point);
    return [walked, ...point].join(',');
  });
}

function linesObj(name: string, lines: readonly (readonly Vector[])[], { symbol }: LengthUnit): string {
  let last = 0;
  const elements = lines.map((points) => `l ${points.map(() => ++last).join(' ')}`);
  const vertices = lines.flat().map((point) => `v ${point.join(' ')}`);
  const comments = [`# ${name} on a surface by Heatwalk`, ...(symbol ? [`# lengths in ${symbol}`] : [])];
  return [...comments, ...vertices, ...elements, ''].join('\n');
}

/** Of glTF 2.0: a primitive that is pairs of vertices, numbers in single precision, a buffer of vertices. */
const [LINES, FLOAT, ARRAY_BUFFER] = [1, 5126, 34962];
/** Of its binary form: the file, its chunks, and the four characters that JSON is filled up with. */
const [GLTF, VERSION, JSON_CHUNK, BIN_CHUNK, SPACE] = [0x46546c67, 2, 0x4e4f534a, 0x004e4942, 0x20];

/** Segments of each line from its first point to its last (glTF 2.0, 3.7.2 and 4.4); line strips are not read by every program. */
function linesGlb(name: string, lines: readonly (readonly Vector[])[]): Uint8Array<ArrayBuffer> {
  const ends = lines.flatMap((points) =>
    points.slice(0, Math.max(1, points.length - 1)).flatMap((start, index) => [start, points[index + 1] ?? start]),
  );
  const positions = Float32Array.from(ends.flat());
  const along = [0, 1, 2].map((axis) => positions.filter((_, index) => index % 3 === axis));
  const accessor = {
    bufferView: 0,
    componentType: FLOAT,
    count: ends.length,
    type: 'VEC3',
    min: along.map((values) => values.reduce((one, other) => Math.min(one, other), Infinity)),
    max: along.map((values) => values.reduce((one, other) => Math.max(one, other), -Infinity)),
  };
  const root = {
    asset: { version: '2.0', generator: 'Heatwalk' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name, mesh: 0 }],
    meshes: [{ primitives: [{ mode: LINES, attributes: { POSITION: 0 } }] }],
    accessors: [accessor],
    bufferViews: [{ buffer: 0, byteLength: positions.byteLength, target: ARRAY_BUFFER }],
    buffers: [{ byteLength: positions.byteLength }],
  };
  const text = new TextEncoder().encode(JSON.stringify(root));
  const described = 4 * Math.ceil(text.length / 4);
  const bytes = new Uint8Array(12 + 8 + described + 8 + positions.byteLength);
  const header = new DataView(bytes.buffer);
  const put = (at: number, ...words: number[]) => words.forEach((word, i) => header.setUint32(at + 4 * i, word, true));
  put(0, GLTF, VERSION, bytes.length, described, JSON_CHUNK);
  bytes.fill(SPACE, 20, 20 + described).set(text, 20);
  put(20 + described, positions.byteLength, BIN_CHUNK);
  bytes.set(new Uint8Array(positions.buffer), 28 + described);
  return bytes;
}
