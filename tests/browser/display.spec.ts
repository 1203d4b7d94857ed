/** The Display section, the turntable, saved images and videos. */
import fs from 'node:fs';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { obj, sphere } from '../fixtures';
import { brightness, expect, type HeatwalkPage, openSection, SEEN, test } from '../page';

test.use(SEEN);

/** Shares of the pixels of the model that are yellow, and blue or violet: the ends of viridis. */
async function endsOfRamp(heatwalk: HeatwalkPage): Promise<[yellow: number, blue: number]> {
  const { data } = await heatwalk.drawing(0.5, true);
  let [all, yellow, blue] = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] !== 255) continue;
    const [r, g, b] = data.subarray(i, i + 3);
    all += 1;
    if (Math.min(r, g) - b > 60 && Math.abs(r - g) < 60) yellow += 1;
    if (b - g > 25) blue += 1;
  }
  return [yellow / all, blue / all];
}

for (const look of ['zebra', 'gold', 'model']) {
  const tag = look === 'zebra' ? [] : '@page';
  test(
    `heat and error have colors that tell their values in the style ${look}`,
    { tag },
    async ({ heatwalk, page }) => {
      const scene = `#m=robot&method=heat&look=${look}&near=0`;
      await heatwalk.open(`${scene}&paint=heat`);
      await heatwalk.settled();
      for (const share of await endsOfRamp(heatwalk)) expect(share).toBeGreaterThan(0.02);
      await heatwalk.open(`${scene}&paint=error`);
      await heatwalk.settled();
      await openSection(page, 'display');
      await expect(page.getByText(/Relative error.*Its colors are those of viridis/)).toBeVisible();
      // Errors are small but at few places, which the start of the ramp shows.
      expect((await endsOfRamp(heatwalk))[1]).toBeGreaterThan(0.3);
    },
  );
}

/** The place of a square of two triangles that is so far from its first corner, in a direction. */
function placeOf(radius: number, angle: number): { face: number; weights: [number, number, number] } {
  const [x, y] = [radius * Math.cos(angle), radius * Math.sin(angle)];
  return y < x ? { face: 0, weights: [1 - x, x - y, y] } : { face: 1, weights: [1 - y, x, y - x] };
}

test('stripes on large triangles are where the distance is', { tag: '@page' }, async ({ heatwalk, page }) => {
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n';
  const scene = 'up=y&s=0&w=none&cam=0,0,3.5,0,0,0&look=zebra&period=0.08';
  await heatwalk.openFile('square.obj', square, scene);
  await heatwalk.settled();
  const period = 0.08 * Math.SQRT2;
  const pictured = async (phase: number) => {
    const picture = await heatwalk.picture();
    const values = [];
    for (let degrees = 6; degrees < 90; degrees += 6) {
      const place = placeOf(phase * period, (degrees * Math.PI) / 180);
      expect(await page.evaluate((at) => window.heatwalk.exactDistanceAt(at), place)).toBeCloseTo(phase * period, 6);
      const pixel = await heatwalk.pixelOf(place);
      values.push(brightness(picture, ...pixel));
      // Under the pointer is the triangle of the file.
      const met = await page.evaluate(([x, y]) => window.heatwalk.placeAt(x, y), pixel);
      const { face, weights } = met as typeof place;
      expect(face).toBe(place.face);
      weights.forEach((weight, k) => expect(weight).toBeCloseTo(place.weights[k], 1));
    }
    return values;
  };
  expect(Math.max(...(await pictured(6.5)))).toBeLessThan(0.2);
  expect(Math.min(...(await pictured(7)))).toBeGreaterThan(0.5);
});

