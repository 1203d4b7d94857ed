import { expect, test } from '@playwright/test';
import { judge } from '../../tools/bench/ratios.mjs';

/** Ratios around a middle, evenly within ± `spread`. */
function around(middle: number, spread: number, count: number): number[] {
  return Array.from({ length: count }, (_, index) => middle + spread * ((2 * index) / (count - 1) - 1));
}

test('what is clearly slower, and what is clearly not, is certain', () => {
  expect(judge(around(1.1, 0.05, 40))).toMatchObject({ isCertain: true, verdict: 'slower' });
  expect(judge(around(1, 0.05, 40))).toMatchObject({ isCertain: true, verdict: 'same' });
  expect(judge(around(1, 0.001, 6))).toMatchObject({ isCertain: true, verdict: 'same' });
});

test('noise around the limit is not certain', () => {
  expect(judge(around(1.035, 0.2, 8))).toMatchObject({ isCertain: false, verdict: 'maybe slower' });
  expect(judge(around(1.02, 0.2, 8))).toMatchObject({ isCertain: false, verdict: 'maybe same' });
});

test('five pairs are too few for an interval', () => {
  expect(judge([2, 2, 2, 2, 2])).toMatchObject({ interval: [0, Infinity], isCertain: false });
  expect(judge([2, 2, 2, 2, 2, 2]).isCertain).toBe(true);
});

test('the interval leaves out as many ranks as 95 % allow', () => {
  // Of 20, the 6th to the 15th: 95.9 % (tables of the sign test).
  const ranks = Array.from({ length: 20 }, (_, index) => index + 1);
  expect(judge(ranks).interval).toEqual([6, 15]);
});
