import { copyFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { SINGLE } from '../built';
import { expect, test } from '../page';

test('the page in one file opens from a disk, where nothing else is', async ({ page }, info) => {
  const alone = info.outputPath('alone.html');
  copyFileSync(`${SINGLE}/heatwalk.html`, alone);
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).protocol));
  const refused: string[] = [];
  page.context().on('console', (message) => {
    if (message.text().includes('Content Security Policy')) refused.push(message.text());
  });
  await page.goto(`${pathToFileURL(alone).href}?gpu=webgl`);
  // Its modules are unpacked first.
  await page.waitForFunction(() => 'heatwalk' in window);
  await page.evaluate(() => window.heatwalk.settled());
  expect(await page.evaluate(() => window.heatwalk.backend)).toBe('WebGL2');
  expect((await page.evaluate(() => window.heatwalk.scene)).mesh).toEqual({ kind: 'preset', id: 'bunny' });
  // A file, and tetrahedra by a module of their own.
  for (const preset of ['dragon', 'cave']) {
    await page.evaluate((name) => (location.hash = `#m=${name}`), preset);
    await expect.poll(() => page.evaluate(() => window.heatwalk.mesh?.name.split('.')[0])).toBe(preset);
  }
  await expect(page.getByRole('alert')).toBeEmpty();
  // The documents are within.
  await page.getByRole('button', { name: 'Help' }).click();
  const opening = page.waitForEvent('popup');
  await page.getByRole('link', { name: 'All documents' }).click();
  await expect((await opening).getByRole('heading', { name: 'The program', exact: true })).toBeVisible();
  await expect(page).toHaveURL(/alone\.html\?gpu=webgl#v=1&m=cave/);
  expect(asked.filter((protocol) => !['file:', 'data:', 'blob:'].includes(protocol))).toEqual([]);
  expect(asked.filter((protocol) => protocol === 'file:')).toHaveLength(1);
  // Its policy lets all of that run, and nothing else.
  expect(refused).toEqual([]);
  const ran = await page.evaluate(() => {
    const script = document.createElement('script');
    script.append('window.ran = true');
    document.body.append(script);
    return 'ran' in window;
  });
  expect(ran).toBe(false);
});