test(
  'overlays are switched on and off, and one gradient replaces the other',
  { tag: '@page' },
  async ({ heatwalk, page }) => {
    await heatwalk.open('#v=1&m=hemisphere');
    await openSection(page, 'display');
    await page.getByLabel('Mesh edges').check();
    await page.getByLabel('Heat gradient').check();
    await page.getByLabel('Distance gradient').check();
    expect((await heatwalk.scene()).overlays).toEqual(['scenery', 'edges', 'distance']);
    await expect(page.getByRole('group', { name: 'Arrows' }).getByRole('radio', { checked: true })).toHaveCount(1);
    await page.getByLabel('Inactive parts (scenery)').uncheck();
    expect((await heatwalk.scene()).overlays).toEqual(['edges', 'distance']);
    // Of a model of one part it changes nothing, and comes back all the same.
    await heatwalk.open('#v=1&m=icosphere&open=look');
    await expect(page.getByText('All parts are active.')).toBeVisible();
    await page.getByLabel('Inactive parts (scenery)').uncheck();
    expect((await heatwalk.scene()).overlays).toEqual([]);
    await page.getByLabel('Inactive parts (scenery)').check();
    expect((await heatwalk.scene()).overlays).toEqual(['scenery']);
    await expect(page.locator('.message.error')).toHaveCount(0);
  },
);

/** Indices of the pixels that the scene covers. */
async function covered(heatwalk: HeatwalkPage): Promise<number[]> {
  const { data, width, height } = await heatwalk.drawing(0.5, true);
  return Array.from({ length: width * height }, (_, i) => i).filter((i) => data[4 * i + 3] === 255);
}

/** Of a sphere of 16 rings, the vertex farthest along x. */
const EAST = 225;

test(
  'an inactive part is hidden and shown again, and the link stores it',
  { tag: '@page' },
  async ({ heatwalk, page }) => {
    // From above the equator the moon hangs to the right of the earth and touches it nowhere.
    const file = obj({ earth: sphere(16), moon: sphere(16, [3, 0, 0]) });
    await heatwalk.openFile('planets.obj', file, 'p=0&s=0&w=none&refine=0&cam=0,0,8,0,0,0');
    const [[centre], [edge]] = [await heatwalk.pixelOf({ vertex: 0 }), await heatwalk.pixelOf({ vertex: EAST })];
    const { width } = await heatwalk.drawing(0.5, true);
    const isRight = (pixel: number) => pixel % width > (width + edge - centre) / 2 + 4;
    const whole = await covered(heatwalk);
    const moon = whole.filter(isRight);
    const earth = whole.filter((pixel) => !isRight(pixel));
    expect(moon.length).toBeGreaterThan(1000);
    expect(earth.length).toBeGreaterThan(1000);
    await page.getByRole('button', { name: 'Hide moon' }).click();
    expect(await covered(heatwalk)).toEqual(earth);
    expect((await heatwalk.scene()).hidden).toEqual([1]);
    await expect.poll(() => page.url()).toContain('hide=1');
    await page.getByRole('button', { name: 'Show moon' }).click();
    expect(await covered(heatwalk)).toEqual(whole);
  },
);

test('the error is shown once it is known', { tag: '@page' }, async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&refine=0');
  await openSection(page, 'display');
  await page.getByLabel('Color by').selectOption('unrefined error');
  await expect(
    page.getByText(/^The error is known once all distances are exact: switch "Refine to exact" on/),
  ).toBeVisible();
  await heatwalk.open('#v=1&m=bunny&paint=error');
  await openSection(page, 'display');
  await heatwalk.settled();
  await expect(page.getByText(/Relative error: mean [\d.]+ %/)).toBeVisible();
});

test('a crowd walks, and stands still while paused', { tag: '@page' }, async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await heatwalk.open('#v=1&m=bunny&w=none&crowd=300');
  await heatwalk.settled();
  const picture = () =>
    page.evaluate(async () => {
      const bytes = new Uint8Array(await (await window.heatwalk.picture(0.5)).arrayBuffer());
      return Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
    });
  const before = await picture();
  await expect.poll(async () => (await picture()) === before).toBe(false);
  await page.keyboard.press('p');
  await expect
    .poll(async () => {
      const one = await picture();
      return (await picture()) === one;
    })
    .toBe(true);
});

