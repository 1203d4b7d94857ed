import { expect, test } from '@playwright/test';
import { parseColour } from '../../web/state/styles';
import { rimmed } from '../../web/view/layers';
import { ofModel, unitOf } from '../../web/length';
import type { Leg, MeshPoint } from '../../web/protocol';
import { lengthOf, type MeasuredTape, stateOf } from '../../web/session/tapes';
import { decodeLink, encodeLink } from '../../web/state/link';
import { Scene } from '../../web/state/history';
import { emptyScene, type SceneState } from '../../web/state/scene';
import { canClose, close, extended, legsOf, moved, type Tape, withoutPlace } from '../../web/state/tapes';
import { areaLabel, csvOf, enclosureWords, lengthWords } from '../../web/ui/measure/words';
import { measure, volume } from '../../web/state/measures';

const START = emptyScene({ kind: 'preset', id: 'bunny' });
const at = (vertex: number): MeshPoint => ({ vertex });
const tape = (...vertices: number[]): Tape => ({ points: vertices.map(at), closed: false });
const METRES = { symbol: 'm', assumed: false, scale: 1 };

const leg = (length: number, straight: number): Leg => ({
  triangles: new Uint32Array(2),
  weights: new Float64Array(6),
  length: ofModel(length),
  straight: ofModel(straight),
  cost: ofModel(length),
});
const measured = (over: Partial<MeasuredTape> = {}): MeasuredTape => ({
  tape: tape(1, 2, 3),
  legs: [
    { state: 'exact', leg: leg(2, 1), straight: ofModel(1) },
    { state: 'estimated', leg: leg(4, 3), straight: ofModel(3) },
  ],
  enclosure: null,
  ...over,
});

function throughLink(state: SceneState): SceneState {
  const { state: read, notices, refused } = decodeLink(encodeLink(state, START), () => START);
  expect([...notices, ...refused]).toEqual([]);
  if (!read) throw new Error('the link names no mesh');
  return read;
}

test('a place begins a tape or lengthens it; places are moved and taken away; three close it', () => {
  let tapes = extended([], -1, at(1));
  tapes = extended(tapes, 0, at(2));
  tapes = extended(tapes, -1, at(9));
  expect(tapes).toEqual([tape(1, 2), tape(9)]);
  expect(canClose(tapes[0])).toBe(false);
  tapes = extended(tapes, 0, at(3));
  expect(canClose(tapes[0])).toBe(true);
  tapes = close(tapes, 0);
  expect(canClose(tapes[0])).toBe(false);
  expect(legsOf(tapes[0])).toEqual([
    [at(1), at(2)],
    [at(2), at(3)],
    [at(3), at(1)],
  ]);
  tapes = moved(tapes, 0, 1, at(7));
  expect(tapes[0].points).toEqual([at(1), at(7), at(3)]);
  // Two places close nothing.
  expect(withoutPlace(tapes, 0, 1)[0]).toEqual(tape(1, 3));
  expect(withoutPlace(tapes, 1, 0)).toHaveLength(1);
});

test('tapes and the scale are in the link', () => {
  const inFace: MeshPoint = { face: 12, weights: [0.25, 0.25, 0.5] };
  const tapes: Tape[] = [tape(1, 2), { points: [at(4), inFace, at(5)], closed: true }];
  const link = encodeLink({ ...START, tapes, scale: 0.0254, unit: 'm' }, START);
  expect(link).toContain('tape=1,2;4,12:0.25/0.25/0.5,5!');
  expect(link).toContain('scale=0.0254');
  const read = throughLink({ ...START, tapes, scale: 0.0254, unit: 'm' });
  expect(read).toMatchObject({ tapes, scale: 0.0254, unit: 'm' });
  expect(encodeLink(START, START)).toBe('v=1&m=bunny');
});

test('a tape in the link that is none is told, and the scene has none', () => {
  for (const text of ['1,x', '1,2!', ';', '1,2;', '1:0.5/0.1/0.1,2']) {
    const { state, refused } = decodeLink(`v=1&m=bunny&tape=${text}`, () => START);
    expect(state?.tapes, text).toEqual([]);
    expect(refused, text).toEqual([`tape=${text}`]);
  }
  expect(decodeLink('v=1&m=bunny&scale=0', () => START).refused).toEqual(['scale=0']);
});

test('undo takes tapes and the scale back', () => {
  const scene = new Scene(START);
  scene.edit({ tapes: [tape(1, 2)] });
  scene.edit({ scale: 3, unit: 'm' });
  scene.undo();
  expect(scene.state).toMatchObject({ scale: 1, unit: 'auto' });
  scene.undo();
  expect(scene.state.tapes).toEqual([]);
  scene.redo();
  expect(scene.state.tapes).toEqual([tape(1, 2)]);
});

