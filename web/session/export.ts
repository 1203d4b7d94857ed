/** What leaves the page: curves, distances and paths as files. */
import type { DrawTransform, IsolineWish, SurfacePath } from '../protocol';
import type { Up } from '../wasm/contract';
import type { Session } from './session';

type Vector = [number, number, number];

/** The spacing of isolines that lie where the stripes do, in the unit of the file. */
export function stripeSpacing({ scene, shown }: Session): number {
  return scene.state.style.period * (shown.value?.places.diameter ?? 0);
}

/** The isolines at the stripes; null where there is none, or no surface. */
export function stripeWish(session: Session): IsolineWish | null {
  const { opened, answer } = session.shown.value ?? {};
  const spacing = stripeSpacing(session);
  const isThere = answer?.field && !opened?.interior && spacing > 0 && spacing < answer.field.maxDistance;
  return isThere ? { values: [], spacing } : null;
}

/** Reads `0.5` as a spacing, and `0.5, 1` as values; nothing as the spacing of the stripes. */
export function wishOf(text: string, spacing: number): IsolineWish {
  const words = text.split(/[\s,;]+/).filter((word) => word !== '');
  const numbers = words.map(Number);
  const bad = words.find((_, index) => !Number.isFinite(numbers[index]));
  if (bad !== undefined) throw new Error(`${bad} is no distance. Give a spacing, or values with commas between them.`);
  if (numbers.length === 0) return { values: [], spacing };
  const isList = numbers.length > 1 || /[,;]/.test(text);
  return isList ? { values: numbers, spacing: 0 } : { values: [], spacing: numbers[0] };
}

/** From the target to the eye as it is drawn, by the numbers of a camera. */
export function towardEye(camera: readonly number[] | null): Vector {
  const [yaw = 0, pitch = 0] = camera ?? [];
  return [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
}

/** What was turned so that `up` is drawn along Y, as it is in the file. */
const IN_FILE: Record<Up, (drawn: Vector) => Vector> = {
  y: ([x, y, z]) => [x, y, z],
  z: ([x, y, z]) => [x, -z, y],
  x: ([x, y, z]) => [y, -x, z],
  '-y': ([x, y, z]) => [x, -y, -z],
  '-z': ([x, y, z]) => [x, z, -y],
  '-x': ([x, y, z]) => [-y, x, z],
};

/** The points of a path in the unit of the file. */
export function pathPoints({ points }: SurfacePath, { center, scale, up }: DrawTransform): Vector[] {
  return Array.from({ length: points.length / 3 }, (_, index) => {
    const drawn = points.subarray(3 * index, 3 * index + 3);
    const turned = IN_FILE[up]([drawn[0], drawn[1], drawn[2]]);
    return [0, 1, 2].map((axis) => turned[axis] / scale + center[axis]) as Vector;
  });
}

/** A path as rows of a table, with the length walked so far, or as a line. */
export function pathFile(kind: 'csv' | 'obj', points: readonly Vector[]): string {
  if (kind === 'obj') {
    const line = points.map((_, index) => index + 1).join(' ');
    return ['# path on a surface by Heatwalk', ...points.map((point) => `v ${point.join(' ')}`), `l ${line}`, ''].join(
      '\n',
    );
  }
  let walked = 0;
  const rows = points.map((point, index) => {
    const before = points[Math.max(0, index - 1)];
    walked += Math.hypot(...point.map((coordinate, axis) => coordinate - before[axis]));
    return [walked, ...point].join(',');
  });
  return ['length,x,y,z', ...rows, ''].join('\n');
}
