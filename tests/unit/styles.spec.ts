import { expect, test } from '@playwright/test';
import { STYLES, RAMP_NAMES, rampBytes } from '../../web/state/styles';
import { PRESETS } from '../../web/state/presets';

test('every ramp has 256 opaque colors and different ends', () => {
  for (const name of RAMP_NAMES) {
    const bytes = rampBytes({ ramp: name, stripe: '#123456' });
    expect(bytes).toHaveLength(2048);
    expect(bytes.filter((_, i) => i % 4 === 3).every((alpha) => alpha === 255)).toBe(true);
    expect([...bytes.subarray(0, 3)]).not.toEqual([...bytes.subarray(1020, 1023)]);
    expect([...bytes.subarray(1024, 1027)]).toEqual([0x12, 0x34, 0x56]);
    expect([...rampBytes({ ramp: 'paper', stripe: name }).subarray(1024)]).toEqual([...bytes.subarray(0, 1024)]);
  }
});

/** Relative luminance as WCAG defines it. */
function luminance(colour: readonly number[]): number {
  const [r, g, b] = colour.map((value) => (value <= 10.3 ? value / 3294 : ((value / 255 + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

test('stripes contrast with their ramp on most of the model', () => {
  for (const style of STYLES) {
    const { name } = style;
    const bytes = rampBytes(style);
    const luminanceAt = (texel: number) => luminance([...bytes.subarray(4 * texel, 4 * texel + 3)]);
    let clear = 0;
    for (let i = 0; i < 256; i++) {
      const [ground, paint] = [luminanceAt(i), luminanceAt(256 + i)];
      const contrast = (Math.max(paint, ground) + 0.05) / (Math.min(paint, ground) + 0.05);
      if (contrast >= 1.5) clear += 1;
    }
    expect(clear / 256, name).toBeGreaterThan(0.75);
  }
});

test('the names of presets and of styles are unique', () => {
  for (const names of [PRESETS.map(({ id }) => id), STYLES.map(({ name }) => name)]) {
    expect(new Set(names).size).toBe(names.length);
  }
  expect(PRESETS.length).toBeGreaterThanOrEqual(8);
});
