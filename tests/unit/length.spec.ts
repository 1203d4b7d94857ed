import { expect, test } from '@playwright/test';
import {
  inModel,
  inUnit,
  type LengthUnit,
  MODEL,
  ofModel,
  SHOWN_UNITS,
  told,
  toldArea,
  toldVolume,
  typed,
  unitOf,
  unitOfFile,
  type Units,
} from '../../web/length';
import { pathFile, tracksFile } from '../../web/session/export';
import { decodeLink, encodeLink } from '../../web/state/link';
import { Scene } from '../../web/state/history';
import { isolinesText, parseIsolines } from '../../web/state/isolines';
import { rowsOf } from '../../web/state/list';
import { area, measure, volume } from '../../web/state/measures';
import { emptyScene } from '../../web/state/scene';

const SILENT = { unit: '', unitAssumed: false };
const units = (over: Partial<Units>): Units => ({ unit: 'auto', scale: 1, shownUnit: null, ...over });
const START = emptyScene({ kind: 'preset', id: 'bunny' });

/** A box of 100 mm is so long in the file, whose unit is said to be this, and shown in that. */
const BOXES: readonly (readonly [long: number, units: Units, inUnitShown: number, symbol: string])[] = [
  [100, units({ unit: 'mm' }), 100, 'mm'],
  [0.1, units({ unit: 'm' }), 0.1, 'm'],
  [100 / 25.4, units({ unit: 'in' }), 100 / 25.4, 'in'],
  [100, units({ unit: 'mm', shownUnit: 'in' }), 100 / 25.4, 'in'],
  [0.1, units({ unit: 'm', shownUnit: 'mm' }), 100, 'mm'],
  [2, units({ unit: 'cm', scale: 5 }), 10, 'cm'],
  [2, units({ unit: 'cm', scale: 5, shownUnit: 'm' }), 0.1, 'm'],
  // Nothing can be converted.
  [100, units({ unit: 'none', shownUnit: 'in' }), 100, ''],
];

const digits = (value: number) => String(Number(value.toPrecision(3)));

for (const [long, of, shown, symbol] of BOXES) {
  test(`a length of ${long} with ${JSON.stringify(of)} is ${shown.toPrecision(3)} ${symbol}, in words, fields and files`, () => {
    const unit = unitOf(of, SILENT);
    expect(unit.symbol).toBe(symbol);
    expect(told(ofModel(long), unit)).toBeCloseTo(shown, 12);
    expect(toldArea(ofModel(long ** 2), unit)).toBeCloseTo(shown ** 2, 9);
    expect(toldVolume(ofModel(long ** 3), unit)).toBeCloseTo(shown ** 3, 6);
    expect(String(measure(ofModel(long), unit))).toBe(`${digits(shown)} ${symbol || 'units'}`);
    expect(String(area(ofModel(long ** 2), unit))).toContain(digits(shown ** 2));
    expect(String(volume(ofModel(long ** 3), unit))).toContain(digits(shown ** 3));

    // What is typed is read as it is shown, and stays so.
    expect(inModel(shown, unit)).toBeCloseTo(long, 12);
    const wish = parseIsolines('0.1, 0.3', unit);
    expect(wish?.values.map((value) => told(value, unit))).toEqual([expect.closeTo(0.1, 12), expect.closeTo(0.3, 12)]);
    expect(isolinesText(wish, unit)).toBe('0.1,0.3');
    expect(typed(inModel(0.3, unit), unit)).toBe(0.3);
    const [row] = rowsOf('a.csv', `x,y,z,offset\n${shown},0,0,${shown}`, unit);
    expect(row.offset).toBeCloseTo(long, 9);
    if (!('coordinates' in row.place)) throw new Error('a row of coordinates');
    expect(row.place.coordinates[0]).toBeCloseTo(long, 9);

    // Files say the unit, and glTF is in meters where there is one.
    const ends: [number, number, number][] = [
      [0, 0, 0],
      [long, 0, 0],
    ];
    const head = symbol ? ` (${symbol})` : '';
    const [names, , last = ''] = String(pathFile('csv', ends, unit)).split('\n');
    expect(names).toBe(`length${head},x${head},y${head},z${head}`);
    expect(Number(last.split(',')[0])).toBeCloseTo(shown, 9);
    expect(String(tracksFile('csv', [ends], unit)).split('\n')[0]).toBe(`walker,${names}`);
    const lines = String(pathFile('obj', ends, unit)).split('\n');
    expect(lines.includes(`# lengths in ${symbol}`)).toBe(symbol !== '');
    expect(Number(lines.findLast((line) => line.startsWith('v '))?.split(' ')[1])).toBeCloseTo(shown, 9);
    const glb = pathFile('glb', ends, unit) as Uint8Array<ArrayBuffer>;
    expect(new Float32Array(glb.slice(-12).buffer)[0]).toBeCloseTo(symbol ? 0.1 : 100, 6);
  });
}

