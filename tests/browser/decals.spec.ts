import { readFile } from 'node:fs/promises';
import type { Locator, Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { entry } from '../../web/state/entry';
import { areaOfTriangle, type Vector, vectorAt } from '../../web/state/vector';
import { grid, type Mesh, off } from '../fixtures';
import { expect, openSection, test } from '../page';
import { cubeMsh } from '../tetrahedra';

const N = 24;
const GRID = off(grid(N));
const vertex = (i: number, j: number) => i + (N + 1) * j;
const VIEW = 'up=z&cam=0,1.5,2.6,0,0,0&method=auto&w=none&s=0&open=look';

/** The unit cube: two triangles a side. */
const CUBE: Mesh = {
  positions: [0, 1].flatMap((z): Mesh['positions'] => [
    [0, 0, z],
    [1, 0, z],
    [1, 1, z],
    [0, 1, z],
  ]),
  triangles: [
    [0, 2, 1],
    [0, 3, 2],
    [4, 5, 6],
    [4, 6, 7],
    ...[0, 1, 2, 3].flatMap((k): Mesh['triangles'] => {
      const next = (k + 1) % 4;
      return [
        [k, next, next + 4],
        [k, next + 4, k + 4],
      ];
    }),
  ],
};

interface Part {
  positions: readonly (readonly number[])[];
  places: readonly (readonly number[])[];
  area: number;
}

interface Glb {
  meshes: { primitives: { attributes: { POSITION: number; TEXCOORD_0: number }; indices: number }[] }[];
  accessors: { bufferView: number; count: number; type: string }[];
  bufferViews: { byteOffset: number; byteLength: number }[];
  images: { mimeType: string; bufferView: number }[];
}

/** The file that "Save images as GLB" writes: of each image its corners, their places in the image, and its area. */
async function saved(page: Page): Promise<{ parts: Part[]; images: PNG[] }> {
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save images as GLB' }).click();
  const bytes = await readFile(await (await downloading).path());
  const length = bytes.readUInt32LE(12);
  const root = JSON.parse(bytes.subarray(20, 20 + length).toString()) as Glb;
  const view = (index: number) => {
    const { byteOffset, byteLength } = entry(root.bufferViews, index);
    return bytes.subarray(28 + length + byteOffset, 28 + length + byteOffset + byteLength);
  };
  const rows = (index: number, width: number) => {
    const { bufferView, count } = entry(root.accessors, index);
    const data = view(bufferView);
    return Array.from({ length: count }, (_, row) =>
      Array.from({ length: width }, (__, k) => data.readFloatLE(4 * (width * row + k))),
    );
  };
  const parts = root.meshes.map(({ primitives }): Part => {
    const { attributes, indices } = entry(primitives, 0);
    const positions = rows(attributes.POSITION, 3);
    const data = view(entry(root.accessors, indices).bufferView);
    const corners = Array.from({ length: data.length / 4 }, (_, k) => data.readUInt32LE(4 * k));
    const places = positions as Vector[];
    const faces = Array.from({ length: corners.length / 3 }, (_, face) => vectorAt(corners, face));
    const areas = faces.map(([a, b, c]) => areaOfTriangle([entry(places, a), entry(places, b), entry(places, c)]));
    const area = areas.reduce((sum, one) => sum + one, 0);
    return { positions, places: rows(attributes.TEXCOORD_0, 2), area };
  });
  return { parts, images: root.images.map(({ bufferView }) => PNG.sync.read(view(bufferView))) };
}

async function middleOf(handle: Locator): Promise<[number, number]> {
  const box = await handle.boundingBox();
  if (!box) throw new Error('The handle is not seen.');
  return [box.x + box.width / 2, box.y + box.height / 2];
}

test('on a plane an image lies as it is, in the link and in its file', async ({ heatwalk, page }) => {
  const [size, angle] = [0.25, 30];
  await heatwalk.openFile('grid.off', GRID, `${VIEW}&decal=${vertex(12, 12)},${size},${angle},grid`);
  await openSection(page, 'decals');
  const { parts, images } = await saved(page);
  const [{ positions, places, area }] = parts as [Part];
  expect(area).toBeCloseTo(4 * size * size, 5);
  expect([images[0]?.width, images[0]?.height]).toEqual([512, 512]);
  // Seen from above, where the back is up, and with the angle counterclockwise.
  const turned = (angle * Math.PI) / 180;
  positions.forEach(([x = 0, y = 0], index) => {
    const [dx, dy] = [x - 0.5, y - 0.5];
    const along = dx * Math.cos(turned) + dy * Math.sin(turned);
    const upward = dy * Math.cos(turned) - dx * Math.sin(turned);
    expect(places[index]?.[0]).toBeCloseTo((1 + along / size) / 2, 4);
    expect(places[index]?.[1]).toBeCloseTo((1 - upward / size) / 2, 4);
  });
});

test('an image is laid on, moved, turned, scaled and removed by handles and keys', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, VIEW);
  await openSection(page, 'decals');
  await page.getByRole('combobox', { name: 'Image' }).selectOption('star');
  await page.getByRole('button', { name: 'Lay on' }).click();
  await heatwalk.settled();
  const decal = async () => entry((await heatwalk.scene()).decals, 0);
  const before = await decal();
  expect(before.image).toBe('star');
  const middle = page.getByRole('button', { name: 'Middle of the image' });
  const side = page.getByRole('button', { name: 'Right side of the image' });
  const drag = async (handle: typeof middle, dx: number, dy: number) => {
    const [x, y] = await middleOf(handle);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx / 2, y + dy / 2);
    await page.mouse.move(x + dx, y + dy);
    await page.mouse.up();
    await heatwalk.settled();
    // Handles stand on the image once it lies, from the next frame on.
    await heatwalk.drawing(0.1, false);
    await page.evaluate(() => new Promise(requestAnimationFrame));
  };
  const apart = async () => {
    const [[x, y], [u, v]] = [await middleOf(middle), await middleOf(side)];
    return [u - x, v - y] as const;
  };
  const [reach] = await apart();
  await drag(middle, 60, -30);
  const moved = await decal();
  expect(moved.place).not.toEqual(before.place);
  expect(moved.size).toBe(before.size);
  expect(Math.abs(moved.angle)).toBeLessThan(0.5);
  // A quarter turn upward, and twice as large.
  await drag(side, -reach, -2 * reach);
  const turned = await decal();
  expect(turned.angle).toBeGreaterThan(80);
  expect(turned.angle).toBeLessThan(100);
  expect(turned.size / before.size).toBeGreaterThan(1.7);
  expect(turned.size / before.size).toBeLessThan(2.4);
  const [along, down] = await apart();
  expect(Math.abs(along)).toBeLessThan(0.3 * reach);
  expect(down).toBeLessThan(-1.5 * reach);
  await side.focus();
  await page.keyboard.press('ArrowLeft');
  expect((await decal()).angle).toBeCloseTo(turned.angle + 5, 3);
  await page.keyboard.press('ArrowUp');
  expect((await decal()).size).toBeCloseTo(turned.size * 1.05, 6);
  await middle.focus();
  await page.keyboard.press('ArrowRight');
  expect((await decal()).place).not.toEqual(turned.place);
  await expect.poll(() => page.evaluate(() => location.hash)).toContain(',star');
  await page.keyboard.press('Delete');
  expect((await heatwalk.scene()).decals).toEqual([]);
  await expect(middle).toBeHidden();
  await page.keyboard.press('Control+z');
  expect((await decal()).image).toBe('star');
});

