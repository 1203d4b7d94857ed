import { expect, test } from '@playwright/test';
import { Resolution } from '../../web/view/resolution';

/** A device that draws all pixels in `all` milliseconds, of which `fixed` do not depend on how many they are. */
function run(resolution: Resolution, frames: number, all: number, fixed = 0): number[] {
  let now = performance.now();
  return Array.from({ length: frames }, () => {
    const took = fixed + (all - fixed) * resolution.share ** 2;
    now += took;
    resolution.follow(now, true, took);
    return resolution.share;
  });
}

test('a device that is fast draws all pixels', () => {
  expect(new Set(run(new Resolution(), 200, 12))).toEqual(new Set([1]));
});

test('a slow device draws fewer pixels until frames are fluent, and no fewer than that', () => {
  const resolution = new Resolution();
  const shares = run(resolution, 100, 100);
  expect(shares.at(-1)).toBe(0.5);
  // 100 ms × 0.75² are still slow, 100 ms × 0.5² are not; to and fro is never seen.
  expect([...new Set(shares)]).toEqual([1, 0.75, 0.5]);
});

test('where fewer pixels gain nothing, none are given up', () => {
  const shares = run(new Resolution(), 100, 100, 97);
  expect(shares.at(-1)).toBe(1);
});

test('fewer pixels are tried again where something else made frames slow for a while, ever more rarely', () => {
  const resolution = new Resolution();
  expect(run(resolution, 20, 100, 97).at(-1)).toBe(1);
  expect(run(resolution, 100, 100).at(-1)).toBe(0.5);
  const steady = run(new Resolution(), 1000, 100, 97);
  const tries = steady.flatMap((share, frame) => (share < 1 && steady[frame - 1] === 1 ? [frame] : []));
  expect(tries.length).toBeLessThan(6);
  expect(tries.slice(1).every((frame, index) => frame - tries[index] > 50 * 2 ** (index - 1))).toBe(true);
});

test('the picture at rest has all pixels, and what moves next begins with as many as were fluent', () => {
  const resolution = new Resolution();
  expect(run(resolution, 100, 100).at(-1)).toBe(0.5);
  let now = performance.now() + 1e6;
  resolution.follow(now, false, 16);
  expect(resolution.share).toBe(1);
  // The frame that draws it is no motion.
  resolution.follow((now += 100), true, 100);
  expect(resolution.share).toBe(1);
  resolution.follow((now += 16), false, 16);
  resolution.follow((now += 100), true, 100);
  expect(resolution.share).toBe(1);
  resolution.follow((now += 100), true, 100);
  expect(resolution.share).toBe(0.5);
});

test('pixels come back where frames have become fast', () => {
  const resolution = new Resolution();
  expect(run(resolution, 100, 100).at(-1)).toBe(0.5);
  expect(run(resolution, 200, 12).at(-1)).toBe(1);
});

test('a single slow frame changes nothing', () => {
  const resolution = new Resolution();
  run(resolution, 10, 12);
  resolution.follow(performance.now(), true, 900);
  expect(new Set(run(resolution, 20, 12))).toEqual(new Set([1]));
});
