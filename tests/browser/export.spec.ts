import { execFileSync } from 'node:child_process';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { complaints } from '../gltf';
import { crossings, expect, openSection, SEEN, test } from '../page';
import { texturedGlb } from '../textured';

test.use(SEEN);

async function saved(page: Page, button: string): Promise<{ name: string; bytes: Buffer }> {
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: button }).click();
  const download = await downloading;
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

function documentOf(glb: Buffer) {
  return JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString()) as {
    materials: { normalTexture?: { extensions: object } }[];
    images: object[];
  };
}

test('isolines are drawn, measured and saved, and distances with the materials of the file', async ({ heatwalk }) => {
  const { page } = heatwalk;
  await heatwalk.open('#m=torus&show=scenery,isolines');
  await heatwalk.settled();
  const section = await openSection(page, 'export');
  await section.scrollIntoViewIfNeeded();

  await page.getByLabel('Isolines at').fill('0.5, 1');
  await expect.poll(() => page.url()).toContain('&iso=0.5,1');
  await page.getByRole('button', { name: 'Measure isolines' }).click();
  const cells = section.locator('tbody tr').first().locator('td');
  await expect(cells.first()).toHaveText('0.5');
  await expect(cells.last()).toHaveText('1 of 1');

  const [curves, distances] = [section.locator('select').nth(0), section.locator('select').nth(1)];
  await curves.selectOption('csv');
  const table = await saved(page, 'Save isolines');
  expect(table.name).toBe('torus.isolines.csv');
  const rows = table.bytes.toString().trim().split('\n').slice(1);
  const values = new Set(rows.map((row) => Number(row.split(',')[1])));
  expect([...values]).toEqual([0.5, 1]);
  // The axis of the ring is Y, and its tube is 0.4 thick around a circle of radius 1.
  for (const row of rows.slice(0, 20)) {
    const [x, y, z] = row.split(',').slice(3).map(Number);
    expect(Math.abs(Math.hypot(Math.hypot(x, z) - 1, y) / 0.4 - 1)).toBeLessThan(0.05);
  }

  await curves.selectOption('glb');
  expect(await complaints((await saved(page, 'Save isolines')).bytes)).toEqual([]);
  await section.getByLabel('Path').selectOption('glb');
  const path = await saved(page, 'Save path');
  expect(path.name).toBe('torus.path.glb');
  expect(await complaints(path.bytes)).toEqual([]);
  await section.getByLabel('Path').selectOption('csv');
  const places = (await saved(page, 'Save path')).bytes.toString().trim().split('\n');
  const walked = Number(places.at(-1)?.split(',')[0]);
  const { length = NaN } = (await page.evaluate(() => window.heatwalk.walker)) ?? {};
  expect(walked / length).toBeCloseTo(1, 11);

  await curves.selectOption('unrolled.svg');
  await page.getByRole('button', { name: 'Save isolines' }).click();
  await expect(section.getByRole('status')).toContainText('cannot be unrolled');
  // Flat are only those that are narrower than triangles.
  await page.getByLabel('Isolines at').fill('0.5, 0.501, 1');
  const sheet = await saved(page, 'Save isolines');
  expect(sheet.bytes.toString()).toMatch(/^<svg[^>]*>\n<g[^>]*>\n<path class="strip_1_0.5_to_0.501"/);
  await expect(section.getByRole('status')).toContainText('the strips below 0.5');

  await distances.selectOption('npy');
  const { bytes } = await saved(page, 'Save distances');
  expect(bytes.subarray(1, 6).toString()).toBe('NUMPY');
  const numbers = new Float64Array(new Uint8Array(bytes.subarray(10 + bytes.readUInt16LE(8))).buffer);
  expect(numbers.length).toBe(await page.evaluate(() => window.heatwalk.mesh?.vertices));
  const largest = await page.evaluate(() => window.heatwalk.field?.maxDistance ?? 0);
  expect(Math.max(...numbers)).toBeCloseTo(largest, 5);

  // What is saved is opened again.
  await distances.selectOption('glb');
  const scene = await saved(page, 'Save distances');
  expect(await complaints(scene.bytes)).toEqual([]);
  await heatwalk.dropAndOpen([['again.glb', scene.bytes]]);
  expect(await page.evaluate(() => window.heatwalk.mesh?.triangles)).toBe(17_280);

  // Two materials, one of them with two images, one of these scaled.
  await heatwalk.dropAndOpen([['textured.glb', texturedGlb()]]);
  const { bytes: textured } = await saved(page, 'Save distances');
  // Tangents are left to the program that draws, as in the file that was read.
  const tangents = expect.stringContaining('MESH_PRIMITIVE_GENERATED_TANGENT_SPACE') as unknown;
  expect(await complaints(textured)).toEqual([tangents]);
  const { materials, images } = documentOf(textured);
  expect(materials.map((material) => material.normalTexture?.extensions)).toEqual([
    { KHR_texture_transform: { offset: [0, 0], rotation: 0, scale: [4, 4] } },
    undefined,
  ]);
  expect(images).toHaveLength(2);
});

