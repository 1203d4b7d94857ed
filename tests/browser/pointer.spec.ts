import { expect, type HeatwalkPage, openSection, SEEN, test } from '../page';

test.use(SEEN);

async function clickModel(heatwalk: HeatwalkPage, dx = 0, dy = 0, modifier?: string): Promise<void> {
  const pixel = await heatwalk.pixelOnModel(dx, dy);
  if (modifier) await heatwalk.page.keyboard.down(modifier);
  await heatwalk.page.mouse.click(...pixel);
  if (modifier) await heatwalk.page.keyboard.up(modifier);
}

/** Two clicks on one spot within 300 ms would be a double click. */
async function sourceCount(heatwalk: HeatwalkPage, count: number): Promise<void> {
  await expect.poll(async () => (await heatwalk.scene()).sources.length).toBe(count);
}

test('a click sets the source, ctrl-click adds, shift-click draws a line from the last one', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  const solves = await heatwalk.solves();
  const [x, y] = await heatwalk.pixelOnModel();
  await page.mouse.click(x, y);
  // The keyboard acts on the model from then on, without a frame around the window.
  await expect(page.locator('.stage')).toBeFocused();
  expect(await page.locator('.stage').evaluate((stage) => stage.matches(':focus-visible'))).toBe(false);
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
  const [source] = (await heatwalk.scene()).sources;
  const [px, py] = await heatwalk.pixelOf(source);
  expect(Math.hypot(px - x, py - y)).toBeLessThan(1.5);
  const { diameter } = await heatwalk.mesh();
  // Inside a triangle the field is interpolated between corners that are up to an edge away.
  expect(await heatwalk.distanceAt(source)).toBeLessThan(0.03 * diameter);
  await expect(page.getByText('Click the surface')).toBeHidden();

  await clickModel(heatwalk, 0.06, 0.1, 'Control');
  await sourceCount(heatwalk, 2);
  await clickModel(heatwalk, -0.04, 0.15, 'Shift');
  await sourceCount(heatwalk, 1);
  await expect(page.getByRole('button', { name: /^Delete source/ })).toHaveCount(2);
  await expect(page.getByRole('button', { name: /^Line of \d+ vertices$/ })).toBeVisible();
  await clickModel(heatwalk, 0.02, 0.12);
  await sourceCount(heatwalk, 1);
  expect((await heatwalk.scene()).sets).toEqual([]);
});

test('dragging a pin moves the source and solves on the way', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await clickModel(heatwalk);
  await expect.poll(async () => 'face' in (await heatwalk.scene()).sources[0]).toBe(true);
  const solves = await heatwalk.solves();
  const { camera, sources: from } = await heatwalk.scene();
  const [x, y] = await heatwalk.pixelOf(from[0]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  let seen = solves;
  for (let i = 1; i <= 6; i++) {
    await page.mouse.move(x + 8 * i, y + 6 * i);
    // Each step is followed while the button is still down.
    await expect.poll(() => heatwalk.solves()).toBeGreaterThan(seen);
    seen = await heatwalk.solves();
  }
  await page.mouse.up();
  expect(seen - solves).toBeGreaterThanOrEqual(6);
  const after = await heatwalk.scene();
  const [ax, ay] = await heatwalk.pixelOf(after.sources[0]);
  expect(Math.hypot(ax - x - 48, ay - y - 36)).toBeLessThan(2);
  expect(after.camera).toEqual(camera);
  await page.keyboard.press('Control+z');
  expect((await heatwalk.scene()).sources).toEqual(from);
});

test('a pin is dragged by its ball too, also where that stands beside the model', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await heatwalk.settled();
  const { camera, sources: from } = await heatwalk.scene();
  const [x, y] = await heatwalk.pixelOf(from[0]);
  const isBall = (across: number, down: number) =>
    page.evaluate(
      ([px, py]) => {
        const stage = document.querySelector<HTMLElement>('.stage');
        if (!stage) throw new Error('no stage');
        stage.dispatchEvent(new PointerEvent('pointermove', { clientX: px, clientY: py, bubbles: true }));
        return stage.dataset.cursor === 'source' && window.heatwalk.placeAt(px, py) === null;
      },
      [across, down] as const,
    );
  // The needle stands on the bunny's side.
  let ball: [number, number] | null = null;
  for (let step = 0; step < 36 * 5 && !ball; step++) {
    const away = 20 + 10 * Math.floor(step / 36);
    const angle = (step % 36) * (Math.PI / 18);
    const [across, down] = [x + away * Math.cos(angle), y + away * Math.sin(angle)];
    if (await isBall(across, down)) ball = [across, down];
  }
  if (!ball) throw new Error('The ball is nowhere beside the model.');
  // What is seen of the model lies on the side of the needle's foot.
  const [right, down] = [x - ball[0], y - ball[1]].map((part) => 0.8 * part);
  const solves = await heatwalk.solves();
  await page.mouse.move(...ball);
  await page.mouse.down();
  await page.mouse.move(ball[0] + right, ball[1] + down, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
  await heatwalk.settled();
  const after = await heatwalk.scene();
  const [ax, ay] = await heatwalk.pixelOf(after.sources[0]);
  expect(Math.hypot(ax - x - right, ay - y - down)).toBeLessThan(2);
  expect(after.camera).toEqual(camera);
});

