/** The shell: what opens a mesh, the workspaces with their tools, the search, and what a link says of them. */
import { once } from 'node:events';
import { expect, test } from '../page';

test('one workspace is open, by mouse and by arrows, and a link opens where its author was', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#v=1&m=bunny&open=look');
  const tab = (name: string) => page.getByRole('tab', { name, exact: true });
  await expect(tab('Look')).toHaveAttribute('aria-selected', 'true');
  await expect(page.getByRole('tabpanel')).toHaveCount(1);
  await expect(page.getByRole('button', { name: 'gold', exact: true })).toBeVisible();
  await tab('Look').press('End');
  await expect(tab('Share')).toBeFocused();
  await tab('Share').press('Home');
  await expect(tab('Scene')).toBeFocused();
  await tab('Look').click();
  await tab('Look').press('ArrowRight');
  await expect(tab('Measure')).toBeFocused();
  await expect.poll(() => page.url()).toContain('&open=measure');
  await tab('Scene').click();
  await expect.poll(() => page.url()).not.toContain('open=');
  await page.evaluate(() => (location.hash = '#v=1&m=bunny&open=share'));
  await expect(page.getByRole('button', { name: 'Copy link' })).toBeVisible();
  // A comparison is where its settings are; what is no workspace is told.
  await page.evaluate(() => (location.hash = '#v=1&m=bunny&vs=t:1000,at:0.5'));
  await expect(tab('Solver')).toHaveAttribute('aria-selected', 'true');
  await page.evaluate(() => (location.hash = '#v=1&m=bunny&open=kitchen'));
  await expect(page.getByText('open=kitchen is invalid')).toBeVisible();
  await expect(tab('Scene')).toHaveAttribute('aria-selected', 'true');
  // A comparison of no mesh is none.
  await heatwalk.open('#vs=t:1000,at:0.5');
  await expect(page.getByText("The link's vs=t:1000,at:0.5 is left out")).toBeVisible();
  await expect(tab('Scene')).toHaveAttribute('aria-selected', 'true');
});

test('what a link says that cannot be is told in one notice, and nothing else is lost', async ({ heatwalk, page }) => {
  const notices = page.locator('.message.notice p');
  await heatwalk.open('#%E0%A4%A');
  await expect(notices).toHaveText(["The link's %E0%A4%A is invalid; the default is used."]);
  await heatwalk.open('#v=1&m=icosphere&s=7&shown=km&w=999999&p=4&kiosk=2&look=gold');
  await expect(notices).toHaveText([
    "The link's kiosk=2, p=4, w=999999, and shown=km are invalid; the defaults are used.",
  ]);
  const scene = await heatwalk.scene();
  expect(scene).toMatchObject({ sources: [{ vertex: 7 }], shownUnit: null, parts: [], style: { name: 'gold' } });
  // What is for tetrahedra alone.
  await heatwalk.open('#v=1&m=icosphere&cut=plane');
  await expect(notices).toHaveText(["The link's cut=plane is invalid; the default is used."]);
  await expect(page).not.toHaveURL(/cut=/);
  // With a unit it can be.
  await heatwalk.open('#v=1&m=icosphere&unit=m&shown=km');
  expect((await heatwalk.mesh()).unit).toBe('km');
  await expect(notices).toHaveCount(0);
});

test('a tool opens its workspace, and is put away with it', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=terrain');
  const tool = (name: string) => page.getByRole('toolbar').getByRole('button', { name, exact: true });
  await expect(tool('Brush')).toBeHidden();
  await page.keyboard.press('b');
  await expect(tool('Brush')).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByRole('tab', { name: 'Ground' })).toHaveAttribute('aria-selected', 'true');
  await expect(page.getByRole('switch', { name: 'Brush' })).toBeChecked();
  await page.keyboard.press('m');
  await expect(tool('Brush')).toBeHidden();
  await expect(tool('Measure')).toHaveAttribute('aria-pressed', 'true');
  await page.getByRole('tab', { name: 'Look' }).click();
  await expect(tool('Source')).toHaveAttribute('aria-pressed', 'true');
  // Tools that belong to no workspace stay.
  await tool('Walker').click();
  await page.getByRole('tab', { name: 'Ground' }).click();
  await expect(tool('Walker')).toHaveAttribute('aria-pressed', 'true');
  await page.getByRole('tab', { name: 'Inside' }).click();
  await expect(tool('Cut')).toBeVisible();
});

