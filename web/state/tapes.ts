/** Measuring tapes: chains of places between which lengths are measured, and the scale of lengths. */
import type { MeshPoint } from '../protocol';
import { POINTS } from './points';
import type { Codec } from './text';
import { entry } from './entry';

/** A chain of places, in order; a closed one leads back to its first. */
export interface Tape {
  points: readonly MeshPoint[];
  closed: boolean;
}

/** Least and greatest length of the file's unit in the unit of the page. */
export const SCALES = [1e-12, 1e12] as const;

/** A closed tape has a corner more than a tape there and back. */
export const LEAST_CLOSED = 3;

/** What follows the places of a closed tape in a link. */
const CLOSED = '!';

/** The ends of each leg of a tape. */
export function legsOf({ points, closed }: Tape): (readonly [MeshPoint, MeshPoint])[] {
  const [first, ...others] = points;
  const ends = closed && first && others.length > 0 ? [...others, first] : others;
  return ends.map((to, index) => [entry(points, index), to] as const);
}

/** Whether it has places enough to be closed, and is open. */
export function canClose(tape: Tape | undefined): boolean {
  return tape !== undefined && !tape.closed && tape.points.length >= LEAST_CLOSED;
}

/** With another place at the end of a tape; of a new one where there is none of that index. */
export function extended(tapes: readonly Tape[], index: number, point: MeshPoint): Tape[] {
  const tape = tapes.at(index);
  if (index < 0 || !tape) return [...tapes, { points: [point], closed: false }];
  return tapes.with(index, { ...tape, points: [...tape.points, point] });
}

function change(tapes: readonly Tape[], index: number, part: (tape: Tape) => Partial<Tape>): Tape[] {
  const tape = entry(tapes, index);
  return tapes.with(index, { ...tape, ...part(tape) });
}

export function moved(tapes: readonly Tape[], index: number, place: number, point: MeshPoint): Tape[] {
  return change(tapes, index, ({ points }) => ({ points: points.with(place, point) }));
}

export function close(tapes: readonly Tape[], index: number): Tape[] {
  return change(tapes, index, () => ({ closed: true }));
}

/** Without a place; a tape without places is none, and one with two is open. */
export function withoutPlace(tapes: readonly Tape[], index: number, place: number): Tape[] {
  const points = entry(tapes, index).points.toSpliced(place, 1);
  if (points.length === 0) return tapes.toSpliced(index, 1);
  return change(tapes, index, ({ closed }) => ({ points, closed: closed && points.length >= LEAST_CLOSED }));
}

/** Places with commas between them, tapes with semicolons; undefined where anything is no tape. */
export const TAPES: Codec<readonly Tape[]> = {
  encode: (tapes) =>
    tapes.map(({ points, closed }) => POINTS.encode(points) + (closed ? CLOSED : '')).join(';') || 'none',
  parse: (text) => {
    if (text === 'none') return [];
    const tapes = text.split(';').map(parseTape);
    return tapes.every((tape) => tape !== undefined) ? tapes : undefined;
  },
};

function parseTape(text: string): Tape | undefined {
  const closed = text.endsWith(CLOSED);
  const points = POINTS.parse(closed ? text.slice(0, -1) : text);
  return points && points.length >= (closed ? LEAST_CLOSED : 1) ? { points, closed } : undefined;
}