test('of the fields that come between two frames the device gets the last', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await clickModel(heatwalk);
  await heatwalk.settled();
  const [x, y] = await heatwalk.pixelOf((await heatwalk.scene()).sources[0]);
  const { vertices } = await heatwalk.mesh();
  const frames = await page.evaluateHandle(async (least) => {
    const { requestAnimationFrame: request } = window;
    const held: FrameRequestCallback[] = [];
    window.requestAnimationFrame = (callback) => held.push(callback);
    // The frame that is asked for already passes.
    await new Promise((resolve) => request(resolve));
    const buffers = WebGL2RenderingContext.prototype;
    const { bufferSubData: write } = buffers;
    const written = { count: 0 };
    buffers.bufferSubData = function (...given: unknown[]) {
      const data = given[2];
      if (ArrayBuffer.isView(data) && data.byteLength >= least) written.count += 1;
      Reflect.apply(write, this, given);
    };
    const goOn = () => {
      window.requestAnimationFrame = request;
      held.forEach((callback) => window.requestAnimationFrame(callback));
    };
    return { written, goOn };
  }, 4 * vertices);
  const written = () => frames.evaluate(({ written: { count } }) => count);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 4; i++) {
    const solves = await heatwalk.solves();
    await page.mouse.move(x + 8 * i, y + 6 * i);
    await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
  }
  expect(await written()).toBe(0);
  await frames.evaluate(({ goOn }) => goOn());
  // Distances, and where they grow.
  await expect.poll(written).toBe(2);
  await page.mouse.up();
});

test('a drag elsewhere orbits and sets no source', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const before = await heatwalk.scene();
  const yaw = () => page.evaluate(() => window.heatwalk.camera?.[0] ?? Number.NaN);
  const yawBefore = await yaw();
  const [x, y] = await heatwalk.pixelOnModel(0, 0.05);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y, { steps: 4 });
  await page.mouse.up();
  await expect.poll(yaw).not.toBeCloseTo(yawBefore, 2);
  expect((await heatwalk.scene()).sources).toEqual(before.sources);
  await expect.poll(async () => (await heatwalk.scene()).camera).not.toBeNull();
});

test('the wheel zooms, a right drag pans, F frames again', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const camera = () => page.evaluate(() => window.heatwalk.camera ?? []);
  const [, , far] = await camera();
  const [x, y] = await heatwalk.pixelOnModel();
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -400);
  await expect.poll(async () => (await camera())[2]).toBeLessThan(0.8 * far);
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(x + 60, y + 30, { steps: 3 });
  await page.mouse.up({ button: 'right' });
  await expect.poll(async () => Math.hypot(...(await camera()).slice(3))).toBeGreaterThan(0.01);
  await page.keyboard.press('f');
  await expect.poll(async () => Math.hypot(...(await camera()).slice(3))).toBeLessThan(0.005);
  await expect.poll(async () => (await camera())[2] / far).toBeCloseTo(1, 1);
});

test('alt-click places the walker', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const [source] = (await heatwalk.scene()).sources;
  const [x, y] = await heatwalk.pixelOnModel();
  await clickModel(heatwalk, 0, 0, 'Alt');
  await expect.poll(async () => (await heatwalk.scene()).walker).toHaveProperty('face');
  const { walker, sources } = await heatwalk.scene();
  expect(sources).toEqual([source]);
  if (!walker) throw new Error('no walker');
  const [px, py] = await heatwalk.pixelOf(walker);
  expect(Math.hypot(px - x, py - y)).toBeLessThan(1.5);
  // The path is as long as the distance, up to the field's error near the source.
  const length = () => page.evaluate(() => window.heatwalk.walker?.length ?? 0);
  const distance = await heatwalk.distanceAt(walker);
  await expect.poll(async () => Math.abs((await length()) / distance - 1)).toBeLessThan(0.1);
});

test('undo and redo restore sources', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const { sources: first } = await heatwalk.scene();
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await clickModel(heatwalk, 0.03, 0.1);
  await expect.poll(async () => 'face' in (await heatwalk.scene()).sources[0]).toBe(true);
  const { sources: second } = await heatwalk.scene();
  await page.keyboard.press('Control+z');
  expect((await heatwalk.scene()).sources).toEqual(first);
  await expect.poll(() => heatwalk.distanceAt(first[0])).toBe(0);
  await page.keyboard.press('Control+Shift+z');
  expect((await heatwalk.scene()).sources).toEqual(second);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect((await heatwalk.scene()).sources).toEqual(first);
});

