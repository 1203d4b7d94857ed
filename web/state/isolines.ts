/** At which distances isolines are, and how a link writes it. */
import { Failure } from '../error';
import type { IsolineWish } from '../protocol';
import { inModel, type LengthUnit, MODEL, type ModelLength, ofModel, typed } from '../length';
import { measure } from './measures';
import { amount, parseAmount, precise } from './text';
import { count, t } from '../texts';

/** As many as a table has rows for. */
const MOST = 1000;

/** As a person types it, in the unit that is shown: one number is a spacing, several are values, and so is one with a comma; nothing is null. */
export function parseIsolines(text: string, unit: LengthUnit): IsolineWish | null {
  const words = text.split(/[\s,;]+/).filter((word) => word !== '');
  const numbers = words.map(Number);
  const bad = words.find((word) => !(Number(word) >= 0 && Number(word) < Infinity));
  if (bad !== undefined)
    throw new Failure(t`${bad} is no distance. Give a spacing, or values with commas between them.`);
  const [spacing] = numbers;
  if (spacing === undefined) return null;
  if (numbers.length > MOST)
    throw new Failure(t`${count(numbers.length)} values are too many; give at most ${count(MOST)}, or a spacing.`);
  const isList = numbers.length > 1 || /[,;]/.test(text);
  if (!isList && spacing === 0) throw new Failure(t('A spacing of 0 has no end of isolines. Give a larger one.'));
  return isList ? wishOf(numbers, unit) : { values: [], spacing: inModel(spacing, unit) };
}

/** What distances may differ by, as a share, and be the same: rounding. */
const ROUNDING = 1e-12;

/** The same wish, where a surface has isolines of it: some are not beyond the largest distance. */
export function withinReach(wish: IsolineWish, largest: ModelLength, unit: LengthUnit): IsolineWish {
  const { values, spacing } = wish;
  const least = values.find((value) => values.every((other) => value <= other));
  // Once is enough.
  const said = { ...unit, assumed: false };
  if (least === undefined && spacing >= largest)
    throw new Failure(
      t`A spacing of ${measure(spacing, said)} is not below the largest distance, ${measure(largest, unit)}. Give a smaller one.`,
    );
  if (least !== undefined && least > largest * (1 + ROUNDING))
    throw new Failure(
      t`${measure(least, said)} is beyond the largest distance, ${measure(largest, unit)}. Give smaller values.`,
    );
  return wish;
}

function wishOf(values: readonly number[], unit: LengthUnit): IsolineWish {
  return { values: values.map((value) => inModel(value, unit)), spacing: ofModel(0) };
}

/** What `parseIsolines` reads as the same, up to the digits that `written` writes. */
export function isolinesText(wish: IsolineWish | null, unit: LengthUnit, written = amount): string {
  if (!wish) return '';
  if (wish.values.length === 0) return written(typed(wish.spacing, unit));
  const values = wish.values.map((value) => written(typed(value, unit))).join();
  return wish.values.length === 1 ? `${values},` : values;
}

/** In a link; `stripes` where isolines are at the period of these. */
export function encodeIsolines(wish: IsolineWish | null): string {
  return isolinesText(wish, MODEL, precise) || 'stripes';
}

/** What `encodeIsolines` wrote; undefined for other text. */
export function decodeIsolines(text: string): IsolineWish | null | undefined {
  if (text === 'stripes') return null;
  const words = text.split(',');
  const isSpacing = words.length === 1;
  const numbers = (words.length === 2 && words[1] === '' ? words.slice(0, 1) : words).map(parseAmount);
  if (numbers.length > MOST || !numbers.every((value) => value !== undefined)) return undefined;
  const [spacing = 0] = numbers;
  if (!isSpacing) return wishOf(numbers, MODEL);
  return spacing > 0 ? { values: [], spacing: ofModel(spacing) } : undefined;
}
