/** Files are shown in their own materials. */
import type { PNG } from 'pngjs';
import { glb, off, sphere } from '../fixtures';
import { difference, expect, openSection, test } from '../page';
import { basisSquares, texturedGlb, texturedObj } from '../textured';

test('a file with materials opens in them, one without as before', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await openSection(page, 'style');
  const surface = page.getByRole('combobox', { name: 'Surface' });
  const ofFile = surface.getByRole('option', { name: "the file's materials" });
  await heatwalk.dropAndOpen([['plain.glb', glb(sphere(12))]]);
  expect((await heatwalk.scene()).style.name).toBe('zebra');
  await expect(ofFile).toBeDisabled();

  await heatwalk.dropAndOpen([['balls.glb', texturedGlb()]]);
  expect((await heatwalk.scene()).style).toMatchObject({ name: 'model', surfaceOf: 'file', blend: 'contrast' });
  await expect(surface).toHaveValue("the file's materials");
  await expect(page).toHaveURL(/&look=model/);
  expect((await heatwalk.mesh()).parts).toEqual(['squares', 'colors']);

  // Red squares, seen in the file's materials alone.
  const redTexels = async () => reds(await heatwalk.drawing(0.5, false));
  expect(await redTexels()).toBeGreaterThan(2000);
  await surface.selectOption('porcelain');
  await heatwalk.rest();
  expect(await redTexels()).toBeLessThan(200);
  await expect(page).toHaveURL(/&of=style/);
  await expect(page.getByRole('combobox', { name: 'Stripes lie' })).toBeHidden();
  await surface.selectOption("the file's materials");
  await expect(surface).toHaveValue("the file's materials");
  expect(await redTexels()).toBeGreaterThan(2000);
});

function reds({ data }: PNG): number {
  return data.filter((red, i) => i % 4 === 0 && red > 2 * data[i + 1] && red > 2 * data[i + 2]).length;
}

test('an OBJ file is shown in the materials of its library, and what it misses is named', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  const opened = async (statements: string) => {
    await heatwalk.dropAndOpen(texturedObj(statements));
    expect((await heatwalk.scene()).style.name).toBe('model');
    return heatwalk.drawing(0.5, false);
  };
  const plain = await opened('');
  const status = page.getByRole('status');
  await expect(status).not.toContainText('not given');
  expect(reds(plain)).toBeGreaterThan(2000);
  // The vertices are those of the file, though the drawing has more of them.
  expect((await heatwalk.mesh()).vertices).toBe(2 + 23 * 48);

  const holes = await opened('map_d halves.png');
  expect(reds(holes)).toBeLessThan(0.7 * reds(plain));
  const bumpy = await opened('bump waves.png');
  expect(difference(plain, bumpy)).toBeGreaterThan(0.01);
  await heatwalk.dropAndOpen(texturedObj('map_Ke gone.png'));
  await expect(status).toContainText('ball.obj refers to gone.png, which was not given.');
  await heatwalk.dropAndOpen(texturedObj('map_Ke ball.mtl'));
  await expect(status).toContainText('The browser cannot show ball.mtl.');
});

test('stripes lie over the materials, are multiplied with them, or are left out', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await heatwalk.dropAndOpen([['balls.glb', texturedGlb()]]);
  await openSection(page, 'style');
  await page.getByRole('combobox', { name: 'Stripes', exact: true }).selectOption('gold');
  const contrasting = await heatwalk.drawing(0.5, false);
  await page.getByRole('combobox', { name: 'Stripes lie' }).selectOption('over the materials');
  await expect(page).toHaveURL(/&blend=over/);
  const gold = await heatwalk.drawing(0.5, false);
  expect(difference(contrasting, gold)).toBeGreaterThan(0.02);
  await page.getByRole('combobox', { name: 'Stripes lie' }).selectOption('multiplied with them');
  await expect(page).toHaveURL(/&blend=multiply/);
  const multiplied = await heatwalk.drawing(0.5, false);
  expect(difference(gold, multiplied)).toBeGreaterThan(0.02);
  await page.getByRole('combobox', { name: 'Pattern' }).selectOption('none');
  await expect(page).toHaveURL(/&style=none/);
  await expect(page.getByRole('slider', { name: 'Period' })).toBeHidden();
  const bare = await heatwalk.drawing(0.5, false);
  expect(difference(bare, multiplied)).toBeGreaterThan(0.02);
  await page.getByRole('combobox', { name: 'Pattern' }).selectOption('lines');
  expect(difference(bare, await heatwalk.drawing(0.5, false))).toBeGreaterThan(0.005);
});

test('Basis Universal images are decoded by a module that no other file loads', async ({ heatwalk, page }) => {
  const modules: string[] = [];
  page.context().on('request', (request) => modules.push(...(/heatwalk_basis.*wasm/.exec(request.url()) ?? [])));
  await heatwalk.open();
  const opened = (texture: Buffer) => heatwalk.dropAndOpen([['balls.glb', texturedGlb(texture, 'KHR_texture_basisu')]]);
  await heatwalk.dropAndOpen([['balls.glb', texturedGlb()]]);
  const asPng = await heatwalk.drawing(0.5, false);
  expect(modules).toHaveLength(0);
  for (const kind of ['etc1s', 'uastc-zstd'] as const) {
    await opened(basisSquares(kind));
    const picture = await heatwalk.drawing(0.5, false);
    expect(Math.abs(reds(picture) / reds(asPng) - 1)).toBeLessThan(0.05);
    expect(difference(asPng, picture)).toBeLessThan(0.02);
  }
  expect(modules.length).toBeGreaterThan(0);

  await opened(basisSquares('etc1s').subarray(0, 300));
  await expect(page.getByRole('status')).toContainText('The browser cannot show squares.');
  await expect(page.getByRole('alert')).toBeEmpty();
  expect(reds(await heatwalk.drawing(0.5, false))).toBeLessThan(200);
});

test('an image that cannot be decoded is left out, the rest is shown', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await heatwalk.dropAndOpen([['balls.glb', texturedGlb(Buffer.from('no image'))]]);
  await expect(page.getByRole('alert')).toBeEmpty();
  await expect(page.getByRole('status')).toContainText('The browser cannot show squares.');
  expect((await heatwalk.scene()).style.name).toBe('model');
  const { data, width, height } = await heatwalk.drawing(0.5, false);
  const middle = 4 * (Math.round(height / 2) * width + Math.round(width / 2));
  expect(data[middle + 3]).toBe(255);
  // The next file has none of its materials.
  await heatwalk.dropAndOpen([['plain.off', off(sphere(12))]]);
  expect((await heatwalk.scene()).style.name).toBe('zebra');
});
