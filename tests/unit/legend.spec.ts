import { expect, test } from '@playwright/test';
import { entry } from '../../web/state/entry';
import { MODEL } from '../../web/length';
import { coverage, largestWords, roundBelow, roundStep, ticksOf, titleWords } from '../../web/state/legend';
import { STYLES } from '../../web/state/styles';
import type { Content } from '../../web/ui/stage/content';
import { drawLegend } from '../../web/ui/stage/draw';
import type { PlaneContext } from '../../web/view/view';

const distance = (most: number) => ({ kind: 'distance' as const, most, isCost: false });
const told = (ticks: ReturnType<typeof ticksOf>) => ticks.map(({ text }) => String(text));

test('steps are 1, 2 or 5 times a power of ten, and no more of them than asked for', () => {
  expect([1, 12.6, 99, 0.00031, 5, 2.5].map((most) => roundStep(most, 5))).toEqual([0.2, 5, 20, 0.0001, 1, 0.5]);
  expect([1, 12.6, 99, 0.00031, 5, 0.2].map(roundBelow)).toEqual([1, 10, 50, 0.0002, 5, 0.2]);
  for (let most = 1e-7; most < 1e7; most *= 1.37) {
    const ticks = ticksOf(distance(most), MODEL, 5);
    expect(ticks.length).toBeGreaterThanOrEqual(3);
    expect(ticks.length).toBeLessThanOrEqual(6);
    expect(entry(ticks, ticks.length - 1).at).toBeLessThanOrEqual(1);
  }
});

test('numbers are in the unit that is shown, at the places where the model has them', () => {
  const inMillimeters = { symbol: 'mm', assumed: false, scale: 1000 };
  const ticks = ticksOf(distance(0.25), inMillimeters, 5);
  expect(told(ticks)).toEqual(['0', '50', '100', '150', '200', '250']);
  expect(entry(ticks, 1).at).toBeCloseTo(0.2, 12);
  expect(String(titleWords(distance(1), inMillimeters))).toBe('Distance (mm)');
  expect(String(titleWords(distance(1), { ...inMillimeters, assumed: true }))).toBe('Distance (mm, assumed)');
  expect(String(titleWords({ ...distance(1), isCost: true }, MODEL))).toBe('Least cost (units)');
  expect(String(largestWords(distance(0.25), inMillimeters))).toBe('250 mm');
});

test('heat is told in powers of ten below the hottest place, errors in percent', () => {
  const heat = { kind: 'heat' as const, most: 23.4, isCost: false };
  expect(told(ticksOf(heat, MODEL, 5))).toEqual(['1', '10⁻⁵', '10⁻¹⁰', '10⁻¹⁵', '10⁻²⁰']);
  expect(String(largestWords(heat, MODEL))).toBe('10⁻²³');
  expect(told(ticksOf({ ...heat, kind: 'error', most: 0.029 }, MODEL, 5))).toEqual(['0 %', '1 %', '2 %']);
  expect(told(ticksOf({ ...heat, most: 0 }, MODEL, 5))).toEqual(['1']);
});

test('few numbers are more than the one of no value', () => {
  for (let most = 1e-3; most < 1e3; most *= 1.07) {
    const { length } = ticksOf(distance(most), MODEL, 2);
    expect([2, 3], String(most)).toContain(length);
  }
});

test('bands lie in the middle of each period, lines at its ends, and what is too dense is their mean', () => {
  const zebra = entry(STYLES, 0);
  expect(zebra.pattern).toBe('bands');
  expect(coverage(zebra, 0, 0.5, 0.01)).toBeCloseTo(1, 6);
  expect(coverage(zebra, 0, 3.02, 0.01)).toBeCloseTo(0, 6);
  expect(coverage(zebra, 0, 0.1, 2)).toBeCloseTo(zebra.width, 6);
  const contour = { ...zebra, pattern: 'lines' as const };
  expect(coverage(contour, 2, 7, 0.01)).toBe(1);
  expect(coverage(contour, 2, 7.2, 0.01)).toBeCloseTo(0.45, 6);
  expect(coverage(contour, 2, 7.1, 0.01)).toBe(0);
  expect(coverage(contour, 2, 7.1, 2)).toBeCloseTo(0.4, 6);
  expect(coverage({ ...zebra, pattern: 'none' }, 2, 0.5, 0.01)).toBe(0);
});

/** What drawing a legend writes and draws lines to. */
function drawn(content: Partial<Content>): { corners: number[][]; letters: [string, number, number][] } {
  const corners: number[][] = [];
  const letters: [string, number, number][] = [];
  const done = {
    lineTo: (x: number, y: number) => corners.push([x, y]),
    fillText: (text: string, x: number, y: number) => letters.push([text, x, y]),
  };
  const context = new Proxy(
    {},
    { get: (_, name) => Reflect.get(done, name) ?? (() => ({ width: 0 })), set: () => true },
  );
  const nothing = { isCompact: false, bar: null, spacing: '', scale: null, axes: [], north: null, words: '' };
  const look = { font: '', text: '', plate: '', line: '', axes: {} };
  drawLegend(context as PlaneContext, { ...nothing, ...content }, look, 1);
  return { corners, letters };
}

test('the needle points north as the map lies on the screen, its letter beyond it', () => {
  const { corners, letters } = drawn({ north: { north: [0.6, -0.8, 0], east: [0.8, 0.6, 0] } });
  const [tip] = corners;
  expect(tip[0] / tip[1]).toBeCloseTo(-0.75, 12);
  expect(tip[1]).toBeLessThan(-10);
  const [[letter, x, y]] = letters;
  expect([letter, letters.length]).toEqual(['N', 1]);
  expect(x / y).toBeCloseTo(-0.75, 12);
  expect(y).toBeLessThan(tip[1]);
});

test('letters of axes stand apart, also where the axes lie on one line', () => {
  const half = Math.SQRT1_2;
  const level = [
    ['X', [half, 0, -half]],
    ['Y', [0, -1, 0]],
    ['Z', [half, 0, half]],
  ] as const;
  const straight = [
    ['Z', [0.01, 0, -1]],
    ['X', [1, 0, 0.01]],
    ['Y', [0, -1, 0]],
  ] as const;
  for (const axes of [level, straight]) {
    const { letters } = drawn({ axes: axes.map(([name, [x, y, z]]) => ({ name, direction: [x, y, z] })) });
    expect(letters.map(([name]) => name)).toEqual(axes.map(([name]) => name));
    for (const [i, [, x, y]] of letters.entries()) {
      for (const [, right, down] of letters.slice(0, i)) expect(Math.hypot(x - right, y - down)).toBeGreaterThan(8);
    }
  }
});
