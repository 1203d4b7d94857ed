/** Every preset style and every overlay, drawn beside the canvas, against reference images. */
import fs from 'node:fs';
import path from 'node:path';
import { PNG } from 'pngjs';
import { BLENDS, STYLES } from '../../web/state/styles';
import { armGlb } from '../animated';
import { grid, type Mesh, obj, sphere } from '../fixtures';
import { glassGlb } from '../lit';
import { expect, type HeatwalkPage, test } from '../page';
import { texturedGlb } from '../textured';

// The longest tests of all come last: one core would wait for the other.
test.describe.configure({ mode: 'parallel' });

const REFERENCES = path.join(import.meta.dirname, '../pictures');
/** Writes the reference images instead of comparing with them. */
const WRITES = process.env['WRITE_REFERENCES'] === '1';

/**
 * The two backends run different compilers over the same shaders, on vectors of another width: contours fall on other
 * samples, so pixels along them differ, and nothing else does. Where a contour is a whole pixel off, a pixel differs by all
 * there is; the share of such pixels is that of the contours.
 */
const CLEARLY = 32;
const CLEARLY_DIFFERENT = 0.006;
const MEAN_DIFFERENCE = 0.6;
/**
 * Small things would drown in those: a pin, a walker, one of a crowd. So no block of pixels may differ much in the mean.
 * Contours turn one or two of its pixels over; a walker of the crowd, the smallest there is, covers more.
 */
const BLOCK = 4;
const BLOCK_DIFFERENCE = 40;

const VIEW = 'cam=-0.5,0.25,2.9,0,0,0';
type Pictures = readonly (readonly [name: string, link: string])[];
const LOOKS: Pictures = STYLES.map(({ name }) => [`look-${name}`, `m=bunny&look=${name}&${VIEW}`]);
const OTHERS: Pictures = [
  ['background', `m=bunny&${VIEW}`],
  ['light-sky', `m=bunny&look=gold&around=sky&${VIEW}`],
  ['light-night', `m=bunny&look=zebra&around=night&light=40&${VIEW}`],
  ['edges', `m=hemisphere&show=scenery,edges,boundary&cam=0.6,0.35,3.4,0,0,0`],
  ['operator', `m=teapot&look=contour&show=operator&cam=0.4,0.4,3,0,0,0`],
  ['arrows-heat', `m=bunny&look=jade&show=heat&${VIEW}`],
  ['arrows-distance', `m=bunny&look=jade&show=distance&${VIEW}`],
  ['heat', `m=bunny&look=citrus&paint=heat&${VIEW}`],
  ['error', `m=bunny&look=scientific&paint=error&${VIEW}`],
  ['crowd', `m=bunny&look=candy&crowd=300&method=exact&${VIEW}`],
  ['cells', `m=bunny&s=746,896,100&w=none&look=zebra&method=exact&show=cells&${VIEW}`],
  ['sides', `m=bunny&s=746&sets=loop:746-896-100&w=none&look=zebra&method=exact&show=curves,loops&${VIEW}`],
  ['images', `m=bunny&w=none&look=candy&method=exact&decal=900,2,20,polar;100,1.5,0,compass&${VIEW}`],
  ['unreachable', `m=teapot&look=porcelain&s=420&cam=0.4,0.4,3,0,0,0`],
  ['ground', `m=hike&w=none&cam=0.5,0.75,2.7,0,0,0`],
  ['walls', `m=village&w=none&slope=1&cam=0.35,0.75,2.7,0,0,0`],
  ['inside-wedge', `m=cave&w=none&cam=0.4,0.4,2.9,0,0,0`],
  ['inside-shells', `m=pipe&w=none&look=citrus&cut=none&spacing=0.1&cam=0.4,0.4,2.9,0,0,0`],
  ['scenery', `m=maze&look=water&cam=0.45,0.9,3,0,0,0`],
];

test.use({ viewport: { width: 480, height: 360 } });

async function show(heatwalk: HeatwalkPage, link: string, clear = true): Promise<PNG> {
  const { page } = heatwalk;
  await page.evaluate((fragment) => {
    location.hash = fragment;
  }, `v=1&${link}`);
  await expect
    .poll(() => page.evaluate(() => window.heatwalk.camera?.[2]))
    .toBe(Number(/cam=[^,]*,[^,]*,([^,]*)/.exec(link)?.[1]));
  return heatwalk.drawing(0.5, clear);
}