test('each unit converts to each other one and back, and what is assumed stays so', () => {
  for (const from of SHOWN_UNITS) {
    for (const to of SHOWN_UNITS) {
      const unit: LengthUnit = { symbol: from, assumed: true, scale: 3 };
      const there = inUnit(unit, to);
      expect(there).toMatchObject({ symbol: to, assumed: true });
      expect(inUnit(there, from).scale).toBeCloseTo(3, 12);
    }
  }
  expect(inUnit({ ...MODEL, symbol: 'm' }, 'mm').scale).toBe(1000);
  expect(inUnit({ ...MODEL, symbol: 'in' }, 'mm').scale).toBe(25.4);
  expect(inUnit({ ...MODEL, symbol: 'µm' }, 'mm').scale).toBe(0.001);
  expect(unitOfFile('glb', MODEL)).toEqual(MODEL);
  const inches: LengthUnit = { symbol: 'in', assumed: false, scale: 1 };
  const kinds = ['svg', 'unrolled.dxf', 'unrolled.pdf', 'stripes.glb', 'strips.obj', 'csv'];
  expect(kinds.map((kind) => unitOfFile(kind, inches).symbol)).toEqual(['mm', 'mm', 'mm', 'm', 'in', 'in']);
  expect(unitOf(units({ shownUnit: 'in' }), { unit: 'mm', unitAssumed: true })).toMatchObject({ assumed: true });
});

test('a heading says the unit of a list, whatever is shown', () => {
  const unit = unitOf(units({ unit: 'm', shownUnit: 'in' }), SILENT);
  const [row] = rowsOf('a.csv', 'vertex,offset (mm)\n3,500', unit);
  expect(row.place).toEqual({ vertex: 3 });
  expect(row.offset).toBeCloseTo(0.5, 12);
  const [place] = rowsOf('a.csv', 'x (cm), y (cm), z (cm)\n100,200,300', unit);
  if (!('coordinates' in place.place)) throw new Error('a row of coordinates');
  place.place.coordinates.forEach((along, axis) => expect(along).toBeCloseTo(axis + 1, 12));
});

test('a correction and a conversion are steps of undo each, and links of before keep their meaning', () => {
  const scene = new Scene(START);
  scene.edit({ unit: 'cm', scale: 1 });
  scene.edit({ shownUnit: 'in' });
  const link = encodeLink(scene.state, START);
  expect(link).toContain('&unit=cm&shown=in');
  expect(decodeLink(link, () => START).state).toMatchObject({ unit: 'cm', scale: 1, shownUnit: 'in' });
  scene.undo();
  expect(scene.state).toMatchObject({ unit: 'cm', shownUnit: null });
  scene.undo();
  expect(scene.state).toMatchObject({ unit: 'auto', shownUnit: null });

  const { state } = decodeLink('v=1&m=bunny&unit=m&scale=0.0254', () => START);
  if (!state) throw new Error('the link names no mesh');
  expect(unitOf(state, SILENT)).toEqual({ symbol: 'm', assumed: false, scale: 0.0254 });
});