test('large triangles are divided, and an image ends where both sides meet', async ({ heatwalk, page }) => {
  const place = '2:0.5/0/0.5';
  await heatwalk.openFile('cube.off', off(CUBE), `${VIEW}&decal=${place},0.6,0,grid`);
  await openSection(page, 'decals');
  const [{ area, positions }] = (await saved(page)).parts as [Part];
  // A face, and a strip of each face beside it.
  expect(area).toBeGreaterThan(1.36);
  expect(area).toBeLessThan(1.42);
  // Beyond it the triangles of a row at most, where two ways meet.
  expect(Math.min(...positions.map(([, , z = 0]) => z))).toBeGreaterThan(0.8);
});

test('an image of the user is dropped where it is to lie, with its shape, and is found again', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.openFile('grid.off', GRID, VIEW);
  await openSection(page, 'decals');
  const image = new PNG({ width: 6, height: 3 });
  image.data.fill(255);
  await heatwalk.drop([['mark.png', PNG.sync.write(image)]]);
  await expect.poll(async () => (await heatwalk.scene()).decals.length).toBe(1);
  await heatwalk.settled();
  const { image: name, size } = entry((await heatwalk.scene()).decals, 0);
  expect(name).toMatch(/^file-[0-9a-f]{16}$/);
  const { parts, images } = await saved(page);
  expect(parts[0]?.area).toBeCloseTo(2 * size * size, 5);
  expect([images[0]?.width, images[0]?.height]).toEqual([6, 3]);
  await expect.poll(() => page.evaluate(() => location.hash)).toContain(name);
  await page.reload();
  await heatwalk.settled();
  await openSection(page, 'decals');
  expect((await saved(page)).parts).toHaveLength(1);
});

test('what cannot be laid is told, and the scene stays', async ({ heatwalk, page }) => {
  const alert = page.getByRole('alert');
  await heatwalk.openFile(
    'grid.off',
    GRID,
    `${VIEW}&decal=3,0.1,0,file-0123456789abcdef;${vertex(12, 12)},0.1,0,polar`,
  );
  await expect(alert).toContainText('The image of this scene is not in this browser.');
  await openSection(page, 'decals');
  expect((await saved(page)).parts).toHaveLength(1);
  await heatwalk.drop([['broken.png', 'no image']]);
  await expect(alert).toContainText('The browser cannot read this image.');
  await heatwalk.openFile('cube.msh', cubeMsh(2), 'method=auto&s=0&open=look');
  await openSection(page, 'decals');
  await expect(page.getByText('Images are on surfaces alone.')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Lay on' })).toBeDisabled();
});
