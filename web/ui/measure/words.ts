/** Tapes in words, and as a table for spreadsheets. */
import type { MeshPoint } from '../../protocol';
import { type LegState, lengthOf, type MeasuredTape, stateOf, straightOf } from '../../session/tapes';
import { entry } from '../../state/entry';
import { type LengthUnit, type ModelLength, ofModel, told, toldArea } from '../../length';
import { legsOf } from '../../state/tapes';
import { area, threeDigits } from '../../state/measures';
import { thousandths } from '../words';
import { t, type Words } from '../../texts';

export const STATE_WORDS: Record<LegState, Words> = {
  measuring: t('measuring…'),
  estimated: t('approximate so far'),
  exact: t('exact'),
  approximate: t('approximate'),
  cost: t('least cost, approximate'),
  none: t('not connected'),
};

/** Digits that a table has of a number: more than single precision gives. */
const DIGITS = 9;

/** A length, with a sign where it is not exact. Without the unit, which a table has in its head. */
export function lengthNumber(value: ModelLength, state: LegState, unit: LengthUnit): Words {
  if (!Number.isFinite(value)) return state === 'none' ? '–' : '…';
  const isApproximate = state === 'estimated' || state === 'approximate' || state === 'cost';
  const number = threeDigits(told(value, unit));
  return isApproximate ? t`≈ ${number}` : number;
}

/** The same with the unit, where there is one. */
export function lengthWords(value: ModelLength, state: LegState, unit: LengthUnit): Words {
  if (!Number.isFinite(value)) return state === 'none' ? t('not connected') : '…';
  const number = lengthNumber(value, state, unit);
  if (!unit.symbol && String(number) === '1') return t('1 unit');
  return t`${number} ${unit.symbol || t('units')}`;
}

/** The area within a closed tape on its label; null where there is none. */
export function areaLabel({ enclosure }: MeasuredTape, unit: LengthUnit): Words | null {
  if (enclosure?.kind !== 'sides') return null;
  const number = threeDigits(toldArea(enclosure.area, unit));
  const { symbol } = unit;
  return symbol ? t`area ${number} ${symbol}²` : t`area ${number}`;
}

/** Straight length as a share of that on the surface. */
export function ratioWords(straight: ModelLength, surface: ModelLength): Words {
  return surface > 0 ? thousandths(straight / surface) : '–';
}

/** The area within a closed tape, or why there is none; null for an open one, and while it is not known. */
export function enclosureWords({ tape, legs, enclosure }: MeasuredTape, unit: LengthUnit): Words | null {
  if (!tape.closed) return null;
  if (legs.some(({ leg }) => leg && !('triangles' in leg))) {
    return t('This tape leads through the inside, where no one surface spans it, so it encloses no area.');
  }
  if (!enclosure) return null;
  if (enclosure.kind === 'sides') return t`Area enclosed: ${area(enclosure.area, unit)}.`;
  return NO_AREA[enclosure.kind];
}

const NO_AREA = {
  whole: t('This tape does not part the surface in two, so it encloses no area.'),
  crossed: t('This tape crosses itself, so it encloses no area.'),
  sideless: t('The surface has no two sides of this tape, so it encloses no area.'),
} as const;

export function placeName(point: MeshPoint): Words {
  if ('vertex' in point) return t`vertex ${point.vertex}`;
  const weights = point.weights.map((weight) => Number(weight.toFixed(4))).join(' ');
  return 'face' in point ? t`triangle ${point.face}: ${weights}` : t`tetrahedron ${point.tetrahedron}: ${weights}`;
}

/** A line a leg, then one with the sums and the area of each tape. */
export function csvOf(tapes: readonly MeasuredTape[], unit: LengthUnit): string {
  const long = (value: ModelLength | undefined) => (value === undefined ? '' : cell(told(value, unit)));
  const { symbol } = unit;
  const header = ['tape', 'leg', 'from', 'to', 'surface', 'straight', 'ratio', 'cost', 'area', 'accuracy', 'unit'];
  const rows = tapes.flatMap((measured, index) => {
    const ends = legsOf(measured.tape);
    const legs = measured.legs.map(({ leg, state, straight }, k) => {
      const surface = leg?.length ?? ofModel(NaN);
      const names = entry(ends, k).map(placeName);
      const figures = [long(surface), long(straight), cell(straight / surface), long(leg?.cost), ''];
      return [index + 1, k + 1, ...names, ...figures, STATE_WORDS[state], symbol];
    });
    const [surface, straight] = [lengthOf(measured), straightOf(measured)];
    const enclosed = measured.enclosure?.kind === 'sides' ? cell(toldArea(measured.enclosure.area, unit)) : '';
    const sums = [long(surface), long(straight), cell(straight / surface), '', enclosed];
    return [...legs, [index + 1, 'total', '', '', ...sums, STATE_WORDS[stateOf(measured)], symbol]];
  });
  return [header, ...rows].map((row) => row.map(quoted).join(',')).join('\r\n') + '\r\n';
}

/** A number of a table; nothing where it is none. */
function cell(value: number): string {
  return Number.isFinite(value) ? String(Number(value.toPrecision(DIGITS))) : '';
}

/** As RFC 4180 wants it. */
function quoted(value: Words | number): string {
  const text = String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
