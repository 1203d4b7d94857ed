import { expect, test } from '@playwright/test';
import { wholeOfDistance } from '../../web/session/period';
import type { Shown } from '../../web/session/prepare';
import { codeOf, LEVEL, WALL } from '../../web/state/ground';
import { grid } from '../fixtures';

const N = 20;
const DIAMETER = Math.SQRT2;
const DRAWN = 3;

/** A square from its corner on, where the share `steep` costs 50 times as much as the rest, which costs `cost`. */
function shown(cost: number, steep = 0, byCorner = false): Shown {
  const { positions, triangles } = grid(N);
  const value = ([x]: readonly number[]) => cost * (Math.min(x, 1 - steep) + 50 * Math.max(0, x - (1 - steep)));
  const drawn = byCorner ? triangles.flat().map((vertex) => positions[vertex]) : positions;
  return {
    opened: {
      surface: {
        positions: Float32Array.from(positions.flat().map((x) => DRAWN * x)),
        triangles: Uint32Array.from(triangles.flat()),
      },
      drawTransform: { scale: DRAWN },
    },
    places: { diameter: DIAMETER },
    answer: {
      question: { ground: { ...LEVEL, faces: Uint8Array.of(cost === 1 ? WALL : codeOf(cost), codeOf(cost)) } },
      field: { distance: Float32Array.from(drawn.map(value)), byCorner },
    },
  } as unknown as Shown;
}

test('stripes are as far apart on most of the surface as without costs', () => {
  expect(wholeOfDistance(shown(1))).toBe(DIAMETER);
  expect(wholeOfDistance(shown(4))).toBeCloseTo(4 * DIAMETER, 12);
  expect(wholeOfDistance(shown(1 / 8))).toBeCloseTo(DIAMETER / 8, 12);
  expect(wholeOfDistance(shown(4, 0, true))).toBeCloseTo(4 * DIAMETER, 12);
  // Few places that cost far more leave the others as they are.
  expect(wholeOfDistance(shown(2, 0.2))).toBeCloseTo(2 * DIAMETER, 12);
});

test('without an answer, or where nothing is reached, the diameter is taken', () => {
  const none = shown(4);
  none.answer.field = null;
  expect(wholeOfDistance(none)).toBe(DIAMETER);
  const far = shown(4);
  far.answer.field?.distance.fill(Infinity);
  expect(wholeOfDistance(far)).toBe(DIAMETER);
});