test('a workspace that is pinned stays beside the next one in a wide window, with its tool, and after a reload', async ({
  heatwalk,
  page,
}) => {
  await page.setViewportSize({ width: 1600, height: 800 });
  await heatwalk.open('#v=1&m=icosphere&open=measure');
  const tab = (name: string) => page.getByRole('tab', { name, exact: true });
  const pin = page.getByRole('button', { name: 'Pin Measure' });
  const beside = page.getByRole('region', { name: 'Measure', exact: true });
  const middle = async () => (await page.evaluate(() => window.heatwalk.centre))[0];
  const alone = await middle();
  await pin.press('Enter');
  await expect(pin).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('m');
  await tab('Look').click();
  await expect(page.getByRole('tabpanel', { name: 'Look' })).toBeVisible();
  await expect(beside).toBeVisible();
  // The tool of what is pinned stays, and the model is in the middle of what both leave.
  await expect(page.getByRole('button', { name: 'Measure' }).first()).toHaveAttribute('aria-pressed', 'true');
  await expect.poll(middle).toBe(alone - (684 - 348) / 2);
  await expect(page.getByRole('button', { name: /^Pin / })).toHaveCount(1);

  await heatwalk.open('#v=1&m=icosphere&open=solve');
  await expect(beside).toBeVisible();
  // A tool opens no workspace that is there already.
  await page.keyboard.press('m');
  await expect(tab('Solver')).toHaveAttribute('aria-selected', 'true');
  await page.setViewportSize({ width: 1400, height: 800 });
  await expect(beside).toHaveCount(0);
  await expect(pin).toBeHidden();
  await page.setViewportSize({ width: 1600, height: 800 });
  await pin.press('Enter');
  await expect(beside).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Pin Solver' })).toBeFocused();
  await expect.poll(middle).toBe(alone);
});

test('the search finds settings by name and by what is said of them, commands with their keys, and presets', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  const dialog = page.getByRole('dialog', { name: 'Search' });
  const field = page.getByRole('combobox', { name: 'Search settings and commands' });
  await page.keyboard.press('Control+k');
  await field.fill('roughness');
  await expect(dialog.getByRole('option').first()).toHaveText('Surface roughnessLook › Style');
  await field.press('ArrowDown');
  await expect(dialog.getByRole('option', { selected: true })).toHaveText('Stripe roughnessLook › Style');
  await field.press('Enter');
  await expect(page.getByRole('slider', { name: 'Stripe roughness' })).toBeFocused();
  await expect(page.getByRole('tab', { name: 'Look' })).toHaveAttribute('aria-selected', 'true');

  await page.getByRole('button', { name: 'Search', exact: true }).click();
  await field.fill('measure');
  const named = await dialog.getByRole('option').allTextContents();
  expect(named).toContain('MeasureMeasure');
  expect(new Set(named).size).toBe(named.length);
  // By a word of its explanation alone.
  await field.fill('hiker');
  await expect(dialog.getByRole('option').first()).toHaveText('SlopeGround');
  // By what can be chosen, and by what others call it.
  for (const [word, answer] of [
    ['dxf', /^File/],
    ['inches', /^Correct unit/],
    ['tape', /^Measure/],
    ['download', /^Save/],
    ['language', /^Help/],
  ] as const) {
    await field.fill(word);
    await expect(dialog.getByRole('option', { name: answer }).first()).toBeVisible();
  }
  await field.fill('no such thing');
  await expect(dialog).toContainText('Nothing has these words.');
  await field.fill('turntable');
  await expect(dialog.getByRole('option').first()).toHaveText('TurntableT');
  await field.press('Enter');
  await expect(page.getByRole('button', { name: 'Turntable' })).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Control+k');
  await field.fill('torus');
  await dialog.getByRole('option', { name: /^Torus/ }).click();
  await expect.poll(() => page.evaluate(() => window.heatwalk.mesh?.name)).toBe('torus');
});

test('what is typed ahead of the search is for it, not for the model', async ({ heatwalk, page }) => {
  await heatwalk.open('#m=icosphere');
  await heatwalk.settled();
  const come = new AbortController();
  await page.route(/\/search-[^/]*\.js$/, async (route) => {
    if (!come.signal.aborted) await once(come.signal, 'abort');
    await route.continue();
  });
  const before = await heatwalk.scene();
  await page.keyboard.press('Control+k');
  // Keys of the file chooser, the legend and a tape among them, and one that is taken back.
  await page.keyboard.type('goldx');
  await page.keyboard.press('Backspace');
  expect(await heatwalk.scene()).toEqual(before);
  come.abort();
  const field = page.getByRole('combobox', { name: 'Search settings and commands' });
  await expect(field).toHaveValue('gold');
  await expect(page.getByRole('region', { name: /^Legend/ })).toBeVisible();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'gold', exact: true })).toBeFocused();
});

