/** What leaves the page: the direction that curves are seen from, and paths as files. */
import type { Tracks } from '../protocol';
import { headOf, type LengthUnit, unitOfFile } from '../length';
import { type Vector, distance, scaled, vectorAt } from '../state/vector';
import { GlbFile, LINES } from './glb';

/** Kinds of files of a path. */
export type PathFile = 'csv' | 'obj' | 'glb';

/** From the target to the eye as it is drawn, by the numbers of a camera. */
export function towardEye(camera: readonly number[] | null): Vector {
  const [yaw = 0, pitch = 0] = camera ?? [];
  return [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
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

/** Segments of each line from its first point to its last (glTF 2.0, 3.7.2 and 4.4); line strips are not read by every program. */
function linesGlb(name: string, lines: readonly (readonly Vector[])[]): Uint8Array<ArrayBuffer> {
  const ends = lines.flatMap((points) =>
    points.slice(0, Math.max(1, points.length - 1)).flatMap((start, index) => [start, points[index + 1] ?? start]),
  );
  const file = new GlbFile();
  const position = file.vertices(Float32Array.from(ends.flat()), 'VEC3');
  return file.finish({
    nodes: [{ name, mesh: 0 }],
    meshes: [{ primitives: [{ mode: LINES, attributes: { POSITION: position } }] }],
  });
}