test('an undo that comes before the answer shows the field of the sources that are back', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  // A question that waits for another one is overtaken, and no field comes of it.
  await heatwalk.settled();
  const { sources: first } = await heatwalk.scene();
  const solves = await heatwalk.solves();
  await page.evaluate(() => {
    for (const keys of [{ key: 'Enter' }, { key: 'z', ctrlKey: true }]) {
      document.querySelector('.stage')?.dispatchEvent(new KeyboardEvent('keydown', { ...keys, bubbles: true }));
    }
  });
  expect((await heatwalk.scene()).sources).toEqual(first);
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves + 1);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(first[0])).toBe(0);
});

test('a double click focuses and does not move the source', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const { sources } = await heatwalk.scene();
  await page.mouse.dblclick(...(await heatwalk.pixelOnModel(0.04, 0.1)));
  await expect
    .poll(() => page.evaluate(() => Math.hypot(...(window.heatwalk.camera ?? []).slice(3))))
    .toBeGreaterThan(0.01);
  expect((await heatwalk.scene()).sources).toEqual(sources);
});

test('the readout shows distance and vertex under the pointer', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const [x, y] = await heatwalk.pixelOnModel();
  await page.mouse.move(x, y);
  const readout = page.locator('.readout');
  await expect(readout).toHaveText(/^[\d.]+ units · \d+ % of the diagonal · vertex \d+$/);
  const place = await page.evaluate(([px, py]) => window.heatwalk.placeAt(px, py), [x, y] as const);
  if (!place) throw new Error('nothing under the pointer');
  const said = Number.parseFloat((await readout.textContent()) ?? '');
  const distance = await page.evaluate((point) => window.heatwalk.exactDistanceAt(point), place);
  expect(Math.abs(said - (distance ?? Number.NaN))).toBeLessThanOrEqual(0.006 * (distance ?? Number.NaN));
  // Another unit is told without a move.
  await page.evaluate(() => window.heatwalk.set({ unit: 'm' }));
  await expect(readout).toHaveText(/^[\d.]+ m · /);
  await page.mouse.move(20, 300);
  await expect(readout).toBeHidden();
});

test('the readout is of what is under the pointer after the camera has moved, too', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const at = await heatwalk.pixelOnModel();
  await page.mouse.move(...at);
  const readout = page.locator('.readout');
  // Without ≈ it is the answer of the worker: what is read until then is rounded otherwise.
  const isExact = /^[\d.]+ units · /;
  await expect(readout).toHaveText(isExact);
  const before = await readout.textContent();
  await page.keyboard.press('9');
  await heatwalk.rest();
  const shown = async () => ((await readout.isVisible()) ? readout.textContent() : null);
  // Where the pointer comes anew, it says the same.
  const anew = async () => {
    const text = await shown();
    return text === before || text === null ? '' : text;
  };
  await expect.poll(anew).toMatch(isExact);
  const after = await shown();
  await page.mouse.move(at[0] + 1, at[1]);
  await page.mouse.move(...at);
  await expect.poll(shown).toBe(after);
});

test('the readout is there once the camera has flown to another model under a resting pointer', async ({
  heatwalk,
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await heatwalk.open('#v=1&m=bunny&method=heat&refine=0');
  await page.mouse.move(...(await page.evaluate(() => window.heatwalk.centre)));
  await page.mouse.wheel(0, -300);
  await heatwalk.rest();
  const near = await page.evaluate(() => window.heatwalk.camera?.[2]);
  await heatwalk.follow('#v=1&m=teapot&method=heat&refine=0');
  expect(await page.evaluate(() => window.heatwalk.camera?.[2])).not.toBe(near);
  await expect(page.locator('.readout')).toBeVisible();
});

test('the keyboard sets, adds and deletes sources at the reticle', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await page.locator('.stage').focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('.reticle')).toBeVisible();
  await expect.poll(async () => 'face' in (await heatwalk.scene()).sources[0]).toBe(true);
  const [centreX, centreY] = await page.evaluate(() => window.heatwalk.centre);
  const [x, y] = await heatwalk.pixelOf((await heatwalk.scene()).sources[0]);
  expect(Math.hypot(x - centreX, y - centreY)).toBeLessThan(1.5);

  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowLeft');
  await heatwalk.rest();
  await page.keyboard.press('Shift+Enter');
  await sourceCount(heatwalk, 2);
  // The same place once more is the same source.
  await page.keyboard.press('Shift+Enter');
  await page.keyboard.press('Escape');
  await page.keyboard.press('w');
  await expect.poll(async () => (await heatwalk.scene()).walker).toHaveProperty('face');
  await sourceCount(heatwalk, 2);

  await page.locator('.source-name').first().click();
  expect((await heatwalk.scene()).selected).toBe(0);
  await page.keyboard.press('Delete');
  await sourceCount(heatwalk, 1);
});

test('the time factor slider and the boundary menu change the solution', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const solves = await heatwalk.solves();
  await openSection(page, 'solver');
  await page.getByRole('slider', { name: 'Time factor m' }).fill('1');
  await expect.poll(async () => (await heatwalk.scene()).parameters.timeStep).toBe(10);
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
  await page.getByRole('combobox', { name: 'Boundary' }).selectOption('dirichlet');
  await expect(page).toHaveURL(/t=10&b=dirichlet/);
  await expect(page.getByRole('alert')).toBeEmpty();
});
