/** A plane that cuts the surface in curves, whose lengths are measured. */
import { type CutPlane, INSIDE_RANGES } from './inside';
import { type Codec, number } from './text';

/** Level, in the middle. */
export const LEVEL_GIRTH: CutPlane = { turn: 0, tilt: 90, place: 0 };

const NAMES = ['turn', 'tilt', 'place'] as const;

/** Turn, tilt and place, with commas between them. */
export const GIRTH: Codec<CutPlane | null> = {
  encode: (plane) => (plane ? NAMES.map((name) => number(plane[name])).join(',') : 'none'),
  parse: (text) => {
    if (text === 'none') return null;
    const values = text.split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
    const [turn = NaN, tilt = NaN, place = NaN, ...more] = values;
    const plane = { turn, tilt, place };
    const isWithin = NAMES.every((name) => {
      const [least, most] = INSIDE_RANGES[name];
      return plane[name] >= least && plane[name] <= most;
    });
    return isWithin && more.length === 0 ? plane : undefined;
  },
};
