/** A cloud of points made in code. */
import type { MeshInput } from '../protocol';
import { cross, minus, moved, normalized, type Vector } from './vector';

const POINTS = 8000;
const RADIUS = 0.6;
/** Turns from one point to the next, by which points of a tube are nowhere in rows. */
const GOLDEN = (3 - Math.sqrt(5)) / 2;
const STEP = 1e-3;

/** A trefoil knot. */
function middle(turn: number): Vector {
  return [Math.sin(turn) + 2 * Math.sin(2 * turn), Math.cos(turn) - 2 * Math.cos(2 * turn), -1.2 * Math.sin(3 * turn)];
}

/** Points of a tube around it, as a file of lines of three numbers. */
export function knotOfPoints(): MeshInput {
  const lines = Array.from({ length: POINTS }, (_, index) => {
    const turn = (2 * Math.PI * index) / POINTS;
    const [before, at, after] = [middle(turn - STEP), middle(turn), middle(turn + STEP)];
    const along = normalized(minus(after, before));
    const side = normalized(cross(along, [0, 0, 1]));
    const angle = 2 * Math.PI * GOLDEN * index;
    const place = moved(moved(at, side, RADIUS * Math.cos(angle)), cross(side, along), RADIUS * Math.sin(angle));
    return place.map((value) => value.toFixed(5)).join(' ');
  });
  const path = 'knot.xyz';
  return { kind: 'files', mesh: path, files: [{ path, content: new Blob([lines.join('\n')]) }] };
}
