import { expect, test } from '@playwright/test';
import { MODEL, ofModel } from '../../web/length';
import type { DistanceField } from '../../web/protocol';
import type { Phase } from '../../web/solver/refiner';
import { measure } from '../../web/state/measures';
import { errorWords, fieldSentence, refiningSentence } from '../../web/ui/accuracy';
import { exactnessWords, hikingWords } from '../../web/ui/words';

const FIELD: DistanceField = {
  distance: new Float32Array(),
  tangents: new Int8Array(),
  maxDistance: ofModel(1),
  byCorner: false,
  unreachableVertices: 0,
  exactBelow: ofModel(0.5),
  exactShare: 0.439,
  timeFactor: 1,
  windows: undefined,
  error: null,
  solveMs: 1,
  refineMs: 1,
  inner: null,
};

const PROPAGATED: DistanceField = { ...FIELD, timeFactor: undefined, windows: 2 };
const EXACT = { exactBelow: ofModel(Infinity), exactShare: 1 };
const ERROR = { mean: 0.0061, max: 0.0312 };

test('the share of exact vertices is rounded down', () => {
  expect(String(exactnessWords(FIELD))).toBe('heat method, 43 % exact');
  expect(String(exactnessWords({ ...PROPAGATED, exactShare: 0.9999 }))).toBe('propagation, 99 % exact');
  expect(String(exactnessWords({ ...FIELD, ...EXACT }))).toBe('exact');
  expect(String(exactnessWords({ ...FIELD, exactShare: 0.009 }))).toBe('heat method');
});

test('a length has its unit, and says where that is assumed', () => {
  expect(String(measure(ofModel(0.12345), { symbol: 'mm', assumed: false, scale: 1 }))).toBe('0.123 mm');
  expect(String(measure(ofModel(2), { symbol: 'm', assumed: true, scale: 1 }))).toBe('2 m (assumed)');
  expect(String(measure(ofModel(2), { symbol: '', assumed: false, scale: 1 }))).toBe('2 units');
});

test('errors have as many decimals as they need', () => {
  expect(String(errorWords(ERROR))).toBe('mean 0.6 %, maximum 3.1 %');
  expect(String(errorWords({ mean: 0.02, max: 0.184 }))).toBe('mean 2.0 %, maximum 18 %');
  expect(String(errorWords({ mean: 0.00042, max: 0.00099 }))).toBe('mean 0.04 %, maximum 0.1 %');
  expect(String(errorWords({ mean: 0.000012, max: 0.00096 }))).toBe('mean 0.001 %, maximum 0.1 %');
  expect(String(errorWords({ mean: 1e-9, max: 0 }))).toBe('mean below 0.001 %, maximum 0.0 %');
});

test('a field says which method it was found by, and how far it is exact', () => {
  expect(String(fieldSentence(FIELD, MODEL))).toBe('By the heat method: exact below 0.5 units (43 % of vertices).');
  expect(String(fieldSentence({ ...FIELD, exactShare: 0 }, MODEL))).toBe('By the heat method.');
  expect(String(fieldSentence(PROPAGATED, MODEL))).toBe(
    'By propagation with 2 windows: exact below 0.5 units (43 % of vertices), an upper bound beyond.',
  );
  expect(String(fieldSentence({ ...PROPAGATED, windows: 1, exactShare: 0 }, MODEL))).toBe(
    'By propagation with 1 window.',
  );
  expect(String(fieldSentence({ ...FIELD, ...EXACT }, MODEL))).toBe('Exact.');
  expect(String(fieldSentence({ ...FIELD, ...EXACT, error: ERROR }, MODEL))).toBe(
    'Exact. Error of the heat method: mean 0.6 %, maximum 3.1 %.',
  );
  expect(String(fieldSentence({ ...PROPAGATED, ...EXACT, error: ERROR }, MODEL))).toBe(
    'Exact. Error of propagation with 2 windows: mean 0.6 %, maximum 3.1 %.',
  );
});

test('every end of refinement has a sentence', () => {
  const wish = { method: 'auto', pathKind: 'descent' } as const;
  const sentence = (phase: Phase) => refiningSentence(phase, { ...PROPAGATED, exactShare: 0 }, wish, MODEL);
  const soFar = 'By propagation with 2 windows.';
  expect(String(sentence('refining'))).toBe(soFar);
  expect(String(sentence('late'))).toBe(`${soFar} Refinement stopped after 60 seconds.`);
  expect(String(sentence('stuck'))).toBe(`${soFar} Refinement stopped because it made no progress.`);
  expect(String(sentence('memory'))).toBe(`${soFar} Refinement stopped because memory ran out.`);
  expect(String(sentence('off'))).toBe(`${soFar} Refinement is off.`);
  // It is never on.
  expect(
    String(refiningSentence('off', { ...PROPAGATED, exactShare: 0 }, { ...wish, method: 'propagation' }, MODEL)),
  ).toBe(soFar);
  expect(String(refiningSentence('memory', PROPAGATED, { ...wish, pathKind: 'exact' }, MODEL))).toContain(
    'straightened',
  );
});

test('what slopes cost is told as hours and minutes of a hiker', () => {
  const meters = { symbol: 'm', assumed: false, scale: 1 };
  // 5.0367 km/h on the flat.
  expect(String(hikingWords(ofModel(5036.7), meters))).toBe('1 h 0 min');
  expect(String(hikingWords(ofModel(420), meters))).toBe('5 min');
  expect(String(hikingWords(ofModel(10), { symbol: 'km', assumed: false, scale: 2 }))).toBe('3 h 58 min');
  expect(hikingWords(ofModel(420), MODEL)).toBeNull();
});