/**
 * Share of the pixels that differ clearly in some channel, opacity included, the mean difference of the channels, and the
 * largest difference of a block's mean in some channel.
 */
function compare(a: PNG, b: PNG): { clearly: number; mean: number; block: number } {
  expect([b.width, b.height]).toEqual([a.width, a.height]);
  const { width, height } = a;
  const differences = new Float32Array(4 * width * height);
  let [clearly, sum] = [0, 0];
  for (let i = 0; i < differences.length; i += 4) {
    // Colours of clear pixels mean nothing.
    const weigh = (picture: PNG, channel: number) =>
      channel < 3 ? (picture.data[i + channel] * picture.data[i + 3]) / 255 : picture.data[i + 3];
    const pixel = [0, 1, 2, 3].map((channel) => weigh(a, channel) - weigh(b, channel));
    differences.set(pixel, i);
    const sizes = pixel.map(Math.abs);
    if (Math.max(...sizes) > CLEARLY) clearly += 1;
    for (const size of sizes) sum += size;
  }
  let block = 0;
  for (let y = 0; y + BLOCK <= height; y++) {
    for (let x = 0; x + BLOCK <= width; x++) {
      const means = [0, 0, 0, 0];
      for (let k = 0; k < BLOCK * BLOCK; k++) {
        const i = 4 * ((y + Math.floor(k / BLOCK)) * width + x + (k % BLOCK));
        for (let channel = 0; channel < 4; channel++) means[channel] += differences[i + channel] / BLOCK ** 2;
      }
      block = Math.max(block, ...means.map(Math.abs));
    }
  }
  return { clearly: clearly / (width * height), mean: sum / differences.length, block };
}

for (const [what, pictures] of [
  ['styles look', LOOKS],
  ['overlays, lights and surroundings look', OTHERS],
] as const) {
  test(`${what} like the reference images`, async ({ heatwalk, page }) => {
    test.setTimeout(600_000);
    await page.emulateMedia({ colorScheme: 'light' });
    await heatwalk.open('#v=1&m=teapot&kiosk=1');
    const off: string[] = [];
    for (const [name, link] of pictures) {
      const drawn = await show(heatwalk, link, name !== 'background');
      const file = path.join(REFERENCES, `${name}.png`);
      if (WRITES) fs.writeFileSync(file, PNG.sync.write(drawn));
      const { clearly, mean, block } = compare(drawn, PNG.sync.read(fs.readFileSync(file)));
      if (clearly > CLEARLY_DIFFERENT || mean > MEAN_DIFFERENCE || block > BLOCK_DIFFERENCE) {
        off.push(
          `${name}: ${(100 * clearly).toFixed(2)} % clearly, ${mean.toFixed(2)} in the mean, ${block.toFixed(0)} in a block`,
        );
        fs.writeFileSync(test.info().outputPath(`${name}.png`), PNG.sync.write(drawn));
      }
    }
    expect(off).toEqual([]);
  });
}

test('the materials of a file look like the reference image, stripes over them and multiplied with them', async ({
  heatwalk,
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'light' });
  for (const blend of BLENDS) {
    await heatwalk.open(`#v=1&m=file&name=balls.glb&s=0&look=model&blend=${blend}&stripes=0,0.2,0&${VIEW}&kiosk=1`);
    await heatwalk.dropAndOpen([['balls.glb', texturedGlb()]]);
    expectReference(`materials-${blend}`, await heatwalk.drawing(0.5, false));
  }
});

