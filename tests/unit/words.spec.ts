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

test('the share of exact vertices is rounded down', () => {
  expect(exactnessWords(FIELD)).toBe('43 % of vertices exact');
  expect(exactnessWords({ ...FIELD, exactShare: 0.9999 })).toBe('99 % of vertices exact');
  expect(exactnessWords({ ...FIELD, exactShare: 0.009 })).toBe('');
  expect(exactnessWords({ ...FIELD, exactBelow: Infinity, exactShare: 1 })).toBe('exact');
});

test('errors below 10 % have one decimal', () => {
  expect(errorWords({ mean: 0.0061, max: 0.0312 })).toBe('mean 0.6 %, maximum 3.1 %');
  expect(errorWords({ mean: 0.02, max: 0.184 })).toBe('mean 2.0 %, maximum 18 %');
});

test('every end of refinement has a sentence', () => {
  const exact = { ...FIELD, exactBelow: Infinity, exactShare: 1 };
  expect(refiningSentence('exact', exact, 'descent')).toBe('Exact.');
  expect(refiningSentence('exact', { ...exact, error: { mean: 0.0061, max: 0.0312 } }, 'descent')).toBe(
    'Exact. Error of the heat method: mean 0.6 %, maximum 3.1 %.',
  );
  expect(refiningSentence('refining', FIELD, 'descent')).toBe('43 % of vertices exact.');
  expect(refiningSentence('late', FIELD, 'descent')).toBe(
    '43 % of vertices exact. Refinement stopped after 60 seconds.',
  );
  expect(refiningSentence('off', { ...FIELD, exactShare: 0 }, 'descent')).toBe('Approximate. Refinement is off.');
  expect(refiningSentence('large', FIELD, 'exact')).toContain('more than 200,000 triangles');
  expect(refiningSentence('large', FIELD, 'exact')).toContain('straightened');
  expect(refiningSentence('large', FIELD, 'descent')).not.toContain('straightened');
});
