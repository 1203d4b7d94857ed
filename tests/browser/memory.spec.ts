import type { Locator } from '@playwright/test';
import { grid, off, sphere } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';

const NAME = 'grid.off';
const CONTENT = off(grid(100));

const REFUSED = /grid\.off was not opened: factoring takes ([\d.]+) MiB of memory/;

/** The message that refuses the mesh; the one before stays. */
async function refused(heatwalk: HeatwalkPage, options: string, why: RegExp): Promise<Locator> {
  await heatwalk.open(`#v=1&m=file&name=${NAME}&s=3&refine=0&${options}`);
  const before = await heatwalk.mesh();
  await heatwalk.drop([[NAME, CONTENT]]);
  const message = heatwalk.page.getByRole('alert');
  await expect(message).toContainText(why);
  expect(await heatwalk.mesh()).toEqual(before);
  return message;
}

test('a mesh whose factors do not fit is refused, and opens with conjugate gradients', async ({ heatwalk, page }) => {
  const message = await refused(heatwalk, 'memory=1', REFUSED);
  expect((await heatwalk.scene()).mesh).toMatchObject({ kind: 'preset' });
  expect(await heatwalk.distanceAt({ vertex: 0 })).toBeGreaterThanOrEqual(0);

  await message.getByRole('button', { name: 'Use conjugate gradients' }).click();
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe(NAME);
  await expect(message).toBeEmpty();
  expect((await heatwalk.scene()).parameters).toMatchObject({ solver: 'cg', memory: 1 });
  expect((await heatwalk.field()).maxDistance).toBeGreaterThan(1);
  await expect(page).toHaveURL(/[&]solver=cg/);
  await expect(page).toHaveURL(/[&]hash=[0-9a-f]{64}/);
});

test('a setting whose factors do not fit keeps the field, and works with conjugate gradients', async ({
  heatwalk,
  page,
}) => {
  const message = page.getByRole('alert');
  await heatwalk.open(`#v=1&m=file&name=${NAME}&memory=1`);
  await heatwalk.drop([[NAME, CONTENT]]);
  await expect(message).toContainText(REFUSED);
  const needed = Number(REFUSED.exec(await message.innerText())?.[1]);

  await heatwalk.openFile(NAME, CONTENT, `s=3&refine=0&memory=${(needed + 0.1).toFixed(1)}`);
  const before = await heatwalk.distanceAt({ vertex: 600 });
  await openSection(page, 'solver');
  await page.getByRole('combobox', { name: 'Boundary' }).selectOption('average');
  await expect(message).toContainText(/Factoring takes .* of memory/);
  expect(await heatwalk.distanceAt({ vertex: 600 })).toBe(before);
  await message.getByRole('button', { name: 'Use conjugate gradients' }).click();
  await expect.poll(async () => (await heatwalk.scene()).parameters.solver).toBe('cg');
  await expect(message).toBeEmpty();
  expect((await heatwalk.scene()).parameters.boundary).toBe('average');
});

test('a mesh that does not fit with so many windows opens with one', async ({ heatwalk }) => {
  // One window of each half-edge of 20 000 triangles takes 6 MiB, eight take 9.
  const message = await refused(
    heatwalk,
    'method=auto&windows=8&memory=7',
    /grid\.off was not opened: 8 windows of each half-edge of 20000 triangles take 9\.\d MiB of memory, more than the 7\.0 MiB there are; keep one window, which fits, or use the native program/,
  );
  await message.getByRole('button', { name: 'Use one window' }).click();
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe(NAME);
  await expect(message).toBeEmpty();
  expect((await heatwalk.scene()).windows).toBe(1);
  expect((await heatwalk.field()).windows).toBe(1);
});

test('a mesh that does not fit is refused before it is built, with its size', async ({ heatwalk, page }) => {
  const message = await refused(
    heatwalk,
    'method=auto&windows=8&memory=5',
    /grid\.off was not opened: a mesh of 20000 triangles takes 5\.\d MiB of memory, more than the 5\.0 MiB there are; use a mesh with fewer triangles, or the native program/,
  );
  await expect(message.getByRole('button', { name: 'Use one window' })).toBeHidden();
  await expect(page.getByRole('button', { name: 'Cancel' })).toBeHidden();
});

test('in the place of a mesh that does not fit, a simplified model is opened, which says that it is one', async ({
  heatwalk,
  page,
}) => {
  // In loose triangles, as many formats have them.
  const { positions, triangles: faces } = sphere(72);
  const corners = faces.flat().map((vertex) => positions[vertex]);
  const loose = faces.map((_, face): [number, number, number] => [3 * face, 3 * face + 1, 3 * face + 2]);
  const [name, content] = ['ball.off', off({ positions: corners, triangles: loose })];
  await heatwalk.open(`#v=1&m=file&name=${name}&s=3&refine=0&method=auto&memory=4`);
  await heatwalk.drop([[name, content]]);
  const message = page.getByRole('alert');
  await expect(message).toContainText(/ball\.off was not opened: a mesh of 20448 triangles takes 6\.\d MiB/);
  await message.getByRole('button', { name: 'Simplify to 13,000 triangles' }).click();
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe(name);
  const told = page.getByText(
    /This is a simplified model of 20,448 triangles; it differs by about [\d.]+ m \(assumed\), 0\.\d+ % of the diagonal\./,
  );
  await expect(page.getByRole('status')).toContainText('This is a simplified model');
  await expect(told.last()).toBeVisible();
  await expect(message).toBeEmpty();
  const { triangles, components, boundaryLoops } = await heatwalk.mesh();
  expect([components, boundaryLoops]).toEqual([1, 0]);
  expect(triangles).toBeLessThanOrEqual(13_000);
  expect(triangles).toBeGreaterThan(12_000);
  // Half way around a ball.
  expect((await heatwalk.field()).maxDistance).toBeCloseTo(Math.PI, 1);
  await expect(page).toHaveURL(/&triangles=13000/);

  // The link opens the same; the browser keeps the file.
  const fragment = new URL(page.url()).hash;
  await heatwalk.kept();
  await heatwalk.open(fragment);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe(name);
  expect((await heatwalk.mesh()).triangles).toBe(triangles);
});
