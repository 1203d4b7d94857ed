import { readFile } from 'node:fs/promises';
import { expect, openSection, test } from '../page';

/** Radii of the torus around Y. */
const [RING, TUBE] = [1, 0.4];

test('a plane is moved by hand, and the girth follows it into the panel, files, links and undo', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.withoutLegend();
  await heatwalk.open('#m=torus&cam=0,0.3,4,0,0,0&unit=cm');
  await heatwalk.settled();
  await heatwalk.closeSummary();
  const section = await openSection(page, 'girth');
  await section.getByText('Measure the girth').click();
  await heatwalk.settled();
  const label = page.locator('.girth-label');
  const length = async () => Number.parseFloat((await label.textContent()) ?? '');
  // Of two circles, the outer one.
  await expect(label).toHaveText(/^8\.\d+ cm$/);
  expect(Math.abs((await length()) / (2 * Math.PI * (RING + TUBE)) - 1)).toBeLessThan(0.005);
  await expect(section.locator('.girth-figures')).toHaveText(/^Girth: 8\.\d+ cm\. 2 curves, 12\.\d cm in all;/);
  await expect(page.locator('.unseen[aria-live]', { hasText: /^Girth: 8/ })).toHaveCount(1);
  await expect.poll(() => page.url()).toContain('&girth=0,90,0');

  // Up by hand: the tube is narrower there.
  const handle = page.getByRole('slider', { name: 'Position of the girth' });
  const { x = 0, y = 0 } = (await handle.boundingBox()) ?? {};
  await page.mouse.move(x + 16, y + 16);
  await page.mouse.down();
  await page.mouse.move(x + 16, y - 24, { steps: 4 });
  await page.mouse.up();
  await expect.poll(length).toBeLessThan(2 * Math.PI * (RING + TUBE) * 0.99);
  const placed = () => page.evaluate(() => window.heatwalk.scene.girth?.place ?? NaN);
  const off = async () => {
    const half = Math.sqrt(TUBE ** 2 - ((await placed()) * TUBE) ** 2);
    return Math.abs((await length()) / (2 * Math.PI * (RING + half)) - 1);
  };
  await expect.poll(off).toBeLessThan(0.01);
  const place = await placed();
  await handle.press('ArrowUp');
  await expect.poll(() => page.evaluate(() => window.heatwalk.scene.girth?.place)).toBeCloseTo(place + 0.02, 6);

  // Upright, the plane cuts the tube twice.
  await section.getByRole('slider', { name: 'Position', exact: true }).fill('0');
  await section.getByRole('slider', { name: 'Tilt', exact: true }).fill('0');
  await expect(label).toHaveText(/^2\.5\d? cm$/);
  const downloading = page.waitForEvent('download');
  await section.getByRole('button', { name: 'Save girth' }).click();
  const download = await downloading;
  expect(download.suggestedFilename()).toBe('torus.girth.dxf');
  const dxf = (await readFile(await download.path())).toString();
  expect(dxf).toMatch(/\$INSUNITS\n\s*70\n4\n/);
  expect(dxf).toMatch(/\n\s*8\nGIRTH\n/);
  const places = [...dxf.matchAll(/VERTEX\n\s*8\n.*\n\s*10\n(.*)\n\s*20\n(.*)\n\s*30\n(.*)\n/g)];
  const circles = places.map((match) => match.slice(1, 4).map(Number));
  expect(circles.length).toBeGreaterThan(40);
  for (const [right, up, front] of circles) {
    expect(Math.abs(front)).toBeLessThan(1e-6);
    expect(Math.abs(Math.hypot(Math.abs(right) - 10 * RING, up) / (10 * TUBE) - 1)).toBeLessThan(0.02);
  }

  await page.keyboard.press('Control+z');
  await expect.poll(() => page.evaluate(() => window.heatwalk.scene.girth?.tilt)).toBe(90);
  // A link has it, and off is off.
  await heatwalk.open('#m=torus&girth=0,0,0&kiosk=1');
  await expect(label).toHaveText(/^2\.5/);
  // The label of a tape there does not lie on that of the girth.
  const tape = await page.evaluate(() => {
    const { left, top } = document.querySelector('.girth-label')?.getBoundingClientRect() ?? new DOMRect();
    const ends = [-6, 6].map((down) => window.heatwalk.placeAt(left - 6, top + down));
    return ends.map((point) => point && 'face' in point && `${point.face}:${point.weights.join('/')}`).join();
  });
  await page.evaluate((wanted) => (location.hash += `&tape=${wanted}`), tape);
  await expect(page.locator('.label > span:visible')).toHaveCount(2);
  const [one, other] = await page
    .locator('.label > span')
    .evaluateAll((all) => all.map((span) => span.getBoundingClientRect()));
  const apart =
    one.right <= other.left || other.right <= one.left || one.bottom <= other.top || other.bottom <= one.top;
  expect(apart).toBe(true);
  await heatwalk.open('#m=torus&girth=0,0,0');
  await openSection(page, 'girth');
  await section.getByText('Measure the girth').click();
  await expect(label).toBeHidden();
  await expect.poll(() => page.url()).not.toContain('girth');
});