test('the search opens again in the moment in which it closes', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const close = page.getByRole('button', { name: 'Close the search' });
  await page.keyboard.press('Control+k');
  await close.evaluate((button: HTMLElement) => {
    button.click();
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'k', ctrlKey: true, bubbles: true }));
  });
  await expect(close).toBeVisible();
});

test('what opens a mesh is in one menu: files, addresses, presets', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&open=solve');
  const menu = page.getByRole('dialog', { name: 'Open' });
  const button = page.getByRole('banner').getByRole('button', { name: 'Open', exact: true });
  await button.click();
  const choosing = page.waitForEvent('filechooser');
  await menu.getByRole('button', { name: 'Open a file…' }).click();
  await choosing;
  await expect(menu).toBeHidden();
  await button.click();
  await menu.getByRole('textbox').fill('nowhere');
  await page.keyboard.press('Enter');
  await expect(menu).toContainText('This is no http or https address.');
  await menu.getByRole('textbox').fill(`${new URL('/docs/none.obj', page.url()).href}`);
  await page.keyboard.press('Enter');
  await expect(page.locator('.message.error')).toContainText('none.obj was not opened');
  await button.click();
  await button.click();
  await expect(menu).toBeHidden();
  await button.click();
  await menu.getByRole('button', { name: 'Presets' }).click();
  await expect(page.getByRole('button', { name: /^Dragon/ })).toBeVisible();
});

test('opening says what a person wants, and the rest under details', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=icosphere');
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\nf 1 3 4\nf 1 3 4\n';
  await heatwalk.dropAndOpen([['square.obj', square]]);
  const summary = page.locator('.message.summary');
  await expect(summary.locator('p')).toHaveText('square.obj, 2 triangles, in one piece.');
  await summary.getByText('Details').click();
  await expect(summary.getByRole('listitem')).toHaveText([
    '1 component, 1 boundary',
    'removed 1 unreferenced vertex',
    'removed 1 duplicate triangle',
  ]);
});

test('what a file does not say of itself is asked over the model, and a tap corrects it', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#v=1&m=icosphere');
  const N = 6;
  const places = Array.from({ length: N * N }, (_, k) => [k % N, Math.floor(k / N)] as const);
  const vertices = places.map(([i, j]) => `v ${30 * i} ${30 * j} ${8 * Math.sin(i) * Math.cos(j)}`);
  const faces = places
    .filter(([i, j]) => i < N - 1 && j < N - 1)
    .map(([i, j]) => [N * j + i + 1, N * j + i + 2, N * (j + 1) + i + 2, N * (j + 1) + i + 1].join(' '));
  const hills = [...vertices, ...faces.map((corners) => `f ${corners}`)].join('\n');
  await heatwalk.dropAndOpen([['hills.obj', hills]]);
  const question = page.locator('.message.summary');
  const button = (name: string) => question.getByRole('button', { name, exact: true });
  // A grid of heights is a terrain: in meters, with Z up.
  await expect(button('m')).toHaveAttribute('aria-pressed', 'true');
  await expect(button('Z')).toHaveAttribute('aria-pressed', 'true');
  await expect(question).toContainText(/\d m across\?/);
  // A map has north along Y.
  const legend = page.getByRole('region', { name: 'Legend' }).getByRole('img');
  await expect(legend).toHaveAttribute('aria-label', /Up is Z\. North is Y\.$/);
  await button('ft').click();
  await expect(question).toContainText(/\d ft across\?/);
  await expect.poll(() => page.url()).toContain('&unit=ft');
  await button('Y').click();
  await expect.poll(async () => (await heatwalk.mesh()).up).toBe('y');
  await expect(button('Y')).toHaveAttribute('aria-pressed', 'true');
  // Whoever goes on is not asked any more.
  const [x, y] = await heatwalk.pixelOnModel();
  await page.mouse.click(x, y);
  await expect(question).toHaveCount(0);
  // What says its unit is not asked.
  await page.evaluate(() => (location.hash = '#v=1&m=teapot'));
  await expect(page.locator('.message.summary p')).toContainText('Teapot, ');
  await expect(question.locator('.question')).toHaveCount(0);
});
