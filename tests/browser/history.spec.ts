/** What the browser keeps: an entry of its history for each opening and comparison, and the user's own files. */
import { once } from 'node:events';
import type { Page } from '@playwright/test';
import { violations } from '../axe';
import { off, sphere } from '../fixtures';
import { expect, test } from '../page';

const BALL = off(sphere(8));
const EGG_NAME = 'an-egg-with-a-name-longer-than-the-menu-is-wide.off';
const EGG = off(sphere(10, [0, 1, 0]));

const meshName = (page: Page) => expect.poll(() => page.evaluate(() => window.heatwalk.mesh?.name));
const compared = (page: Page) => expect.poll(() => page.evaluate(() => window.heatwalk.scene.compared !== null));
const sources = (page: Page) => expect.poll(() => page.evaluate(() => window.heatwalk.scene.sources));

test('presets, files and comparisons are entries of the history, edits are none, and back and forward restore them', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#m=icosphere');
  await page.evaluate(() => window.heatwalk.setSources([{ vertex: 5 }]));
  await expect(page).toHaveURL(/m=icosphere&s=5\b/);

  await page.evaluate(() => window.heatwalk.open({ preset: 'torus' }));
  await expect(page).toHaveURL(/m=torus/);
  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  await expect(page).toHaveURL(/m=file&name=ball\.off&hash=[\da-f]{64}/);
  await page.evaluate(() => window.heatwalk.setSources([{ vertex: 7 }]));
  await page.evaluate(() => window.heatwalk.set({ vs: 't:1000,at:0.5' }));
  await expect(page).toHaveURL(/vs=/);

  // The comparison ends at once: nothing is opened anew for that.
  await page.locator('.message.summary').evaluateAll((all) => all.forEach((message) => message.remove()));
  await page.goBack();
  await compared(page).toBe(false);
  await sources(page).toEqual([{ vertex: 7 }]);
  await expect(page.locator('.message.summary')).toHaveCount(0);
  expect(await page.evaluate(() => window.heatwalk.mesh?.name)).toBe('ball.off');
  await page.goForward();
  await compared(page).toBe(true);
  await page.goBack();
  await compared(page).toBe(false);
  await page.goBack();
  await meshName(page).toBe('torus');
  await page.goBack();
  await meshName(page).toBe('icosphere');
  // As it was left.
  await sources(page).toEqual([{ vertex: 5 }]);
  await expect(page).toHaveURL(/m=icosphere&s=5\b/);
  // A file comes back without a question, with what was set on it.
  await page.goForward();
  await meshName(page).toBe('torus');
  await page.goForward();
  await meshName(page).toBe('ball.off');
  await sources(page).toEqual([{ vertex: 7 }]);
  await expect(page.getByText('This link needs your file')).toBeHidden();
  await heatwalk.settled();

  // Two steps at once end where the second one leads, and the address is its own.
  await page.evaluate(() => {
    history.back();
    history.back();
  });
  await meshName(page).toBe('icosphere');
  await heatwalk.settled();
  await expect(page).toHaveURL(/m=icosphere&s=5\b/);
  // Another scene from here takes the place of what was ahead.
  await page.evaluate(() => window.heatwalk.open({ preset: 'teapot' }));
  await expect(page).toHaveURL(/m=teapot/);
  await page.goForward();
  expect(await page.evaluate(() => window.heatwalk.mesh?.name)).toBe('teapot');
  // A link that is pasted is an entry of its own, as ever.
  await page.evaluate(() => (location.hash = '#m=torus&s=12'));
  await sources(page).toEqual([{ vertex: 12 }]);
  // The same mesh once more takes nothing away.
  await page.evaluate(() => window.heatwalk.open({ preset: 'torus' }));
  await sources(page).not.toEqual([{ vertex: 12 }]);
  await page.goBack();
  await sources(page).toEqual([{ vertex: 12 }]);
  await page.goBack();
  await meshName(page).toBe('teapot');
  await page.goBack();
  await meshName(page).toBe('icosphere');
});

