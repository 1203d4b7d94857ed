/** Files of points alone: joined, drawn as discs, and everything that works on surfaces. */
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import { strToU8, zipSync } from 'fflate';
import { grid, off, sphere } from '../fixtures';
import { difference, expect, openSection, SEEN, test } from '../page';

test.use(SEEN);

const RINGS = 16;
const BALL = sphere(RINGS).positions;
const POINTS = BALL.length;
/** Lines of points, with the normals of the sphere. */
const XYZ = BALL.map((place) => `${place.join(' ')} ${place.join(' ')}\n`).join('');
const [NORTH, SOUTH] = [{ vertex: 0 }, { vertex: POINTS - 1 }];

function ply(points: readonly (readonly number[])[], color = ''): string {
  const channels = color ? 'property uchar red\nproperty uchar green\nproperty uchar blue\n' : '';
  const header = `ply\nformat ascii 1.0\nelement vertex ${points.length}\nproperty float x\nproperty float y\nproperty float z\n${channels}end_header\n`;
  return header + points.map((place) => `${place.join(' ')} ${color}\n`).join('');
}

test('points without faces are joined, told of, and solved on', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=file&name=ball.xyz&s=0&w=none');
  await heatwalk.dropAndOpen([['ball.xyz', XYZ]]);
  await heatwalk.settled();
  await expect(page.locator('.heading')).toContainText(`${POINTS} points`);
  await expect(page.locator('.message.summary')).toContainText(
    `ball.xyz, ${POINTS} points, in one piece. ${2 * POINTS - 4} triangles join them, without a hole.`,
  );
  expect(await heatwalk.mesh()).toMatchObject({ vertices: POINTS, triangles: 2 * POINTS - 4, parts: ['ball'] });
  expect(await heatwalk.distanceAt(NORTH)).toBe(0);
  expect(await heatwalk.distanceAt(SOUTH)).toBeCloseTo(Math.PI, 1);

  // A hemisphere ends, and a point far away is on no triangle.
  const half = [...BALL.slice(0, 1 + 8 * 2 * RINGS), [90, 0, 0]];
  await heatwalk.dropAndOpen([['half.ply', ply(half)]]);
  await expect(page.locator('.message.summary')).toContainText('with 1 hole or border. 1 point is on no triangle.');
  const mesh = await heatwalk.mesh();
  expect(mesh).toMatchObject({ vertices: half.length - 1, boundaryLoops: 1 });
  await heatwalk.settled();
  expect(await heatwalk.distanceAt({ vertex: half.length - 1 })).toBeNaN();
});

test('the points are drawn as discs that are pressed, or the surface that joins them', async ({ heatwalk, page }) => {
  await heatwalk.openInSection('display', 'ball.xyz', XYZ, 's=40&w=none&cam=0.4,0.5,3,0,0,0');
  const discs = await heatwalk.lastPicture();
  const toggle = page.getByLabel('Surface in the place of points');
  await expect(toggle).not.toBeChecked();
  await toggle.check();
  expect((await heatwalk.scene()).overlays).toEqual(['scenery', 'joined']);
  const joined = await heatwalk.lastPicture();
  // Through gaps between discs, the far side is seen.
  expect(difference(discs, joined)).toBeGreaterThan(0.005);
  await expect(page).toHaveURL(/&show=scenery,joined/);
  await toggle.uncheck();
  expect(difference(discs, await heatwalk.lastPicture())).toBeLessThan(0.001);

  // A press beside a point takes it; on the surface, the place that was pressed.
  const [x, y] = await heatwalk.pixelOnModel(0.02, 0.03);
  const placeAt = () =>
    page.evaluate(
      ([left, top]) => window.heatwalk.placeAt(left, top) as { face: number; weights: [number, number, number] },
      [x, y] as const,
    );
  const point = await placeAt();
  expect(point.weights.toSorted()).toEqual([0, 0, 1]);
  const [left, top] = await heatwalk.pixelOf(point);
  expect(Math.hypot(left - x, top - y)).toBeGreaterThan(1);
  await page.mouse.click(x, y);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(point)).toBe(0);
  await toggle.check();
  expect(Math.max(...(await placeAt()).weights)).toBeLessThan(1);
});

