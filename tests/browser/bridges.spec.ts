/** Components that touch, nearly touch or stay apart. */
import { obj, sphere } from '../fixtures';
import { difference, expect, test } from '../page';

/** A ball of radius 1 at the height of 0, and one beside it that begins `gap` after the first ends. */
function balls(gap: number): string {
  const [first, second] = [sphere(24), sphere(24)];
  return obj({
    left: first,
    right: { ...second, positions: second.positions.map(([x, y, z]) => [x, y, z + 2 + gap]) },
  });
}

const unreached = () => window.heatwalk.field?.unreachableVertices;

test('stripes and the path run over parts that pierce each other, and not where they are not to', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.openFile('balls.obj', balls(-0.1), 's=0&w=1000&method=auto');
  await heatwalk.settled();
  await expect(page.getByRole('status')).toContainText('2 components, 1 contact, one group');
  expect(await page.evaluate(unreached)).toBe(0);
  const joined = await page.evaluate(() => ({ field: window.heatwalk.field, walker: window.heatwalk.walker }));
  expect(joined.field?.exactBelow).toBe(Infinity);
  // From the far ball: straight through the air it is more than 1.
  expect(joined.walker?.length ?? 0).toBeGreaterThan(1);

  await page.locator('#section-solver > summary').click();
  await page.getByRole('combobox', { name: 'Join components' }).selectOption('None');
  await expect.poll(() => page.evaluate(unreached)).toBeGreaterThan(100);
  await expect(page).toHaveURL(/bridge=off/);
  await page.getByRole('combobox', { name: 'Join components' }).selectOption('Touching or near');
  await expect.poll(() => page.evaluate(unreached)).toBe(0);
});

test('heat crosses to other components too, and becomes exact there', async ({ heatwalk, page }) => {
  await heatwalk.openFile('balls.obj', balls(-0.1), 's=0&method=heat&crowd=20');
  await heatwalk.settled();
  expect(await page.evaluate(unreached)).toBe(0);
  const error = await page.evaluate(() => window.heatwalk.field?.error);
  expect(error?.mean).toBeLessThan(0.05);
  expect(error?.mean).toBeGreaterThan(0);
});

test('what is apart is bridged as far as a link says', async ({ heatwalk, page }) => {
  await heatwalk.openFile('balls.obj', balls(0.2), 's=0&method=auto');
  await heatwalk.settled();
  expect(await page.evaluate(unreached)).toBeGreaterThan(100);
  await heatwalk.openFile('balls.obj', balls(0.2), 's=0&method=auto&bridge=0.25');
  await heatwalk.settled();
  expect(await page.evaluate(unreached)).toBe(0);
  expect((await heatwalk.scene()).bridge).toBe(0.25);
});

test('contacts are marked where there are any', async ({ heatwalk, page }) => {
  const contacts = page.getByRole('switch', { name: 'Contacts' });
  await heatwalk.openFile('balls.obj', balls(-0.1), 's=0&method=auto&show=edges');
  await heatwalk.settled();
  await page.locator('#section-display > summary').click();
  await expect(contacts).toBeEnabled();
  const without = await heatwalk.drawing(1, false);
  await contacts.check();
  await expect(page).toHaveURL(/show=edges,contacts/);
  await heatwalk.settled();
  expect(difference(await heatwalk.drawing(1, false), without)).toBeGreaterThan(0.0003);
  await heatwalk.openFile('balls.obj', balls(1), 's=0&method=auto');
  await heatwalk.settled();
  await expect(contacts).toBeDisabled();
});
