import { expect, test } from '@playwright/test';
import { ofModel } from '../../web/length';
import { type Compared, decodeCompared, differing, encodeCompared, MIDDLE, STUDIED } from '../../web/state/compared';
import { FIRST_PRESET } from '../../web/state/presets';
import { Scene } from '../../web/state/history';
import { difference } from '../../web/ui/compare/difference';

const OWN = FIRST_PRESET.start;

test('a link holds only what differs from the settings of the scene, and the split', () => {
  for (const [left, right] of Object.values(STUDIED)) {
    const compared: Compared = { ...right, split: 0.25 };
    const text = encodeCompared(compared, left);
    expect(decodeCompared(text, left)).toEqual(compared);
    expect(text.split(',')).toHaveLength(differing(left, right).length + 1);
  }
  const [left, right] = STUDIED['time-step'];
  expect(encodeCompared({ ...right, split: MIDDLE }, left)).toBe('t:1000,at:0.5');
  expect(encodeCompared(null, OWN)).toBe('none');
  expect(decodeCompared('none', OWN)).toBeNull();
});

test('text that is no comparison is refused as a whole', () => {
  for (const text of ['', 'at', 'at:2', 'at:-0.1', 't:1000:3', 't:fast', 'q:1', 'method:magic,at:0.5', 'at:0.5,']) {
    expect(decodeCompared(text, OWN), text).toBeUndefined();
  }
});

test('undo goes back over comparisons; a drag of the line is one step', () => {
  const scene = new Scene(OWN);
  const compared: Compared = { ...STUDIED.solver[1], split: MIDDLE };
  scene.edit({ compared });
  const drag = {};
  for (const split of [0.6, 0.7, 0.8]) scene.edit({ compared: { ...compared, split } }, drag);
  scene.undo();
  expect(scene.state.compared?.split).toBe(MIDDLE);
  scene.undo();
  expect(scene.state.compared).toBeNull();
  scene.redo();
  expect(scene.state.compared).toEqual(compared);
});

const field = (...values: number[]) => ({
  distance: Float32Array.from(values),
  inner: null as Float32Array | null,
  maxDistance: ofModel(Math.max(...values.filter(Number.isFinite))),
});

test('the difference of two fields is over the vertices that both reach, a share of the largest on the left', () => {
  const apart = difference(field(0, 1, 2, 4, Infinity), field(0, 1.5, 1, Infinity, 3));
  expect(apart).toEqual({ mean: 0.125, most: 0.25 });
  // Of tetrahedra all vertices count, not only those that are drawn.
  const inner = (...values: number[]) => ({ ...field(0, 1, 4), inner: Float32Array.from(values) });
  expect(difference(inner(0, 1, 4, 2), inner(0, 1, 4, 3))).toEqual({ mean: 0.0625, most: 0.25 });
  expect(difference(field(0, 0), field(0, 0))).toBeNull();
  expect(difference(field(0, 1), field(0, 1, 2))).toBeNull();
});
