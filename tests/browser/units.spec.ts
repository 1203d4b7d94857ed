import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { type Mesh, off } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';

/** Of the box, in millimeters. */
const SIDES = [100, 60, 40] as const;
const DIAGONAL = Math.hypot(...SIDES);
/** The path from corner to corner goes over two sides; unrolled, these are as wide as both together. */
const PATH = Math.hypot(100, 60 + 40);
const OFFSET = 7;
const ISOLINES = [37, 47] as const;
/** Words have three digits. */
const TOLERANCE = 0.005;

const MILLIMETERS: Readonly<Record<string, number>> = { mm: 1, cm: 10, in: 25.4, ft: 304.8, m: 1000, km: 1e6 };
/** Of `$INSUNITS`. */
const DXF_UNITS: Readonly<Record<string, number>> = { 1: 25.4, 4: 1, 5: 10, 6: 1000 };

/** What says how long the unit of the file is, which has so many millimeters; all lengths are shown in `symbol`. */
const CASES = [
  { name: 'in mm', perUnit: 1, options: 'unit=mm', symbol: 'mm' },
  { name: 'in m', perUnit: 1000, options: 'unit=m', symbol: 'm' },
  { name: 'in inches', perUnit: 25.4, options: 'unit=in', symbol: 'in' },
  { name: 'in m, converted to inches', perUnit: 1000, options: 'unit=m&shown=in', symbol: 'in' },
  { name: 'without a unit', perUnit: 1, options: 'unit=none', symbol: '' },
  { name: 'with a scale', perUnit: 17.62, options: 'unit=cm&scale=1.762&shown=mm', symbol: 'mm' },
] as const;

/** The box, each side cut into squares of 10 mm. */
function box(perUnit: number): Mesh {
  const positions: Mesh['positions'] = [];
  const triangles: Mesh['triangles'] = [];
  const numbers = new Map<string, number>();
  const vertex = (place: readonly number[]): number => {
    const key = place.join();
    const known = numbers.get(key);
    if (known !== undefined) return known;
    const [x, y, z] = place.map((along) => along / perUnit);
    numbers.set(key, positions.push([x, y, z]) - 1);
    return positions.length - 1;
  };
  for (const across of [0, 1, 2]) {
    const [u, v] = [(across + 1) % 3, (across + 2) % 3];
    for (const side of [0, SIDES[across]]) {
      for (let i = 0; i < SIDES[u]; i += 10) {
        for (let j = 0; j < SIDES[v]; j += 10) {
          const corner = (a: number, b: number) => {
            const place = [0, 0, 0];
            [place[across], place[u], place[v]] = [side, i + a, j + b];
            return vertex(place);
          };
          const [a, b, c, d] = [corner(0, 0), corner(10, 0), corner(10, 10), corner(0, 10)];
          if (side === 0) triangles.push([a, c, b], [a, d, c]);
          else triangles.push([a, b, c], [a, c, d]);
        }
      }
    }
  }
  return { positions, triangles };
}

const { positions: PLACES } = box(1);
const at = (x: number, y: number, z: number) => PLACES.findIndex((place) => place.join() === [x, y, z].join());
const [SOURCE, FAR, CORNER] = [at(0, 0, 0), at(...SIDES), at(100, 0, 0)];

async function saved(page: Page, button: string): Promise<Buffer> {
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: button, exact: true }).click();
  return readFile(await (await downloading).path());
}

/** The first length in a text, in millimeters: its number and unit stand side by side. */
function lengthIn(text: string | null, symbol: string): number {
  const [, number = 'none', unit = ''] = /([\d.]+) (units|mm|cm|in|m)\b/.exec(text ?? '') ?? [];
  expect([text, unit]).toEqual([text, symbol || 'units']);
  return Number(number) * (MILLIMETERS[unit] ?? 1);
}

/** Columns of a CSV file by their names, those of lengths in millimeters. */
function columnsOf(csv: string): Record<string, number[]> {
  const [head = '', ...rows] = csv.trim().split(/\r?\n/);
  const cells = rows.map((row) => row.split(','));
  const columns = head.split(',').map((name, index) => {
    const [, plain = name, unit] = /^"?(.*?)(?: \((.*)\))?"?$/.exec(name) ?? [];
    return [plain, cells.map((row) => Number(row[index]) * (unit ? MILLIMETERS[unit] : 1))] as const;
  });
  return Object.fromEntries(columns);
}