test('the turntable rotates the model until it is stopped', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  const yaw = () => page.evaluate(() => window.heatwalk.camera?.[0] ?? 0);
  const before = await yaw();
  await page.getByRole('button', { name: 'Turntable' }).click();
  await expect.poll(yaw).not.toBe(before);
  await page.keyboard.press('t');
  await heatwalk.rest();
  const after = await yaw();
  await expect.poll(async () => (await heatwalk.scene()).camera?.[0]).toBe(after);
});

test('an image of twice the size of the window is saved', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  await heatwalk.settled();
  await openSection(page, 'share');
  const saving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save image' }).click();
  const download = await saving;
  expect(download.suggestedFilename()).toBe('bunny.png');
  const picture = PNG.sync.read(fs.readFileSync(await download.path()));
  const pixels = await page.evaluate(() => [innerWidth, innerHeight].map((length) => length * devicePixelRatio));
  expect([picture.width, picture.height]).toEqual(pixels.map((length) => 2 * length));
});

/** What the browser decodes of a video at shares of its length. */
async function frames(page: Page, file: Buffer, shares: readonly number[]): Promise<{ seconds: number; seen: PNG[] }> {
  const { seconds, pictures } = await page.evaluate(
    async ([base64, places]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const video = document.createElement('video');
      const told = (event: 'loadeddata' | 'seeked') =>
        new Promise((resolve, reject) => {
          video.addEventListener(event, resolve, { once: true });
          video.addEventListener('error', () => reject(new Error(video.error?.message)), { once: true });
        });
      const loaded = told('loadeddata');
      video.src = URL.createObjectURL(new Blob([bytes]));
      await loaded;
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
      const context = canvas.getContext('2d', { willReadFrequently: true });
      if (!context) throw new Error('no canvas to draw on');
      const seen: string[] = [];
      for (const share of places) {
        const sought = told('seeked');
        video.currentTime = share * video.duration;
        await sought;
        // The frame is handed over a little later; until then nothing is drawn.
        do {
          await new Promise(requestAnimationFrame);
          context.drawImage(video, 0, 0);
        } while (context.getImageData(0, 0, 1, 1).data[3] === 0);
        seen.push(canvas.toDataURL().replace(/^[^,]*,/, ''));
      }
      return { seconds: video.duration, pictures: seen };
    },
    [file.toString('base64'), shares] as const,
  );
  return { seconds, seen: pictures.map((base64) => PNG.sync.read(Buffer.from(base64, 'base64'))) };
}

/** Mean difference of the channels, 0 to 255, over the pixels within `reach` of a place; without one over all. */
function meanDifference(a: PNG, b: PNG, place?: readonly [number, number], reach = 16): number {
  expect([b.width, b.height]).toEqual([a.width, a.height]);
  let [sum, count] = [0, 0];
  for (let i = 0; i < a.data.length; i++) {
    const [x, y] = [(i >> 2) % a.width, Math.floor((i >> 2) / a.width)];
    if (place && Math.max(Math.abs(x - place[0]), Math.abs(y - place[1])) > reach) continue;
    sum += Math.abs(a.data[i] - b.data[i]);
    count += 1;
  }
  return sum / count;
}

