/** Components that touch, nearly touch or stay apart. */
import { obj, sphere } from '../fixtures';
import { difference, expect, openSection, test } from '../page';

/** A ball of radius 1 at the height of 0, and one beside it that begins `gap` after the first ends. */
function balls(gap: number): string {
  const [first, second] = [sphere(24), sphere(24)];
  return obj({
    left: first,
    right: { ...second, positions: second.positions.map(([x, y, z]) => [x, y, z + 2 + gap]) },
  });
}

const noise = (index: number) => 5e-6 * Math.sin(12.9898 * index);

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

  await openSection(page, 'solver');
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

test('what is apart is linked group by group, nearest first, by a link of the page too', async ({ heatwalk, page }) => {
  const row = [0, 2.4, 5, 7.3].map((z) => sphere(24, [0, 0, z]));
  const file = obj(Object.fromEntries(row.map((ball, index) => [`ball${index}`, ball])));
  await heatwalk.openFile('row.obj', file, 's=0&method=auto&bridge=off');
  await expect(page.locator('.message.summary p').first()).toHaveText(/ in 4 pieces\.$/);
  await heatwalk.settled();
  const apart = await page.evaluate(unreached);
  const linkNearest = page.getByRole('button', { name: 'Link nearest' });

  // The pair at the far end is nearer to each other, 0.3, than the ball that is next to the source, 0.4.
  await linkNearest.click();
  await expect(page).toHaveURL(/links=2/);
  await expect.poll(() => page.evaluate(unreached)).toBeLessThan(apart ?? 0);
  expect(await page.evaluate(unreached)).toBeGreaterThan(0);
  await openSection(page, 'solver');
  await expect(page.getByText('2 links over gaps of up to 0.4 m (assumed); 2 groups.')).toBeVisible();

  await linkNearest.click();
  await expect.poll(() => page.evaluate(unreached)).toBe(0);
  await expect(linkNearest).toBeHidden();
  await expect(page).toHaveURL(/links=3/);
  // A quarter around the first ball, halfway around the others, and over all gaps.
  const farthest = await page.evaluate(() => window.heatwalk.field?.maxDistance ?? 0);
  expect(Math.abs(farthest - (3.5 * Math.PI + 0.4 + 0.6 + 0.3))).toBeLessThan(0.1);

  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page).toHaveURL(/links=2/);
  await page.getByRole('button', { name: 'Unlink' }).click();
  await expect.poll(() => page.evaluate(unreached)).toBe(apart);
  await page.getByRole('button', { name: 'Link all' }).click();
  await expect.poll(() => page.evaluate(unreached)).toBe(0);
  await expect(page).toHaveURL(/links=3/);

  await heatwalk.openFile('row.obj', file, 's=0&method=auto&links=3');
  await heatwalk.settled();
  expect(await page.evaluate(unreached)).toBe(0);
  await expect(page.getByRole('status').first()).toContainText('4 components, 3 links, one group');
  await heatwalk.openFile('row.obj', file, 's=0&method=auto&links=99');
  await expect(page.getByText('The link asks for links=99; no more than 3 can be made.')).toBeVisible();
  await expect(page).toHaveURL(/links=3/);
});

test('distance crosses cracks, and the message tells of them', async ({ heatwalk, page }) => {
  // Each triangle has vertices of its own, and misses its neighbors by up to 0.00001.
  const { positions, triangles } = sphere(24);
  const loose = triangles.flatMap((triangle, face) =>
    triangle.map((vertex): [number, number, number] => {
      const [x, y, z] = positions[vertex];
      return [x + noise(3 * face), y + noise(3 * face + 1), z + noise(3 * face + 2)];
    }),
  );
  const corners = triangles.map((_, face): [number, number, number] => [3 * face, 3 * face + 1, 3 * face + 2]);
  await heatwalk.openFile('loose.obj', obj({ loose: { positions: loose, triangles: corners } }), 's=0&method=auto');
  await heatwalk.settled();
  await expect(page.getByRole('status').first()).toContainText(
    /welded [\d,]+ crack vertices within 0\.000\d+ m \(assumed\)/,
  );
  expect(await page.evaluate(() => window.heatwalk.mesh?.components)).toBe(1);
  const farthest = await page.evaluate(() => window.heatwalk.field?.maxDistance ?? 0);
  expect(Math.abs(farthest - Math.PI)).toBeLessThan(0.02);
});

test('contacts are marked where there are any', async ({ heatwalk, page }) => {
  const contacts = page.getByRole('switch', { name: 'Contacts' });
  // From the side: the circle where they meet is in sight.
  await heatwalk.openFile('balls.obj', balls(-0.4), 's=0&method=auto&show=edges&cam=1.6,0.2,3,0,0,0');
  await heatwalk.settled();
  await openSection(page, 'display');
  await expect(contacts).toBeEnabled();
  const without = await heatwalk.drawing(1, false);
  await contacts.check();
  await expect(page).toHaveURL(/show=edges,contacts/);
  expect(difference(await heatwalk.drawing(1, false), without)).toBeGreaterThan(0.0001);
  await contacts.uncheck();
  expect(difference(await heatwalk.drawing(1, false), without)).toBe(0);
  await heatwalk.openFile('balls.obj', balls(1), 's=0&method=auto');
  await heatwalk.settled();
  await openSection(page, 'display');
  await expect(contacts).toBeDisabled();
});
