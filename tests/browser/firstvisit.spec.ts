/** What somebody does at first with the page, from the first picture to a link that shows the same, with a picture of each step. */
import { readFile, writeFile } from 'node:fs/promises';
import { PNG } from 'pngjs';
import { crossings, difference, expect, type HeatwalkPage, openSection, test } from '../page';
import { grid, off, sphere } from '../fixtures';

test.use({ deviceScaleFactor: 0.5 });

/** Of the pixels: a picture that is the same but for noise of compilers, and one that has changed. */
const [SAME, CHANGED] = [0.002, 0.01];
const BALL = off(sphere(24));

test('a first visit: hints, a dropped mesh, sources, the walker, undo, a link, a picture, a mesh that is none', async ({
  context,
  heatwalk,
  page,
}, info) => {
  test.slow();
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const look = async (step: string) => {
    await heatwalk.settled();
    const picture = await heatwalk.drawing(1, false);
    await writeFile(info.outputPath(`${step}.png`), PNG.sync.write(picture));
    return picture;
  };
  const hint = page.locator('.hint');

  await heatwalk.open();
  const first = await look('first picture');
  const [x, y] = await heatwalk.pixelOnModel(0.04);
  expect(crossings(await heatwalk.picture(), x, y - 150, y + 150)).toBeGreaterThanOrEqual(6);
  await expect(hint).toContainText('Click the surface');

  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  const dropped = await look('dropped mesh');
  expect(difference(first, dropped)).toBeGreaterThan(CHANGED);

  await page.mouse.click(...(await heatwalk.pixelOnModel(-0.05, -0.05)));
  await expect(hint).toContainText('Drag the pin');
  const clicked = await look('source by a click');
  expect(difference(dropped, clicked)).toBeGreaterThan(CHANGED);

  await dragPin(heatwalk, 40, 25);
  await expect(hint).toContainText('sends the walker');
  const dragged = await look('pin dragged');
  expect(difference(clicked, dragged)).toBeGreaterThan(CHANGED);

  await page.keyboard.down('Alt');
  await page.mouse.click(...(await heatwalk.pixelOnModel(0.06, 0.08)));
  await page.keyboard.up('Alt');
  await expect(hint).toBeHidden();
  await page.keyboard.down('Control');
  await page.mouse.click(...(await heatwalk.pixelOnModel(0.08, -0.06)));
  await page.keyboard.up('Control');
  const two = await look('walker and a second source');
  expect((await heatwalk.scene()).sources).toHaveLength(2);
  await page.keyboard.press('Control+z');
  expect((await heatwalk.scene()).sources).toHaveLength(1);
  expect(difference(two, await look('undone'))).toBeGreaterThan(CHANGED);
  await page.keyboard.press('Control+Shift+z');
  expect(difference(two, await look('redone'))).toBeLessThan(SAME);

  // What is no mesh loses nothing.
  await heatwalk.drop([['notes.doc', 'no mesh']]);
  await expect(page.getByText('No mesh found in notes.doc')).toBeVisible();
  await page.getByRole('button', { name: 'Close the message' }).first().click();
  expect(difference(two, await look('after a file that is none'))).toBeLessThan(SAME);

  // The link of a file that is not kept asks for it, and shows the same once it has it.
  await openSection(page, 'share');
  await page.getByRole('button', { name: 'Copy link' }).click();
  const link = new URL(await page.evaluate(() => navigator.clipboard.readText()));
  const saving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save image' }).click();
  const saved = PNG.sync.read(await readFile(await (await saving).path()));
  // Twice the pixels of the device, which has one for two of the window here.
  expect([saved.width, saved.height]).toEqual([two.width, two.height]);
  await heatwalk.forgetFiles();
  await heatwalk.open(link.hash);
  await expect(page.getByText('This link needs your file ball.off.')).toBeVisible();
  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  await heatwalk.settled();
  expect(difference(two, await look('from the link'))).toBeLessThan(SAME);

  await heatwalk.dropAndOpen([['flat.off', off(grid(12))]]);
  expect((await heatwalk.mesh()).boundaryLoops).toBe(1);
});

async function dragPin(heatwalk: HeatwalkPage, dx: number, dy: number): Promise<void> {
  const { mouse } = heatwalk.page;
  const [x, y] = await heatwalk.pixelOf((await heatwalk.scene()).sources[0]);
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + dx, y + dy, { steps: 4 });
  await mouse.up();
}
