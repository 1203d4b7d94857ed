import { expect, test } from '@playwright/test';
import type { DistanceField } from '../../web/protocol';
import type { Phase } from '../../web/solver/refiner';
import { errorWords, exactnessWords, fieldSentence, measure, refiningSentence } from '../../web/ui/words';

const FIELD: DistanceField = {
  distance: new Float32Array(),
  tangents: new Int8Array(),
  maxDistance: 1,
  byCorner: false,
  unreachableVertices: 0,
  exactBelow: 0.5,
  exactShare: 0.439,
  timeFactor: 1,
  windows: undefined,
  error: null,
  solveMs: 1,
  refineMs: 1,
  inner: null,
};

const PROPAGATED: DistanceField = { ...FIELD, timeFactor: undefined, windows: 2 };
const EXACT = { exactBelow: Infinity, exactShare: 1 };
const ERROR = { mean: 0.0061, max: 0.0312 };

test('the share of exact vertices is rounded down', () => {
  expect(exactnessWords(FIELD)).toBe('heat method, 43 % exact');
  expect(exactnessWords({ ...PROPAGATED, exactShare: 0.9999 })).toBe('propagation, 99 % exact');
  expect(exactnessWords({ ...FIELD, ...EXACT })).toBe('exact');
  expect(exactnessWords({ ...FIELD, exactShare: 0.009 })).toBe('heat method');
});

test('a length has its unit, and says where that is assumed', () => {
  expect(measure(0.12345, { symbol: 'mm', assumed: false, scale: 1 })).toBe('0.123 mm');
  expect(measure(2, { symbol: 'm', assumed: true, scale: 1 })).toBe('2 m (assumed)');
  expect(measure(2, { symbol: '', assumed: false, scale: 1 })).toBe('2 units');
});

test('errors have as many decimals as they need', () => {
  expect(errorWords(ERROR)).toBe('mean 0.6 %, maximum 3.1 %');
  expect(errorWords({ mean: 0.02, max: 0.184 })).toBe('mean 2.0 %, maximum 18 %');
  expect(errorWords({ mean: 0.00042, max: 0.00099 })).toBe('mean 0.04 %, maximum 0.1 %');
  expect(errorWords({ mean: 0.000012, max: 0.00096 })).toBe('mean 0.001 %, maximum 0.1 %');
  expect(errorWords({ mean: 1e-9, max: 0 })).toBe('mean below 0.001 %, maximum 0.0 %');
});

test('a field says which method it was found by, and how far it is exact', () => {
  expect(fieldSentence(FIELD)).toBe('By the heat method: exact below 0.5 units (43 % of vertices).');
  expect(fieldSentence({ ...FIELD, exactShare: 0 })).toBe('By the heat method.');
  expect(fieldSentence(PROPAGATED)).toBe(
    'By propagation with 2 windows: exact below 0.5 units (43 % of vertices), an upper bound beyond.',
  );
  expect(fieldSentence({ ...PROPAGATED, windows: 1, exactShare: 0 })).toBe('By propagation with 1 window.');
  expect(fieldSentence({ ...FIELD, ...EXACT })).toBe('Exact.');
  expect(fieldSentence({ ...FIELD, ...EXACT, error: ERROR })).toBe(
    'Exact. Error of the heat method: mean 0.6 %, maximum 3.1 %.',
  );
  expect(fieldSentence({ ...PROPAGATED, ...EXACT, error: ERROR })).toBe(
    'Exact. Error of propagation with 2 windows: mean 0.6 %, maximum 3.1 %.',
  );
});

test('every end of refinement has a sentence', () => {
  const wish = { method: 'auto', pathKind: 'descent' } as const;
  const sentence = (phase: Phase) => refiningSentence(phase, { ...PROPAGATED, exactShare: 0 }, wish);
  const soFar = 'By propagation with 2 windows.';
  expect(sentence('refining')).toBe(soFar);
  expect(sentence('late')).toBe(`${soFar} Refinement stopped after 60 seconds.`);
  expect(sentence('stuck')).toBe(`${soFar} Refinement stopped because it made no progress.`);
  expect(sentence('memory')).toBe(`${soFar} Refinement stopped because memory ran out.`);
  expect(sentence('off')).toBe(`${soFar} Refinement is off.`);
  // It is never on.
  expect(refiningSentence('off', { ...PROPAGATED, exactShare: 0 }, { ...wish, method: 'propagation' })).toBe(soFar);
  expect(refiningSentence('memory', PROPAGATED, { ...wish, pathKind: 'exact' })).toContain('straightened');
});