for (const [subject, tag] of [
  ['Turntable', '@drawn'],
  ['The walk', '@page'],
] as const) {
  test(`a video is saved: ${subject}`, { tag: [tag, '@slow'] }, async ({ heatwalk, page }) => {
    await page.setViewportSize({ width: 760, height: 420 });
    // Motion is unwelcome, but the user asked for the video, so it moves all the same.
    await heatwalk.open('#v=1&m=teapot');
    await heatwalk.settled();
    const { walker } = await heatwalk.scene();
    if (!walker) throw new Error('nobody walks');
    // Videos are centered on the model, as pictures for scripts are.
    const [[x, y], [x0, y0]] = [await heatwalk.pixelOf(walker), await page.evaluate(() => window.heatwalk.centre)];
    const start = [x + 760 / 2 - x0, y + 420 / 2 - y0] as const;
    await page.keyboard.press('l');
    const still = await heatwalk.drawing(1, false);
    await openSection(page, 'share');
    await page.getByLabel('Video').selectOption(subject);
    test.slow();
    const saving = page.waitForEvent('download', { timeout: 240_000 });
    await page.getByRole('button', { name: 'Save video' }).click();
    const download = await saving;
    expect(download.suggestedFilename()).toMatch(/^teapot\.(mp4|webm)$/);
    const { seconds, seen } = await frames(page, fs.readFileSync(await download.path()), [0.5, 0.98]);
    const [half, last] = seen;
    if (subject === 'Turntable') expect(seconds).toBeCloseTo(8, 2);
    await expect(page.getByText(`Saved: ${seconds.toFixed(1)} s, 30 frames a second.`)).toBeVisible();
    // Nothing but what was asked for moves; compression alone makes a difference of 0.8.
    const [low, high] = subject === 'Turntable' ? [2, 10] : [0, 1.5];
    for (const frame of [half, last]) {
      expect(meanDifference(still, frame)).toBeGreaterThan(low);
      expect(meanDifference(still, frame)).toBeLessThan(high);
      // Neither the walker nor what it stands on is where it was.
      expect(meanDifference(still, frame, start)).toBeGreaterThan(6);
    }
  });
}

test('a video is cancelled, and what moves goes on by the clock', { tag: '@page' }, async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=teapot');
  await heatwalk.settled();
  const before = await page.evaluate(() => window.heatwalk.camera);
  await openSection(page, 'share');
  await page.getByRole('button', { name: 'Save video' }).click();
  await expect.poll(() => page.evaluate(() => window.heatwalk.camera)).not.toEqual(before);
  await page.getByRole('button', { name: 'Cancel', exact: true }).click();
  await expect(page.getByText('Cancelled.')).toBeVisible();
  expect(await page.evaluate(() => window.heatwalk.camera)).toEqual(before);
  await expect(page.getByRole('button', { name: 'Save video' })).toBeVisible();
  // Nothing of it is in the scene, and the turntable turns.
  expect((await heatwalk.scene()).camera).toBeNull();
  await page.keyboard.press('t');
  await expect.poll(() => page.evaluate(() => window.heatwalk.camera?.[0])).not.toBe(before?.[0]);
});

test('labels of tapes and the legend are in videos', { tag: ['@page', '@slow'] }, async ({ heatwalk, page }) => {
  await page.setViewportSize({ width: 760, height: 420 });
  await heatwalk.open('#m=torus&method=auto&tape=7264,2998');
  await heatwalk.settled();
  const label = page.locator('.tape-label').first();
  await expect(label).toHaveText(/\d/);
  const box = await label.boundingBox();
  if (!box) throw new Error('the tape has no label');
  const centre = await page.evaluate(() => window.heatwalk.centre);
  const still = await heatwalk.drawing(1, false);
  await openSection(page, 'share');
  await page.getByLabel('Video').selectOption('The walk');
  test.slow();
  const saving = page.waitForEvent('download', { timeout: 240_000 });
  await page.getByRole('button', { name: 'Save video' }).click();
  // Pictures for scripts have the label and no legend.
  const { seen } = await frames(page, fs.readFileSync(await (await saving).path()), [0.98]);
  const shift = [760 / 2 - centre[0], 420 / 2 - centre[1]];
  const at = [box.x + box.width / 2 + shift[0], box.y + box.height / 2 + shift[1]] as const;
  expect(meanDifference(still, seen[0], at, 6)).toBeLessThan(8);
  expect(meanDifference(still, seen[0], [40, 60], 24)).toBeGreaterThan(8);
  await page.evaluate(() => (location.hash = '#m=torus&method=auto'));
  await expect(label).toHaveCount(0);
  await heatwalk.settled();
  expect(meanDifference(await heatwalk.drawing(1, false), seen[0], at, 6)).toBeGreaterThan(20);
});