test('ground is painted on points, and arrows are drawn, one a point', async ({ heatwalk, page }) => {
  await heatwalk.openInSection('display', 'ball.xyz', XYZ, 's=40&w=none&cam=0.4,0.5,3,0,0,0&method=heat&height=3');
  const plain = await heatwalk.lastPicture();
  await page.getByLabel('Distance gradient').check();
  expect(difference(plain, await heatwalk.lastPicture())).toBeGreaterThan(0.005);
  await page.getByLabel('No arrows').check();
  await page.getByLabel('Mesh edges').check();
  expect(difference(plain, await heatwalk.lastPicture())).toBeGreaterThan(0.02);
  await expect(page.locator('.message.error')).toHaveCount(0);
});

test('packed, from an address, and in a scene that is saved', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await heatwalk.drop([['balls.zip', Buffer.from(zipSync({ 'a/ball.ply': strToU8(ply(BALL)) }))]]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.ply');
  await heatwalk.drop([['ball.obj.gz', gzipSync(BALL.map((place) => `v ${place.join(' ')}\n`).join(''))]]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.obj');
  expect((await heatwalk.mesh()).triangles).toBe(2 * POINTS - 4);

  await page.route('https://models.example/**', (route) =>
    route.fulfill({ headers: { 'Access-Control-Allow-Origin': '*' }, body: XYZ }),
  );
  await heatwalk.open('#model=https://models.example/ball.xyz&s=7&w=none');
  await page.locator('.message').getByRole('button', { name: 'Open', exact: true }).click();
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.xyz');
  await heatwalk.settled();
  expect(await heatwalk.distanceAt({ vertex: 7 })).toBe(0);

  await openSection(page, 'share');
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save scene' }).click();
  const saved = await readFile(await (await downloading).path());
  await heatwalk.open('#v=1&m=icosphere');
  await heatwalk.drop([['saved.heatwalk.zip', saved]]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.xyz');
  await heatwalk.settled();
  expect(await heatwalk.scene()).toMatchObject({ sources: [{ vertex: 7 }] });
});

test('colors of points are those of the file', async ({ heatwalk }) => {
  await heatwalk.open();
  await heatwalk.dropAndOpen([['red.ply', ply(BALL, '255 0 0')]]);
  await heatwalk.settled();
  expect((await heatwalk.scene()).style.surfaceOf).toBe('file');
  const { data } = await heatwalk.drawing(0.5, true);
  let [red, green] = [0, 0];
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] < 255) continue;
    red += data[i];
    green += data[i + 1];
  }
  expect(red).toBeGreaterThan(2 * green);
});

test('text beside a mesh is not opened, rows stay places on the mesh on screen, and what is no point is named', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  await heatwalk.drop([
    ['readme.txt', 'about the grid'],
    ['grid.off', off(grid(4))],
  ]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('grid.off');
  await expect(page.locator('.message', { hasText: 'one of' })).toHaveCount(0);
  await heatwalk.drop([['places.csv', 'x,y,z\n0,0,0\n1,1,0\n']]);
  await expect.poll(async () => (await heatwalk.scene()).sets.length).toBe(1);
  expect((await heatwalk.mesh()).name).toBe('grid.off');
  const alert = page.getByRole('alert');
  await heatwalk.drop([['notes.txt', '1 2 3\nabout nothing\n']]);
  await expect(alert).toContainText('notes.txt was not opened: points, line 2: a point needs three numbers');
  await heatwalk.drop([['line.pts', '0 0 0\n1 1 0\n2 2 0\n']]);
  await expect(alert).toContainText('all 3 points lie on lines');
});
