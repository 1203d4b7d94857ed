/** Lights and orthographic cameras of a glTF file. */
import type { PNG } from 'pngjs';
import { glb, sphere } from '../fixtures';
import { litGlb } from '../lit';
import { expect, openSection, test } from '../page';

/** Mean red and blue of the middle of a column, a share of the width from the left. */
function column({ data, width, height }: PNG, share: number): { red: number; blue: number } {
  let [red, blue, count] = [0, 0, 0];
  for (let y = Math.round(0.45 * height); y < 0.55 * height; y++) {
    const at = 4 * (y * width + Math.round(share * width));
    [red, blue, count] = [red + data[at], blue + data[at + 2], count + 1];
  }
  return { red: red / count, blue: blue / count };
}

test('the lights of a file are off until they are wanted, and in the link', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=file&name=lit.glb&style=none&s=0&w=none&refine=0&cam=0,0,4,0,0,0');
  await heatwalk.dropAndOpen([['lit.glb', litGlb()]]);
  const sides = async () => {
    const picture = await heatwalk.drawing(0.5, false);
    // The ball is almost as high as the picture and in its middle.
    const reach = (0.25 * picture.height) / picture.width;
    return [column(picture, 0.5 - reach), column(picture, 0.5 + reach)];
  };
  const [left, right] = await sides();
  expect(Math.abs(left.blue - right.blue)).toBeLessThan(60);

  await openSection(page, 'display');
  await page.getByLabel('Lights of the file').check();
  await expect(page).toHaveURL(/&lights=file/);
  const [litLeft, litRight] = await sides();
  expect(litRight.red).toBeGreaterThan(2 * litRight.blue);
  expect(litLeft.blue).toBeGreaterThan(2 * litLeft.red);

  // What is seen of an orthographic camera: half its height at the distance of the ball, in bounding radii.
  await page.getByRole('combobox', { name: 'Cameras of the file' }).selectOption('ahead');
  const camera = await page.evaluate(() => window.heatwalk.camera);
  expect(camera?.[2]).toBeCloseTo(4 / Math.tan(0.3), 2);

  await heatwalk.dropAndOpen([['dark.glb', glb(sphere(12))]]);
  await expect(page.getByLabel('Lights of the file')).toBeHidden();
  expect((await heatwalk.scene()).lights).toBe('style');
});