test('a reload brings one’s own file back; recent files are opened again and erased', async ({ heatwalk, page }) => {
  await heatwalk.open('#m=icosphere');
  const menu = page.getByRole('dialog', { name: 'Open' });
  const openMenu = () => page.getByRole('button', { name: 'Open', exact: true }).click();
  const recent = menu.getByRole('region', { name: 'Recent' });
  await openMenu();
  await expect(menu).toBeVisible();
  await expect(recent).toBeHidden();
  await page.keyboard.press('Escape');

  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  await heatwalk.dropAndOpen([[EGG_NAME, EGG]]);
  await page.evaluate(() => window.heatwalk.setSources([{ vertex: 9 }]));
  await expect(page).toHaveURL(/name=an-egg[\w.-]+&hash=[\da-f]{64}.*s=9\b/);
  await openMenu();
  await expect(recent.getByRole('listitem')).toHaveText([`${EGG_NAME}×`, /^ball\.off/]);
  const room = (await menu.boundingBox()) ?? { x: 0, width: 0 };
  const erase = await recent.getByRole('button', { name: `Erase ${EGG_NAME}` }).boundingBox();
  expect((erase?.x ?? Infinity) + (erase?.width ?? 0)).toBeLessThan(room.x + room.width);
  await expect(recent).toContainText('Kept in this browser only.');
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press('Escape');

  // Who goes back is faster than the module that follows.
  const back = new AbortController();
  await page.route(/\/later-[^/]*\.js$/, async (route) => {
    if (!back.signal.aborted) await once(back.signal, 'abort');
    await route.continue();
  });
  await page.reload();
  await page.waitForFunction(() => 'heatwalk' in window);
  await page.evaluate(() => window.heatwalk.ready);
  expect(await page.evaluate(() => window.heatwalk.mesh?.name)).toBe(EGG_NAME);
  await sources(page).toEqual([{ vertex: 9 }]);
  await expect(page.getByText('This link needs your file')).toBeHidden();
  // What was open before is found too.
  await page.goBack();
  back.abort();
  await meshName(page).toBe('ball.off');
  await page.goForward();
  await meshName(page).toBe(EGG_NAME);
  /** Loads the page anew while the module that finds kept files is held back, and gives a file. Returns what lets it go on. */
  const giveMeanwhile = async (name: string, content: string) => {
    const found = new AbortController();
    await page.route(/\/kept-[^/]*\.js$/, async (route) => {
      if (!found.signal.aborted) await once(found.signal, 'abort');
      await route.continue();
    });
    await page.reload();
    const file = { name, mimeType: '', buffer: Buffer.from(content) };
    await page.locator('input[type=file]').first().setInputFiles(file);
    return () => found.abort();
  };
  // What cannot be opened keeps nothing from being found.
  const findIt = await giveMeanwhile('empty.off', '');
  await expect(page.getByRole('alert')).toContainText('empty.off is empty');
  findIt();
  await meshName(page).toBe(EGG_NAME);
  // What is given while it is still looked for is what is wanted.
  const findLate = await giveMeanwhile('ball.off', BALL);
  await meshName(page).toBe('ball.off');
  findLate();
  await heatwalk.settled();
  await meshName(page).toBe('ball.off');
  await heatwalk.dropAndOpen([[EGG_NAME, EGG]]);
  // What has no source comes back without.
  await page.evaluate(() => window.heatwalk.setSources([]));
  await expect(page).toHaveURL(/name=an-egg[^&]*&.*s=none/);
  await page.reload();
  await page.waitForFunction(() => 'heatwalk' in window);
  await page.evaluate(() => window.heatwalk.ready);
  expect(await page.evaluate(() => window.heatwalk.mesh?.name)).toBe(EGG_NAME);
  await sources(page).toEqual([]);

  await openMenu();
  await recent.getByRole('button', { name: 'ball.off' }).first().click();
  await meshName(page).toBe('ball.off');
  await expect(page).toHaveURL(/name=ball\.off/);
  await expect(menu).toBeHidden();
  await openMenu();
  await expect(recent.getByRole('listitem')).toHaveText([/^ball\.off/, new RegExp(EGG_NAME)]);
  await recent.getByRole('button', { name: 'Erase ball.off' }).click();
  await expect(recent.getByRole('listitem')).toHaveText([new RegExp(EGG_NAME)]);
  await recent.getByRole('button', { name: 'Erase all' }).click();
  await expect(recent).toBeHidden();

  // What was erased is asked for.
  const link = new URL(page.url()).hash;
  await heatwalk.open(link);
  await expect(page.getByText('This link needs your file ball.off')).toBeVisible();

  // Where the browser keeps nothing, the file is open all the same, and the menu says why it is not kept.
  await page.evaluate(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException('Full.', 'QuotaExceededError');
    };
  });
  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  await openMenu();
  await expect(recent).toContainText('ball.off is not kept. The browser has no room for it, or keeps nothing.');
  await expect(recent.getByRole('listitem')).toHaveCount(0);
  await expect(page.getByRole('alert')).toBeEmpty();
});
