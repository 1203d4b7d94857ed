import { expect, test } from '@playwright/test';
import type { DistanceField } from '../../web/protocol';
import { errorWords, exactnessWords, refiningSentence } from '../../web/ui/words';

const FIELD: DistanceField = {
  distance: new Float32Array(),
  tangents: new Int8Array(),
  maxDistance: 1,
  unreachableVertices: 0,
  exactBelow: 0.5,
  exactShare: 0.439,
  timeFactor: 1,
  error: null,
  solveMs: 1,
  refineMs: 1,
};

test('how much is exact is never rounded up', () => {
  expect(exactnessWords(FIELD)).toBe('exact to 43 %');
  expect(exactnessWords({ ...FIELD, exactShare: 0.9999 })).toBe('exact to 99 %');
  expect(exactnessWords({ ...FIELD, exactShare: 0.009 })).toBe('');
  expect(exactnessWords({ ...FIELD, exactBelow: Infinity, exactShare: 1 })).toBe('exact');
});

test('errors are told with one digit after the point while they are small', () => {
  expect(errorWords({ mean: 0.0061, max: 0.0312 })).toBe('0.6 % on average, 3.1 % at most');
  expect(errorWords({ mean: 0.02, max: 0.184 })).toBe('2.0 % on average, 18 % at most');
});

test('every end of refining is told in a sentence', () => {
  const exact = { ...FIELD, exactBelow: Infinity, exactShare: 1 };
  expect(refiningSentence('exact', exact, 'descent')).toBe('Exact.');
  expect(refiningSentence('exact', { ...exact, error: { mean: 0.0061, max: 0.0312 } }, 'descent')).toBe(
    'Exact. Heat was off by 0.6 % on average, 3.1 % at most.',
  );
  expect(refiningSentence('refining', FIELD, 'descent')).toBe('Exact to 43 %.');
  expect(refiningSentence('late', FIELD, 'descent')).toBe('Exact to 43 %. Refining was ended after 60 seconds.');
  expect(refiningSentence('off', { ...FIELD, exactShare: 0 }, 'descent')).toBe(
    'Not exact yet. Refining is switched off.',
  );
  expect(refiningSentence('large', FIELD, 'exact')).toContain('more than 200,000 triangles');
  expect(refiningSentence('large', FIELD, 'exact')).toContain('straightened');
  expect(refiningSentence('large', FIELD, 'descent')).not.toContain('straightened');
});
