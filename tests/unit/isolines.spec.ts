import { expect, test } from '@playwright/test';
import { type LengthUnit, MODEL, ofModel } from '../../web/length';
import { decodeIsolines, encodeIsolines, isolinesText, parseIsolines, withinReach } from '../../web/state/isolines';

test('isolines are at a spacing, at values, or where the stripes are', () => {
  expect(parseIsolines(' ', MODEL)).toBeNull();
  expect(parseIsolines(' 0.5 ', MODEL)).toEqual({ values: [], spacing: 0.5 });
  expect(parseIsolines('0.5,', MODEL)).toEqual({ values: [0.5], spacing: 0 });
  expect(parseIsolines('0.5, 1e0;2', MODEL)).toEqual({ values: [0.5, 1, 2], spacing: 0 });
  expect(() => parseIsolines('0.5, far', MODEL)).toThrow('far is no distance');
  expect(() => parseIsolines('-1', MODEL)).toThrow('-1 is no distance');
  expect(() => parseIsolines('0', MODEL)).toThrow('A spacing of 0');
  expect(() => parseIsolines('1,'.repeat(1001), MODEL)).toThrow('1,001 values are too many');
});

test('a link and the field of the panel say the same of them', () => {
  for (const text of ['', '0.5', '0.5,', '0.5,1,2', '1.5e-7,3e22']) {
    const wish = parseIsolines(text, MODEL);
    expect(isolinesText(wish, MODEL)).toBe(text);
    expect(decodeIsolines(encodeIsolines(wish))).toEqual(wish);
  }
});

test('a link keeps the digits of what was converted', () => {
  const inches = parseIsolines(String(10 / 25.4), MODEL);
  expect(decodeIsolines(encodeIsolines(inches))?.spacing).toBeCloseTo(10 / 25.4, 11);
});

test('other text in a link is refused', () => {
  for (const text of ['', '0', '-1', 'all', '1,,2', '1,x', ',', '1,'.repeat(1001)]) {
    expect(decodeIsolines(text), text.slice(0, 20)).toBeUndefined();
  }
});

test('what a surface has no isolines of is refused in the unit that is shown, with few digits', () => {
  const inches: LengthUnit = { symbol: 'in', assumed: true, scale: 1 / 25.4 };
  const largest = ofModel(116.61903789690601);
  const refused = (text: string) => {
    const wish = parseIsolines(text, inches);
    return () => wish && withinReach(wish, largest, inches);
  };
  expect(refused('1000')).toThrow(
    /^A spacing of 1000 in is not below the largest distance, 4\.59 in \(assumed\)\. Give a smaller one\.$/,
  );
  expect(refused('1000, 2000')).toThrow(
    /^1000 in is beyond the largest distance, 4\.59 in \(assumed\)\. Give smaller values\.$/,
  );
  // Some values are there, and the largest distance itself is, whatever rounding makes of it.
  for (const text of ['4', '1000, 2', `${116.61903789690602 / 25.4},`]) expect(refused(text)).not.toThrow();
});
