/** What the legend has of colors that lie on the surface in the place of those of the field. */
import type { CurveDistances } from '../../protocol';
import type { Session } from '../../session/session';
import { type LengthUnit, ofModel, told } from '../../length';
import { roundBelow, roundStep } from '../../state/legend';
import { cssOf } from '../../state/linear';
import { measure, threeDigits, withUnit } from '../../state/measures';
import { colourOfSide } from '../../state/sides';
import { type Bar, LEAST_APART } from './bar';
import { counted, t, type Words } from '../../texts';

const LINE = 'rgb(20,20,20)';
/** Half of a line, CSS pixels. */
const HALF = 0.7;

export interface Beside {
  bar: Bar | null;
  words: Words;
}

/** That of cells and of distance from curves, where they are shown; null: neither is. */
export function besideOf({ offsets, cells, scene }: Session, unit: LengthUnit, ticks: number): Beside | null {
  if (offsets.value) return ofCurves(offsets.value, unit, scene.state.style.period, ticks);
  const areas = cells.value?.areas;
  return areas ? { bar: null, words: counted(areas.length, 'Colors of {0} cell.', 'Colors of {0} cells.') } : null;
}

function ofCurves({ range }: CurveDistances, unit: LengthUnit, period: number, count: number): Beside {
  const [least, most] = range;
  const largest = Math.max(-least, most);
  const at = (value: number) => (value - least) / (most - least);
  const whole = told(ofModel(most - least), unit);
  const step = Math.min(roundStep(whole, count), roundBelow(told(ofModel(largest), unit)));
  const [first, last] = [Math.ceil(told(least, unit) / step), Math.floor(told(most, unit) / step)];
  const scale = told(ofModel(1), unit);
  const ticks = Array.from({ length: last - first + 1 }, (_, k) => {
    const value = Number(((first + k) * step).toPrecision(6));
    return { at: at(value / scale), text: String(threeDigits(value)) };
  });
  const [inside, outside] = [measure(ofModel(-least), unit), measure(most, unit)];
  return {
    bar: {
      title: String(withUnit(t('From curves'), unit.symbol)),
      ticks,
      colours: (pixels, density) => (share) => {
        const value = least + share * (most - least);
        const lines = value / (period * largest);
        const apart = (period * largest * pixels) / (most - least);
        const isLine = Math.abs(lines - Math.round(lines)) * apart < HALF * density;
        if (isLine && apart > LEAST_APART * density) return LINE;
        return cssOf(colourOfSide(value < 0, Math.abs(value) / largest));
      },
      key: JSON.stringify([range, period]),
    },
    words: t`Distance from curves: ${inside} inside to ${outside} outside, by color.`,
  };
}
