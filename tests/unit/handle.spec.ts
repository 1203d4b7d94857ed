import { expect, test } from '@playwright/test';
import { wayOf } from '../../web/ui/cut';

/** Where a place on the way is seen, by an eye that the way leads towards or away from. */
const seen = (share: number, depth: number) => (200 * share) / (1 + depth * share);

test('a handle follows the pointer along its way, also where that leads into depth', () => {
  for (const depth of [-0.6, -0.2, 0, 0.3, 2]) {
    for (const share of [-0.9, -0.3, 0, 0.4, 1, 1.5]) {
      if (1 + depth * share <= 0.05) continue;
      const way = wayOf(seen(share, depth), seen(1, depth), seen(0.5, depth));
      expect(way, `${share} of ${depth}`).toBeCloseTo(share, 9);
    }
  }
  // Beyond the vanishing point there is the end alone, and what is seen from its end moves evenly.
  expect(wayOf(150, seen(1, 2), seen(0.5, 2))).toBe(Infinity);
  expect(wayOf(4, 8, 0)).toBeCloseTo(0.5, 12);
});
