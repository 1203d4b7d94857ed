/** Lengths, areas and volumes as the page shows them. */
import {
  type LengthUnit,
  type ModelArea,
  type ModelLength,
  type ModelVolume,
  told,
  toldArea,
  toldVolume,
} from '../length';
import { numbers, type Phrase, type Plain, t, type Words } from '../texts';

const written = numbers({ maximumSignificantDigits: 3, useGrouping: false });
const scientific = numbers({ maximumSignificantDigits: 3, notation: 'scientific' });

/** A number of three digits; by a power of ten where it is very large or small. */
export function threeDigits(value: Plain): Phrase {
  const size = Math.abs(value);
  return size >= 1e12 || (size > 0 && size < 1e-9) ? scientific(value) : written(value);
}

/** A length with its unit. */
export function measure(value: ModelLength, unit: LengthUnit): Words {
  const number = threeDigits(told(value, unit));
  return unit.symbol === '' && String(number) === '1' ? t('1 unit') : t`${number} ${unitWords(unit)}`;
}

/** A unit, and that it is assumed where it is. */
export function unitWords({ symbol, assumed }: LengthUnit): Words {
  const name = symbol || t('units');
  return assumed ? t`${name} (assumed)` : name;
}

/** What a column or an axis is called, with its unit where there is one. */
export function withUnit(name: Words, symbol: string): Words {
  return symbol ? t`${name} (${symbol})` : name;
}

export function volume(value: ModelVolume, unit: LengthUnit): Words {
  const cubed = unit.symbol ? unitWords({ ...unit, symbol: `${unit.symbol}³` }) : t('cubic units');
  return t`${threeDigits(toldVolume(value, unit))} ${cubed}`;
}

export function area(value: ModelArea, unit: LengthUnit): Words {
  const squared = unit.symbol ? unitWords({ ...unit, symbol: `${unit.symbol}²` }) : t('square units');
  return t`${threeDigits(toldArea(value, unit))} ${squared}`;
}