test('a GLB with the stripes shows them where it is opened again', async ({ heatwalk, page }) => {
  await heatwalk.withoutLegend();
  const view = 'cam=0.4,0.9,3,0,0,0&s=7264&w=none&show=scenery';
  await heatwalk.open(`#m=torus&look=zebra&${view}`);
  const [x, y] = await heatwalk.page.evaluate(() => window.heatwalk.centre);
  const before = crossings(await heatwalk.picture(), x, 0, 2 * y);
  expect(before).toBeGreaterThan(8);
  await heatwalk.closeSummary();
  const section = await openSection(page, 'export');
  await section.getByRole('combobox', { name: 'Distances', exact: true }).selectOption('stripes.glb');
  const { name, bytes } = await saved(page, 'Save distances');
  expect(name).toBe('torus.stripes.glb');
  expect(await complaints(bytes)).toEqual([]);
  await heatwalk.open(`#v=1&m=file&name=again.glb&look=model&style=none&${view}`);
  await heatwalk.dropAndOpen([['again.glb', bytes]]);
  expect(crossings(await heatwalk.picture(), x, 0, 2 * y)).toBe(before);

  // Materials of a file have a texture of their own.
  await heatwalk.dropAndOpen([['textured.glb', texturedGlb()]]);
  await heatwalk.settled();
  await openSection(page, 'export');
  await section.getByRole('combobox', { name: 'Distances', exact: true }).selectOption('stripes.glb');
  expect(await complaints((await saved(page, 'Save distances')).bytes)).toEqual([]);
  await expect(section.getByRole('status')).toHaveText(/without the materials of the file/);
});

test('tracks of the crowd lead down to a source', async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await heatwalk.open('#m=torus&method=exact&crowd=20');
  await heatwalk.settled();
  await page.keyboard.press('p');
  await openSection(page, 'export');
  const { name, bytes } = await saved(page, 'Save tracks');
  expect(name).toBe('torus.tracks.csv');
  const rows = bytes
    .toString()
    .trim()
    .split('\n')
    .slice(1)
    .map((row) => row.split(',').map(Number));
  const last = new Map(rows.map(([walker, ...rest]) => [walker, rest]));
  expect([...last.keys()]).toEqual(Array.from({ length: 20 }, (_, index) => index));
  // All come to the one source, and none walks farther than the farthest place is, but for what descent is longer.
  const [[, ...end]] = last.values();
  for (const [length, ...point] of last.values()) {
    point.forEach((coordinate, axis) => expect(coordinate).toBeCloseTo(end[axis], 9));
    expect(length).toBeLessThan(1.05 * (await page.evaluate(() => window.heatwalk.field?.maxDistance ?? 0)));
  }
  expect(Math.max(...[...last.values()].map(([length]) => length))).toBeGreaterThan(1);
});

interface Found {
  ply: { vertices: number; triangles: number; farthest: number };
  colors: number;
  glb: { triangles: number; farthest: number };
  npy: [number, number];
  dxf: { curves: number; closed: number; length: number };
  strips: number;
  path: number;
}

test('numpy, trimesh and ezdxf read what is saved', async ({ heatwalk, page }, info) => {
  const python = process.env['HEATWALK_PYTHON'] ?? '';
  test.skip(python === '', 'HEATWALK_PYTHON names no Python with them');
  await heatwalk.open('#m=torus&iso=0.5,1,1.5');
  await heatwalk.settled();
  const section = await openSection(page, 'export');
  const folder = info.outputPath('saved');
  await mkdir(folder);
  const save = async (list: string, kinds: readonly string[], button: string) => {
    for (const kind of kinds) {
      await section.getByRole('combobox', { name: list, exact: true }).selectOption(kind);
      const { name, bytes } = await saved(page, button);
      await writeFile(join(folder, name), bytes);
    }
  };
  await save('Distances', ['ply', 'weights.ply', 'glb', 'npy'], 'Save distances');
  await save('File', ['dxf', 'strips.obj'], 'Save isolines');
  await save('Path', ['glb'], 'Save path');
  await page.getByRole('button', { name: 'Measure isolines' }).click();
  await expect(section.locator('tbody tr')).toHaveCount(3);
  const cells = await section
    .locator('tbody tr')
    .evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll('td')].map((cell) => cell.textContent ?? '')));

  const output = execFileSync(python, ['tests/readers.py', folder], { encoding: 'utf8' });
  const found = JSON.parse(output) as Found;
  const { vertices, triangles, farthest, walked } = await page.evaluate(() => ({
    vertices: window.heatwalk.mesh?.vertices ?? 0,
    triangles: window.heatwalk.mesh?.triangles ?? 0,
    farthest: window.heatwalk.field?.maxDistance ?? 0,
    walked: window.heatwalk.walker?.length ?? 0,
  }));
  expect(found.ply).toEqual({ vertices, triangles, farthest: expect.closeTo(farthest, 5) });
  expect(found.colors).toBeGreaterThan(100);
  // glTF has single precision.
  expect(found.glb).toEqual({ triangles, farthest: expect.closeTo(farthest, 5) });
  expect(found.npy).toEqual([vertices, expect.closeTo(farthest, 5)]);
  expect(found.dxf.curves).toBe(cells.reduce((sum, row) => sum + Number(row[3].split(' of ')[1]), 0));
  expect(found.dxf.closed).toBe(cells.reduce((sum, row) => sum + Number(row[3].split(' of ')[0]), 0));
  const total = cells.reduce((sum, row) => sum + Number(row[1]), 0);
  // The table has three digits.
  expect(Math.abs(found.dxf.length / total - 1)).toBeLessThan(0.005);
  // A torus of radii 1 and 0.4, of triangles inside of it.
  expect(found.strips / (4 * Math.PI ** 2 * 0.4)).toBeGreaterThan(0.99);
  expect(found.strips / (4 * Math.PI ** 2 * 0.4)).toBeLessThan(1);
  expect(found.path).toBeCloseTo(walked, 4);
});
