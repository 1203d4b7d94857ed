/** Two settings side by side. */
import type { PNG } from 'pngjs';
import { grid, off } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';
import { cubesMsh, cubeVertex } from '../tetrahedra';

/** A sheet, whose boundary makes Neumann and Dirichlet differ. */
const SHEET = off(grid(32));
const SCENE = 'up=z&cam=0,1.5,2.6,0,0,0&s=528&w=none&method=heat&near=0&refine=0';

/** Mean difference of two pictures, 0 to 255, in the columns between two shares of the width. */
function apart(one: PNG, other: PNG, [from, to]: readonly [number, number]): number {
  let [sum, count] = [0, 0];
  for (let y = 0; y < one.height; y++) {
    for (let x = Math.round(from * one.width); x < to * one.width; x++) {
      for (let channel = 0; channel < 3; channel++) {
        const at = 4 * (y * one.width + x) + channel;
        sum += Math.abs(one.data[at] - other.data[at]);
        count += 1;
      }
    }
  }
  return sum / count;
}

const LEFT = [0.2, 0.4] as const;
const RIGHT = [0.6, 0.8] as const;
/** What is the same, but for colors up to the larger of both largest distances; and what is not. */
const SAME = 5;
const OTHER = 30;

const drawn = (heatwalk: HeatwalkPage) => heatwalk.drawing(1, true);

test('two settings share a picture; the line between them moves, and is in the link', async ({ heatwalk, page }) => {
  await heatwalk.openFile('sheet.off', SHEET, `${SCENE}&b=dirichlet`);
  const dirichlet = await drawn(heatwalk);
  await openSection(page, 'solver');
  await page.getByRole('combobox', { name: 'Boundary' }).selectOption('neumann');
  await heatwalk.settled();
  const neumann = await drawn(heatwalk);
  expect(apart(neumann, dirichlet, LEFT)).toBeGreaterThan(OTHER);
  expect(apart(neumann, dirichlet, RIGHT)).toBeGreaterThan(OTHER);

  // Undo goes back over the setting and shows its field.
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('combobox', { name: 'Boundary' }).first()).toHaveValue('dirichlet');
  expect(apart(await drawn(heatwalk), dirichlet, LEFT)).toBeLessThan(SAME);
  await page.getByRole('button', { name: 'Redo' }).click();
  await heatwalk.settled();

  const section = await openSection(page, 'compare');
  await section.getByRole('button', { name: 'Neumann and Dirichlet' }).click();
  await expect(section.locator('thead')).toHaveText('Insulated (Neumann)Cold (Dirichlet)');
  await expect.poll(() => page.url()).toContain('&vs=b:dirichlet,at:0.5');
  const both = await drawn(heatwalk);
  expect(apart(both, neumann, LEFT)).toBeLessThan(SAME);
  expect(apart(both, dirichlet, RIGHT)).toBeLessThan(SAME);
  const largest = section.getByRole('row', { name: 'Maximum distance' }).getByRole('cell');
  expect(await largest.first().textContent()).not.toBe(await largest.last().textContent());

  const line = page.getByRole('slider', { name: 'Divider between the two settings' });
  await line.press('Home');
  await expect.poll(() => page.url()).toContain('at:0&');
  expect(apart(await drawn(heatwalk), dirichlet, LEFT)).toBeLessThan(SAME);
  await page.keyboard.press('Control+z');
  const box = await line.boundingBox();
  if (!box) throw new Error('The line is not seen.');
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 600, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  expect((await heatwalk.scene()).compared?.split).toBe(1);
  expect(apart(await drawn(heatwalk), neumann, RIGHT)).toBeLessThan(SAME);
  await page.keyboard.press('Control+z');
  expect((await heatwalk.scene()).compared?.split).toBe(0.5);

  await section.getByRole('button', { name: 'Swap sides' }).click();
  const swapped = await drawn(heatwalk);
  expect(apart(swapped, dirichlet, LEFT)).toBeLessThan(SAME);
  expect(apart(swapped, neumann, RIGHT)).toBeLessThan(SAME);
  // Both sides follow the source.
  const [x, y] = await heatwalk.pixelOf({ vertex: 672 });
  await page.mouse.click(x, y);
  const moved = await drawn(heatwalk);
  expect(apart(moved, swapped, LEFT)).toBeGreaterThan(OTHER);
  expect(apart(moved, swapped, RIGHT)).toBeGreaterThan(OTHER);

  await section.getByRole('combobox', { name: 'Method' }).selectOption('exact');
  await expect(section.locator('thead')).toHaveText('Heat methodExact');
  await expect.poll(() => page.url()).toContain('&vs=method:exact,');
  await section.getByRole('button', { name: 'Stop comparing' }).click();
  await expect(line).toBeHidden();
  await expect.poll(() => page.url()).not.toContain('vs=');
  await expect(page.locator('.message.error')).toHaveCount(0);
});

