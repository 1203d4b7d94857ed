import { glb, type Mesh, obj, off, sphere } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';

/** A tower on a square base in the plane z = 0; vertex 0 is its tip. */
const TOWER: Mesh = {
  positions: [
    [0, 0, 3],
    [-1, -1, 0],
    [1, -1, 0],
    [1, 1, 0],
    [-1, 1, 0],
  ],
  triangles: [
    [1, 3, 2],
    [1, 4, 3],
    [1, 2, 0],
    [2, 3, 0],
    [3, 4, 0],
    [4, 1, 0],
  ],
};
const TIP = { vertex: 0 };

/** How far the tip is above the base on the screen, CSS pixels. */
async function rise(heatwalk: HeatwalkPage): Promise<number> {
  const [, tip] = await heatwalk.pixelOf(TIP);
  const base = [1, 2, 3, 4].map((vertex) => heatwalk.pixelOf({ vertex }));
  return Math.min(...(await Promise.all(base)).map(([, y]) => y)) - tip;
}

test('a file that stands along Z is drawn so, and a key turns it on; distances stay', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await heatwalk.dropAndOpen([['tower.obj', obj({ tower: TOWER })]]);
  expect((await heatwalk.mesh()).up).toBe('z');
  expect(await rise(heatwalk)).toBeGreaterThan(100);
  await expect(page).toHaveURL(/name=tower\.obj/);
  await expect(page).toHaveURL(/&up=auto/);
  const { sources } = await heatwalk.scene();
  const distance = await heatwalk.distanceAt(TIP);
  expect(distance).toBeGreaterThan(0);

  await page.keyboard.press('u');
  await expect.poll(async () => (await heatwalk.mesh()).up).toBe('x');
  await expect(page).toHaveURL(/&up=x/);
  expect(await rise(heatwalk)).toBeLessThan(100);
  expect((await heatwalk.scene()).sources).toEqual(sources);
  expect(await heatwalk.distanceAt(TIP)).toBe(distance);
  expect((await heatwalk.mesh()).diameter).toBeCloseTo(Math.sqrt(17), 5);

  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await heatwalk.mesh()).up).toBe('z');
  expect((await heatwalk.scene()).up).toBe('auto');
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(async () => (await heatwalk.mesh()).up).toBe('x');
});

test('a link says which axis points up, and so does the panel', async ({ heatwalk, page }) => {
  await heatwalk.openFile('tower.obj', obj({ tower: TOWER }), 'up=-z');
  expect((await heatwalk.mesh()).up).toBe('-z');
  expect(await rise(heatwalk)).toBeLessThan(0);
  await openSection(page, 'display');
  const select = page.getByRole('combobox', { name: /^Up/ });
  await expect(select).toHaveValue('-z');
  await select.selectOption('automatic (+Z)');
  await expect.poll(async () => (await heatwalk.mesh()).up).toBe('z');
});

test('glTF and presets are Y up whatever their shape', async ({ heatwalk }) => {
  await heatwalk.open();
  expect(await heatwalk.mesh()).toMatchObject({ name: 'bunny', up: 'y' });
  await heatwalk.dropAndOpen([['tower.glb', glb(TOWER)]]);
  expect((await heatwalk.mesh()).up).toBe('y');
});

test('a source that is set while the model is turned stays, and Cancel leaves it as it was', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#v=1&m=file&name=ball.off&s=0&refine=0');
  await heatwalk.dropAndOpen([['ball.off', off(sphere(120))]]);
  await heatwalk.settled();
  await page.evaluate(() => {
    dispatchEvent(new KeyboardEvent('keydown', { key: 'u' }));
    document.querySelector<HTMLButtonElement>('.loading button')?.click();
  });
  await heatwalk.settled();
  expect(await heatwalk.mesh()).toMatchObject({ name: 'ball.off', up: 'y' });
  expect((await heatwalk.scene()).up).toBe('y');

  const [x, y] = await heatwalk.pixelOnModel();
  await page.keyboard.press('u');
  await page.mouse.click(x, y);
  await expect.poll(async () => (await heatwalk.mesh()).up).toBe('z');
  await heatwalk.settled();
  const { sources } = await heatwalk.scene();
  expect(sources).toEqual([expect.objectContaining({ face: expect.any(Number) })]);
  expect(await heatwalk.distanceAt(sources[0])).toBeLessThan(0.05);
});