function boundsOf(places: readonly (readonly number[])[]): number[] {
  return [0, 1, 2].map((axis) => {
    const along = places.map((place) => place[axis]);
    return Math.max(...along) - Math.min(...along);
  });
}

function placesOf(text: string, pattern: RegExp): number[][] {
  return [...text.matchAll(pattern)].map((match) => match.slice(1, 4).map(Number));
}

function scaled(numbers: readonly number[], factor: number): number[] {
  return numbers.map((value) => value * factor);
}

interface Document {
  accessors: { min?: number[]; max?: number[] }[];
  meshes: { primitives: { attributes: Record<string, number> }[]; extras?: { distance: number } }[];
}

/** Meters are glTF's; without a unit numbers are those of the file. */
function extentOfGlb(bytes: Buffer, symbol: string): number[] {
  const { accessors, meshes } = JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString()) as Document;
  const used = meshes.flatMap(({ primitives }) =>
    primitives.map(({ attributes }) => accessors[attributes['POSITION']]),
  );
  const ends = used.flatMap(({ min = [], max = [] }) => [min, max]);
  return scaled(boundsOf(ends), symbol ? 1000 : 1);
}

/** What the page says and saves, each number in millimeters by the unit that stands beside it; in square millimeters the areas. */
async function allLengths(heatwalk: HeatwalkPage, symbol: string): Promise<Record<string, number | number[]>> {
  const { page } = heatwalk;
  const found: Record<string, number | number[]> = {};
  const shown = symbol ? MILLIMETERS[symbol] : 1;

  await openSection(page, 'numbers');
  const numbers = page.locator('.numbers');
  for (const name of ['Diagonal', 'Maximum distance', 'Path', 'Cost of the path']) {
    const cell = numbers.locator('dt', { hasText: new RegExp(`^${name}$`) }).locator('xpath=following-sibling::dd[1]');
    found[name] = lengthIn(await cell.textContent(), symbol);
  }
  const inWords = (value: number) => `${Number((value / shown).toPrecision(3))} ${symbol || 'units'}`;
  // The scene before was announced too, and this one is once it has come to rest.
  await expect(page.getByText(`Maximum distance ${inWords(OFFSET + PATH)}. Path ${inWords(PATH)}.`)).toHaveCount(1);
  found['corner to corner'] = lengthIn(await page.getByText('from corner to corner').textContent(), symbol);
  const offset = page.getByRole('spinbutton', { name: `Initial distance of source 1, in ${symbol || 'units'}` });
  found['offset'] = Number(await offset.inputValue()) * shown;

  await openSection(page, 'measure');
  const label = (await page.locator('.tape-label.leg').textContent()) ?? '';
  expect(label).toBe(`${Number((100 / shown).toPrecision(3))} ${symbol || 'units'}`);
  found['tape'] = Number(await page.getByRole('spinbutton', { name: 'Known length of tape 1' }).inputValue()) * shown;
  const tapes = columnsOf((await saved(page, 'Save CSV')).toString());
  found['tape in CSV'] = scaled([tapes['surface'][0], tapes['straight'][0], tapes['cost'][0]], shown);

  const girth = await openSection(page, 'girth');
  await girth.getByText('Measure the girth').click();
  const around = page.locator('.girth-label');
  await expect(around).toHaveText(/\d/);
  found['girth'] = lengthIn(await around.textContent(), symbol);
  await girth.getByText('Measure the girth').click();

  const section = await openSection(page, 'export');
  const wish = section.getByLabel(symbol ? `Isolines at (${symbol})` : 'Isolines at', { exact: true });
  found['isolines'] = scaled((await wish.inputValue()).split(';').map(Number), shown);
  await page.getByRole('button', { name: 'Measure isolines' }).click();
  const cells = section.locator('tbody tr').first().locator('td');
  await expect(section.locator('caption')).toHaveText(`2 isolines${symbol && `, ${symbol}`}`);
  const [value, length, area] = (await cells.allTextContents()).map(Number);
  Object.assign(found, { row: [value * shown, length * shown], 'area nearer': area * shown ** 2 });

  const file = async (list: string, kind: string, button: string) => {
    await section.getByRole('combobox', { name: list, exact: true }).selectOption(kind);
    return saved(page, button);
  };
  const curves = columnsOf((await file('File', 'csv', 'Save isolines')).toString());
  found['curves, CSV'] = boundsOf(curves['x'].map((x, row) => [x, curves['y'][row], curves['z'][row]]));
  found['values, CSV'] = [...new Set(curves['value'])];
  const dxf = (await file('File', 'dxf', 'Save isolines')).toString();
  const [, code = ''] = /\$INSUNITS\n\s*70\n(\d+)/.exec(dxf) ?? [];
  expect(code === '').toBe(symbol === '');
  found['curves, DXF'] = scaled(
    boundsOf(placesOf(dxf, /VERTEX\n\s*8\n.*\n\s*10\n(.*)\n\s*20\n(.*)\n\s*30\n(.*)\n/g)),
    code ? DXF_UNITS[code] : 1,
  );
  for (const kind of ['obj', 'strips.obj']) {
    const obj = (await file('File', kind, 'Save isolines')).toString();
    const [, unit = ''] = /^# lengths in (.*)$/m.exec(obj) ?? [];
    expect(unit).toBe(symbol);
    found[`curves, ${kind}`] = scaled(boundsOf(placesOf(obj, /^v (\S+) (\S+) (\S+)$/gm)), shown);
  }
  found['curves, GLB'] = extentOfGlb(await file('File', 'glb', 'Save isolines'), symbol);
  const svg = (await file('File', 'svg', 'Save isolines')).toString();
  const [, across = '', suffix = '', wide = ''] = /width="([\d.]+)(mm)?" .*viewBox="0 0 ([\d.]+)/.exec(svg) ?? [];
  expect(suffix).toBe(symbol && 'mm');
  // Millimeters are its units, where they are known.
  expect(Number(wide)).toBeCloseTo(symbol ? Number(across) : 1000, 6);
  expect(code).toBe(symbol && '4');
  // Without a unit it has no scale, and as many pixels.
  found['curves, SVG'] = suffix ? Number(across) : (Number(across) / 1000) * 1.06 * SIDES[0];

  if (symbol) {
    const pdf = (await file('File', 'pdf', 'Save isolines')).toString('latin1');
    const [, points = ''] = /\/MediaBox \[0 0 ([\d.]+) /.exec(pdf) ?? [];
    expect(pdf).toContain('(100 mm     1 : 1) Tj');
    // Without the margins of the page.
    found['curves, PDF'] = (Number(points) / 72) * 25.4 - 20;
  } else {
    await section.getByRole('combobox', { name: 'File', exact: true }).selectOption('pdf');
    await page.getByRole('button', { name: 'Save isolines' }).click();
    await expect(section.getByRole('status')).toContainText('nothing says what the lengths are in');
    found['curves, PDF'] = 1.06 * SIDES[0];
  }

  const csv = columnsOf((await file('Distances', 'csv', 'Save distances')).toString());
  found['distance, CSV'] = csv['distance'][FAR];
  const npy = await file('Distances', 'npy', 'Save distances');
  const doubles = new Float64Array(new Uint8Array(npy.subarray(10 + npy.readUInt16LE(8))).buffer);
  found['distance, NumPy'] = doubles[FAR] * shown;
  const ply = await file('Distances', 'ply', 'Save distances');
  const body = ply.indexOf('end_header\n') + 11;
  const [, unit = ''] = /^comment lengths in (.*)$/m.exec(ply.subarray(0, body).toString()) ?? [];
  expect(unit).toBe(symbol);
  const row = (vertex: number) => [0, 1, 2, 3].map((k) => ply.readDoubleLE(body + 8 * (4 * vertex + k)) * shown);
  found['PLY'] = boundsOf(PLACES.map((_, vertex) => row(vertex)));
  found['distance, PLY'] = row(FAR)[3];
  found['GLB'] = extentOfGlb(await file('Distances', 'glb', 'Save distances'), symbol);
  found['GLB with the stripes'] = extentOfGlb(await file('Distances', 'stripes.glb', 'Save distances'), symbol);

  const path = columnsOf((await file('Path', 'csv', 'Save path')).toString());
  found['path, CSV'] = path['length'].at(-1) ?? NaN;
  const line = (await file('Path', 'obj', 'Save path')).toString();
  found['path, OBJ'] = scaled(boundsOf(placesOf(line, /^v (\S+) (\S+) (\S+)$/gm)), shown);
  found['path, GLB'] = extentOfGlb(await file('Path', 'glb', 'Save path'), symbol);

  await page.getByRole('button', { name: 'Save sources' }).scrollIntoViewIfNeeded();
  const sources = columnsOf((await saved(page, 'Save sources')).toString());
  found['sources, CSV'] = sources['offset'];

  const mesh = await heatwalk.mesh();
  expect(mesh.unit).toBe(symbol);
  found['scripts'] = mesh.diameter * mesh.scale * shown;
  return found;
}

const RADII = ISOLINES.map((value) => value - OFFSET);
/** Three quarters of a circle around a corner, one on each side. */
const [LENGTH, AREA] = [(3 / 4) * 2 * Math.PI * RADII[0], (3 / 4) * Math.PI * RADII[0] ** 2];
/** Isolines are straight within triangles: distance is too large there by h² / 8r at most, and areas are twice as far off. */
const FLATTENED = Math.hypot(10, 10) ** 2 / (4 * RADII[0] ** 2);
const EXTENT = [RADII[1], RADII[1], RADII[1]];

const EXPECTED: Readonly<Record<string, number | readonly number[]>> = {
  Diagonal: DIAGONAL,
  'Maximum distance': OFFSET + PATH,
  Path: PATH,
  'Cost of the path': PATH,
  'corner to corner': DIAGONAL,
  offset: OFFSET,
  tape: 100,
  girth: 2 * (SIDES[0] + SIDES[1]),
  'tape in CSV': [100, 100, 100],
  isolines: ISOLINES,
  row: [ISOLINES[0], LENGTH],
  'area nearer': AREA,
  'curves, CSV': EXTENT,
  'values, CSV': ISOLINES,
  'curves, DXF': EXTENT,
  'curves, obj': EXTENT,
  'curves, strips.obj': SIDES,
  'curves, GLB': EXTENT,
  // What is seen, and the margins on both sides.
  'curves, SVG': 1.06 * SIDES[0],
  'curves, PDF': 1.06 * SIDES[0],
  'distance, CSV': OFFSET + PATH,
  'distance, NumPy': OFFSET + PATH,
  PLY: SIDES,
  'distance, PLY': OFFSET + PATH,
  GLB: SIDES,
  'GLB with the stripes': SIDES,
  'path, CSV': PATH,
  'path, OBJ': SIDES,
  'path, GLB': SIDES,
  'sources, CSV': [OFFSET, 20 * OFFSET],
  scripts: DIAGONAL,
};

for (const { name, perUnit, options, symbol } of CASES) {
  test(`a box ${name} means the same millimeters in all that is shown and saved`, async ({ heatwalk }) => {
    const [offset, ...levels] = [OFFSET, ...ISOLINES].map((millimeters) => millimeters / perUnit);
    await heatwalk.openFile(
      'box.off',
      off(box(perUnit)),
      `up=z&cam=0,0,3,0,0,0&method=exact&s=${SOURCE}@${offset},${CORNER}@${20 * offset}&w=${FAR}&way=exact&tape=${SOURCE},${CORNER}&iso=${levels.join()}&${options}`,
    );
    await heatwalk.settled();
    const found = await allLengths(heatwalk, symbol);
    const wrong = Object.entries(EXPECTED).filter(([key, value]) => {
      const [wanted, others] = [value, found[key]].map((each) => [each].flat());
      const tolerance = key === 'row' || key === 'area nearer' ? FLATTENED : TOLERANCE;
      return !wanted.every((one, index) => Math.abs(others[index] / one - 1) <= tolerance);
    });
    expect(wrong.map(([key, value]) => [key, value, found[key]])).toEqual([]);
  });
}