test(
  'sides have the same time factor where the linear solver differs; times are told once both were measured',
  { tag: '@page' },
  async ({ heatwalk, page }) => {
    await heatwalk.openFile('sheet.off', SHEET, SCENE);
    const section = await openSection(page, 'compare');
    await section.getByRole('button', { name: 'Cholesky and conjugate gradients' }).click();
    await expect(section.locator('thead')).toHaveText('CholeskyConjugate gradients');
    const cells = (name: string | RegExp) => section.getByRole('row', { name }).getByRole('cell');
    await expect(cells('Time factor m')).toHaveText(['100', '100']);
    // Noise alone: as solved, the two are the same.
    await expect(cells('Largest difference')).toHaveText(/^(0|(< )?0\.0\d* %)$/);
    await expect(section.getByRole('row', { name: 'Solve' })).toHaveCount(0);
    await section.getByRole('button', { name: 'Measure times' }).click();
    await expect(cells('Solve')).toHaveText([/\d ms$/, /\d ms$/]);
    await expect(cells(/^Factor/)).toHaveText([/\d ms$/, /\d ms$|–/]);
    await section.getByRole('button', { name: 'Swap sides' }).click();
    await expect(section.locator('thead')).toHaveText('Conjugate gradientsCholesky');
    await expect(section.getByRole('row', { name: 'Solve' })).toHaveCount(0);
  },
);

test(
  'what the scene had before a comparison of the report comes back after it',
  { tag: '@page' },
  async ({ heatwalk, page }) => {
    await heatwalk.openFile('sheet.off', SHEET, 'up=z&s=528&windows=2');
    const { method, windows, parameters, refine } = await heatwalk.scene();
    const section = await openSection(page, 'compare');
    for (const name of ['m = 1 and m = 1000', 'Neumann and Dirichlet']) {
      await section.getByRole('button', { name }).click();
      await expect.poll(async () => (await heatwalk.scene()).method).toBe('heat');
    }
    await section.getByRole('button', { name: 'Stop comparing' }).click();
    expect(await heatwalk.scene()).toMatchObject({ method, windows, parameters, refine, compared: null });
    // What is changed meanwhile is wanted.
    await section.getByRole('button', { name: 'm = 1 and m = 1000' }).click();
    await openSection(page, 'solver');
    await page.getByRole('combobox', { name: 'Method' }).first().selectOption('exact');
    await section.getByRole('button', { name: 'Stop comparing' }).click();
    expect((await heatwalk.scene()).method).toBe('exact');
  },
);

test('a link opens both sides', { tag: '@page' }, async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&method=heat&near=0&t=1&refine=0&vs=t:1000,at:0.3');
  await drawn(heatwalk);
  const scene = await heatwalk.scene();
  expect(scene.parameters.timeStep).toBe(1);
  expect(scene.compared?.parameters.timeStep).toBe(1000);
  const line = page.getByRole('slider', { name: 'Divider between the two settings' });
  await expect(line).toHaveAttribute('aria-valuetext', '30 % m = 1');
  await expect(page.locator('#section-compare').getByRole('button', { name: 'Stop comparing' })).toBeVisible();
  // On a low window the tabs lie over no label.
  await page.setViewportSize({ width: 844, height: 390 });
  await page.getByRole('button', { name: 'Collapse the panel' }).click();
  const [label, tabs] = [
    await page.locator('.compare-right').boundingBox(),
    await page.locator('.panel').boundingBox(),
  ];
  expect(label?.y).toBeGreaterThan((tabs?.y ?? Infinity) + (tabs?.height ?? 0));
  // In a narrow one labels are read to their ends, beside the tools.
  await page.setViewportSize({ width: 320, height: 640 });
  await heatwalk.follow('#v=1&m=bunny&method=heat&b=neumann&refine=0&vs=b:dirichlet,at:0.5');
  await expect(line).toHaveAttribute('aria-valuetext', '50 % Insulated (Neumann)');
  const tools = await page.locator('.toolbar').boundingBox();
  for (const side of ['left', 'right']) {
    const words = page.locator(`.compare-${side}`);
    const hidden = await words.evaluate((element) => element.scrollWidth - element.clientWidth);
    expect(hidden, side).toBe(0);
    const { x = 0, width = Infinity } = (await words.boundingBox()) ?? {};
    expect(x, side).toBeGreaterThanOrEqual((tools?.x ?? 0) + (tools?.width ?? 0));
    expect(x + width, side).toBeLessThanOrEqual(320);
  }
  await heatwalk.open('#v=1&m=bunny&vs=nonsense');
  await expect(page.getByText('vs=nonsense is invalid')).toBeVisible();
  await expect(line).toBeHidden();
});

