/** What axe, a checker of accessibility, finds: nothing. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import type axe from 'axe-core';
import { expect, test } from '../page';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

async function violations(page: Page): Promise<string[]> {
  await page.evaluate(AXE);
  return page.evaluate(async () => {
    const { violations: found } = await (globalThis as unknown as { axe: typeof axe }).axe.run();
    return found.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 120)}`));
  });
}

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, ${colorScheme}`, async ({ heatwalk, page }) => {
    await page.emulateMedia({ colorScheme });
    await heatwalk.open('#v=1&m=hemisphere&tape=10,200,400!&vs=b:dirichlet,at:0.4');
    await heatwalk.settled();
    expect(await violations(page)).toEqual([]);
    await page.evaluate(() => {
      for (const section of document.querySelectorAll<HTMLDetailsElement>('.panel details')) section.open = true;
    });
    // Fetched when they are seen first.
    await page.locator('#section-charts').scrollIntoViewIfNeeded();
    await expect(page.locator('#section-charts svg').first()).toBeVisible();
    await page.locator('#section-compare').scrollIntoViewIfNeeded();
    await expect(page.getByRole('button', { name: 'Swap sides' })).toBeVisible();
    await page.locator('#section-export').scrollIntoViewIfNeeded();
    await expect(page.getByLabel('Isolines at')).toBeVisible();
    expect(await violations(page)).toEqual([]);
    await page.getByRole('button', { name: 'Help', exact: true }).click();
    await page.getByLabel('Explain every setting').check();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
    expect(await violations(page)).toEqual([]);
    await page.goto('./docs/page.html');
    expect(await violations(page)).toEqual([]);
  });
}