test('a known length scales lengths, areas and volumes', () => {
  const unit = unitOf({ unit: 'm', scale: 2, shownUnit: null }, { unit: '', unitAssumed: false });
  expect(String(measure(ofModel(3), unit))).toBe('6 m');
  expect(String(volume(ofModel(3), unit))).toBe('24 m³');
  const ring = measured({ tape: { ...tape(1, 2, 3), closed: true }, enclosure: { kind: 'sides', area: ofModel(3) } });
  expect(String(enclosureWords(ring, unit))).toBe('Area enclosed: 12 m².');
  expect(String(areaLabel(ring, unit))).toBe('area 12 m²');
  expect(String(areaLabel(ring, { ...unit, symbol: '' }))).toBe('area 12');
});

test('a sum is as certain as its least certain leg', () => {
  const chain = measured();
  expect([lengthOf(chain), stateOf(chain)]).toEqual([6, 'estimated']);
  const torn = measured({ legs: [...chain.legs, { state: 'none', leg: null, straight: ofModel(1) }] });
  expect([lengthOf(torn), stateOf(torn)]).toEqual([NaN, 'none']);
  expect(String(lengthWords(ofModel(6), 'estimated', METRES))).toBe('≈ 6 m');
  expect(String(lengthWords(ofModel(6), 'exact', METRES))).toBe('6 m');
  expect(String(lengthWords(ofModel(NaN), 'none', METRES))).toBe('not connected');
});

test('a tape that encloses no area says why', () => {
  const ring = { tape: { ...tape(1, 2, 3), closed: true } };
  const words = (kind: 'whole' | 'crossed' | 'sideless') =>
    enclosureWords(measured({ ...ring, enclosure: { kind, area: ofModel(0) } }), METRES);
  expect(String(words('whole'))).toContain('does not part');
  expect(String(words('crossed'))).toContain('crosses itself');
  expect(String(words('sideless'))).toContain('no two sides');
  const lines = new Float32Array();
  const path = {
    points: lines,
    places: new Float64Array(6),
    normals: lines,
    segmentCosts: lines,
    drawnLength: 2,
    length: ofModel(2),
    cost: ofModel(2),
  };
  const within: Leg = { ...path, straight: ofModel(2) };
  const inside = measured({ ...ring, legs: [{ state: 'exact', leg: within, straight: ofModel(2) }] });
  expect(String(enclosureWords(inside, METRES))).toContain('through the inside');
  expect(enclosureWords({ ...inside, tape: tape(1, 2, 3) }, METRES)).toBeNull();
  expect(enclosureWords(measured(), METRES)).toBeNull();
});

test('CSV has a line a leg and one with the sums', () => {
  const inFace: MeshPoint = { face: 12, weights: [0.25, 0.25, 0.5] };
  const lines = csvOf([measured({ tape: { points: [at(1), inFace, at(3)], closed: false } })], {
    ...METRES,
    scale: 10,
  });
  expect(lines.split('\r\n')).toEqual([
    'tape,leg,from,to,surface,straight,ratio,cost,area,accuracy,unit',
    '1,1,vertex 1,triangle 12: 0.25 0.25 0.5,20,10,0.5,20,,exact,m',
    '1,2,triangle 12: 0.25 0.25 0.5,vertex 3,40,30,0.75,40,,approximate so far,m',
    '1,total,,,60,40,0.666666667,,,approximate so far,m',
    '',
  ]);
});

function linear(byte: number): number {
  return byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;
}

/** Relative luminance of a color of three bytes, by WCAG 2.2. */
function luminance([red, green, blue]: readonly number[]): number {
  return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}

test('some of a curve with its rims stands out by 4 : 1 from a surface of any brightness', () => {
  const line = { ends: new Float32Array(6), colour: '#ffc233', width: 2.5 };
  const drawn = rimmed(line);
  // The widest first: what comes after lies on it.
  expect(drawn.map(({ width }) => width)).toEqual(drawn.map(({ width }) => width).toSorted((a = 0, b = 0) => b - a));
  const tones = drawn.map(({ colour }) => luminance(parseColour(colour)));
  for (let gray = 0; gray < 256; gray++) {
    const ground = luminance([gray, gray, gray]);
    const contrasts = tones.map((tone) => (Math.max(tone, ground) + 0.05) / (Math.min(tone, ground) + 0.05));
    expect(Math.max(...contrasts), String(gray)).toBeGreaterThan(4);
  }
});