test('the line ends below the heading', { tag: '@page' }, async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&vs=method:heat,refine:0');
  const line = page.locator('.compare');
  await expect(line).toBeVisible();
  // What lies under the heading is found where it can be clicked.
  await heatwalk.style('.compare { pointer-events: auto !important; }');
  for (const [width, height] of [
    [1100, 720],
    [390, 844],
  ] as const) {
    await page.setViewportSize({ width, height });
    await expect(async () => {
      const [own, heading] = [await line.boundingBox(), await page.locator('.heading').boundingBox()];
      const isAt = (top: number) =>
        line.evaluate((element, at) => document.elementsFromPoint(...at).includes(element), [
          (own?.x ?? 0) + 1,
          top,
        ] as const);
      expect(await isAt((heading?.y ?? 0) + (heading?.height ?? 0) / 2), `${width} × ${height}, in the heading`).toBe(
        false,
      );
      expect(await isAt(height / 2), `${width} × ${height}, over the model`).toBe(true);
    }).toPass({ timeout: 10_000 });
  }
});

test('two settings inside of tetrahedra share boundary and cut', { tag: '@page' }, async ({ heatwalk, page }) => {
  // Behind a wall, where distances are not straight. Seen at right angles to the cut, which covers what is compared.
  const n = 8;
  const mesh = cubesMsh(n, (i, j) => j !== 1 || i === 0 || i === n - 1);
  const scene = `up=y&cam=0,0,3.2,0,0,0&s=${cubeVertex(n, 4, 0, 4).vertex}&w=none&cut=plane&method=heat&near=0&refine=0`;
  await heatwalk.openFile('walled.msh', mesh, `${scene}&b=neumann&vs=b:dirichlet,at:0.5`);
  const section = await openSection(page, 'compare');
  await expect(section.locator('thead')).toHaveText('Insulated (Neumann)Cold (Dirichlet)');
  await expect(section.getByRole('button', { name: 'Heat and exact' })).toBeHidden();
  for (const name of ['Mean difference', 'Largest difference']) {
    await expect(section.getByRole('row', { name }).getByRole('cell')).toHaveText(/[1-9].*%/);
  }
  const both = await drawn(heatwalk);
  const line = page.getByRole('slider', { name: 'Divider between the two settings' });
  await line.press('End');
  const left = await drawn(heatwalk);
  await line.press('Home');
  const right = await drawn(heatwalk);
  expect(apart(left, right, LEFT)).toBeGreaterThan(2 * SAME);
  expect(apart(left, right, RIGHT)).toBeGreaterThan(2 * SAME);
  expect(apart(both, left, LEFT)).toBeLessThan(SAME);
  expect(apart(both, right, RIGHT)).toBeLessThan(SAME);
  // The right side follows the cut: it is what the left shows by the same settings.
  for (let step = 0; step < 6; step++) await page.locator('.stage canvas').first().press('.');
  await heatwalk.settled();
  const moved = await drawn(heatwalk);
  expect(apart(moved, right, RIGHT)).toBeGreaterThan(SAME);
  await section.getByRole('button', { name: 'Swap sides' }).click();
  await line.press('End');
  await heatwalk.settled();
  expect(apart(await drawn(heatwalk), moved, RIGHT)).toBeLessThan(SAME);
});

test(
  'a comparison that ends while its errors are asked for leaves no message',
  { tag: '@page' },
  async ({ heatwalk, page }) => {
    const thrown: string[] = [];
    page.on('pageerror', ({ message }) => thrown.push(message));
    await heatwalk.open('#v=1&m=bunny');
    for (let i = 0; i < 3; i++) {
      await page.evaluate(async () => {
        await window.heatwalk.set({ vs: 'method:heat,refine:0,at:0.5', paint: 'distance' });
        await window.heatwalk.settled();
        await window.heatwalk.set({ vs: 'none', paint: 'error' });
        await window.heatwalk.settled();
      });
    }
    expect(thrown).toEqual([]);
    await expect(page.locator('.message.error')).toHaveCount(0);
  },
);
