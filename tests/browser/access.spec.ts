/** What axe, a checker of accessibility, finds: nothing. */
import { violations } from '../axe';
import { expect, test } from '../page';

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
