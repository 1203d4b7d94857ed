/** Lights and orthographic cameras of a glTF file. */
import type { PNG } from 'pngjs';
import { glb, type Mesh, sphere } from '../fixtures';
import { GlbWriter } from '../glb';
import { expect, test } from '../page';

/** A ball, a red lamp to its right, a blue spot to its left that shines on it, and a camera that sees all of 8 along y from +z. */
function litGlb({ positions, triangles }: Mesh): Buffer {
  const writer = new GlbWriter();
  const attributes = {
    POSITION: writer.accessor(Float32Array.from(positions.flat()), 'VEC3', { min: [-1, -1, -1], max: [1, 1, 1] }),
  };
  const indices = writer.accessor(Uint32Array.from(triangles.flat()), 'SCALAR');
  const light = (number: number) => ({ extensions: { KHR_lights_punctual: { light: number } } });
  const turn = Math.SQRT1_2;
  return writer.pack({
    extensionsUsed: ['KHR_lights_punctual'],
    extensions: {
      KHR_lights_punctual: {
        lights: [
          { type: 'point', color: [1, 0, 0], intensity: 4 },
          { type: 'spot', color: [0, 0, 1], intensity: 4 },
        ],
      },
    },
    cameras: [{ type: 'orthographic', orthographic: { xmag: 4, ymag: 4, znear: 0.1, zfar: 20 } }],
    nodes: [
      { mesh: 0, name: 'ball' },
      { translation: [3, 0, 0], ...light(0) },
      { translation: [-3, 0, 0], rotation: [0, -turn, 0, turn], ...light(1) },
      { name: 'ahead', camera: 0, translation: [0, 0, 9] },
    ],
    meshes: [{ primitives: [{ attributes, indices }] }],
  });
}

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
  await heatwalk.dropAndOpen([['lit.glb', litGlb(sphere(24))]]);
  const sides = async () => {
    const picture = await heatwalk.drawing(0.5, false);
    // The ball is almost as high as the picture and in its middle.
    const reach = (0.25 * picture.height) / picture.width;
    return [column(picture, 0.5 - reach), column(picture, 0.5 + reach)];
  };
  const [left, right] = await sides();
  expect(Math.abs(left.blue - right.blue)).toBeLessThan(60);

  await page.locator('#section-display > summary').click();
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