test('glass looks like the reference image, and so do the lights of a file', async ({ heatwalk, page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  for (const lights of ['style', 'file']) {
    const link = `s=0&w=none&refine=0&look=model&style=none&lights=${lights}&cam=0.7,0.3,3.4,0,0,0`;
    await heatwalk.open(`#v=1&m=file&name=glass.glb&${link}&kiosk=1`);
    await heatwalk.dropAndOpen([['glass.glb', glassGlb()]]);
    expectReference(`glass-${lights}`, await heatwalk.drawing(0.5, false));
  }
});

test('a pose looks like the reference image, with its walker, arrows and edges', async ({ heatwalk, page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  const link = 's=0&w=1&method=auto&clip=0&time=1&look=candy&show=scenery,edges,distance&cam=0.4,0.3,3.4,0,0,0';
  await heatwalk.open(`#v=1&m=file&name=arm.glb&p=0&${link}&kiosk=1`);
  await heatwalk.dropAndOpen([['arm.glb', armGlb()]]);
  // Ambient occlusion follows once the pose has stood for a while.
  await heatwalk.settled();
  await page.waitForTimeout(1000);
  expectReference('pose', await heatwalk.drawing(0.5, false));
});

function expectReference(name: string, drawn: PNG): void {
  const file = path.join(REFERENCES, `${name}.png`);
  if (WRITES) fs.writeFileSync(file, PNG.sync.write(drawn));
  const { clearly, mean, block } = compare(drawn, PNG.sync.read(fs.readFileSync(file)));
  expect(clearly).toBeLessThan(CLEARLY_DIFFERENT);
  expect(mean).toBeLessThan(MEAN_DIFFERENCE);
  expect(block).toBeLessThan(BLOCK_DIFFERENCE);
}

test('an image without background is transparent around the model and opaque on it', async ({ heatwalk }) => {
  await heatwalk.open('#v=1&m=teapot&kiosk=1');
  const picture = await show(heatwalk, `m=bunny&${VIEW}`);
  const alphaAt = (x: number, y: number) => picture.data[4 * (y * picture.width + x) + 3];
  expect([picture.width, picture.height]).toEqual([240, 180]);
  expect(alphaAt(2, 2)).toBe(0);
  expect(alphaAt(120, 100)).toBe(255);
});

/** A sphere that is walked on, over a plate that is scenery, of so many times their size and moved. */
function moved(size: number, shift: readonly number[]): string {
  const place = ({ positions, triangles }: Mesh, lift: number): Mesh => ({
    positions: positions.map(([x, y, z]) => [size * x + shift[0], size * (y + lift) + shift[1], size * z + shift[2]]),
    triangles,
  });
  return obj({ ball: place(sphere(24), 0), plate: place(grid(4), -1.2) });
}

// Sizes and positions are taken off before either backend sees them.
test('a mesh of any size and position looks the same', { tag: '@page' }, async ({ heatwalk, page }) => {
  test.setTimeout(300_000);
  await page.emulateMedia({ colorScheme: 'light' });
  const link =
    'p=0&s=40&w=500&look=zebra&around=studio&light=0&crowd=200&show=scenery,edges,distance&cam=-0.5,0.4,4.1,0,0,0';
  const shown = async (size: number, shift: readonly number[]) => {
    await heatwalk.openFile('moved.obj', moved(size, shift), link);
    await heatwalk.settled();
    const { diameter } = await heatwalk.mesh();
    // The box of the unit sphere; positions on a map keep ten of its digits.
    expect(diameter / size / Math.sqrt(12)).toBeCloseTo(1, 3);
    return heatwalk.drawing(0.5, true);
  };
  const usual = await shown(1, [0, 0, 0]);
  const off: string[] = [];
  const places: [size: number, shift: readonly number[]][] = [
    [1e-30, [0, 0, 0]],
    [1e25, [0, 0, 0]],
    [1e30, [0, 0, 0]],
    [1.3, [500_000, 4_649_776, 100]],
  ];
  for (const [size, shift] of places) {
    const drawn = await shown(size, shift);
    const { clearly, mean } = compare(drawn, usual);
    if (clearly <= CLEARLY_DIFFERENT && mean <= MEAN_DIFFERENCE) continue;
    off.push(`${size} at ${shift.join(', ')}: ${(100 * clearly).toFixed(2)} % clearly, ${mean.toFixed(2)} in the mean`);
    fs.writeFileSync(test.info().outputPath(`size-${size}.png`), PNG.sync.write(drawn));
    fs.writeFileSync(test.info().outputPath('size-1.png'), PNG.sync.write(usual));
  }
  expect(off).toEqual([]);
});
