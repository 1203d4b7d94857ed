import type { Page } from '@playwright/test';
import { expect, openSection, SEEN, test } from '../page';

test.use(SEEN);

const fingers = (spread: number) => [
  { x: 200 - spread, y: 420, id: 0 },
  { x: 200 + spread, y: 420, id: 1 },
];

/** What floats over the model and is not in the window as a whole. */
function outside(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll('button, header, .toolbar, .panel, .message, .hint, .legend')]
      .filter((element) => element.checkVisibility() && !element.closest('.panel-body'))
      .filter((element) => {
        const { left, top, right, bottom } = element.getBoundingClientRect();
        return left < 0 || top < 0 || right > innerWidth || bottom > innerHeight;
      })
      .map((element) => element.outerHTML.slice(0, 80)),
  );
}

/** Whether nothing else lies over the middle of an element. */
function isSeen(element: Element): boolean {
  const { left, top, width, height } = element.getBoundingClientRect();
  return element === document.elementFromPoint(left + width / 2, top + height / 2);
}

/** Tools that something else lies over. */
function covered(page: Page): Promise<(string | null)[]> {
  return page.locator('.toolbar button').evaluateAll((buttons) =>
    buttons
      .filter((button) => button.checkVisibility())
      .filter((button) => {
        const { left, top, width, height } = button.getBoundingClientRect();
        return !button.contains(document.elementFromPoint(left + width / 2, top + height / 2));
      })
      .map((button) => button.getAttribute('aria-label') ?? button.textContent),
  );
}

test.describe('in a window of 1280 × 800 at 200 %', () => {
  test.use({ viewport: { width: 640, height: 400 } });

  test('nothing lies outside the window, and the tools are not covered, in forced colors too', async ({
    heatwalk,
    page,
  }) => {
    await page.emulateMedia({ forcedColors: 'active' });
    await heatwalk.open();
    expect(await outside(page)).toEqual([]);
    expect(await covered(page)).toEqual([]);
    await page.getByRole('button', { name: 'Expand the panel' }).click();
    expect(await outside(page)).toEqual([]);
    // What is a background alone has a color of the system.
    const mark = await page
      .locator('.panel-handle')
      .evaluate((handle) => getComputedStyle(handle, '::before').backgroundColor);
    const words = await page.evaluate(() => getComputedStyle(document.body).color);
    expect(mark).toBe(words);
  });
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test('nothing lies outside the window, with the sheet at either stop, or sideways', async ({ heatwalk, page }) => {
    // A long heading, and a message that stays.
    await heatwalk.open('#v=1&m=bunny&method=heat&refine=0&open=kitchen');
    expect(await outside(page)).toEqual([]);
    await page.getByRole('button', { name: 'Expand the panel' }).tap();
    await expect(page.getByRole('button', { name: 'Open a file…' })).toBeVisible();
    expect(await outside(page)).toEqual([]);
    const wide = await page.evaluate(() => {
      const body = document.querySelector('.panel-body');
      return [document.documentElement.scrollWidth - innerWidth, body ? body.scrollWidth - body.clientWidth : 0];
    });
    expect(wide).toEqual([0, 0]);
    // The tool bar is not covered by the sheet.
    const frame = await page.getByRole('button', { name: 'Frame' }).boundingBox();
    const sheet = await page.locator('.panel').boundingBox();
    expect((frame?.y ?? 0) + (frame?.height ?? 0)).toBeLessThanOrEqual(sheet?.y ?? 0);
    const message = await page.getByText('open=kitchen is invalid').boundingBox();
    expect((message?.y ?? 0) + (message?.height ?? 0)).toBeLessThanOrEqual(sheet?.y ?? 0);

    // What has come under the finger with the sheet was not tapped.
    await heatwalk.settled();
    expect((await heatwalk.scene()).mesh).toEqual({ kind: 'preset', id: 'bunny' });

    await page.setViewportSize({ width: 844, height: 390 });
    // Messages are beside the panel and above the tools, in the place of the hint.
    const panel = await page.locator('.panel').boundingBox();
    for (const said of await page.locator('.message').all()) {
      const { x = 0, y = 0, width = 0, height = 0 } = (await said.boundingBox()) ?? {};
      expect(x + width).toBeLessThanOrEqual(panel?.x ?? 0);
      expect(y + height).toBeLessThanOrEqual((await page.locator('.toolbar').boundingBox())?.y ?? 0);
    }
    await expect(page.locator('.hint')).toBeHidden();
    // What has the focus is seen.
    const draw = page.getByRole('combobox', { name: 'Draw' });
    await draw.focus();
    expect(await draw.evaluate(isSeen)).toBe(true);
    await page.getByRole('button', { name: 'Close the message' }).first().tap();
    for (const name of ['Scene', 'Ground', 'Inside']) {
      await page.getByRole('tab', { name }).tap();
      expect(await outside(page), name).toEqual([]);
      expect(await covered(page), name).toEqual([]);
    }
    // The model is between the heading and the hint above the tools.
    const heading = await page.locator('.heading').boundingBox();
    const tools = await page.locator('.foot').boundingBox();
    const [, middle] = await page.evaluate(() => window.heatwalk.centre);
    expect(2 * middle).toBeCloseTo((heading?.y ?? 0) + (heading?.height ?? 0) + (tools?.y ?? 0), 0);
  });

  test('the sheet is drawn up and down by its handle, and what was opened goes with the first touch', async ({
    heatwalk,
    page,
  }) => {
    await heatwalk.open();
    // What follows swipes has come with the hints.
    await expect(page.locator('.hint')).toBeVisible();
    await expect(page.locator('.message.summary')).toBeVisible();
    const client = await page.context().newCDPSession(page);
    const draw = async (to: number) => {
      const handle = await page.locator('.panel-handle').boundingBox();
      const [x, y] = [(handle?.x ?? 0) + (handle?.width ?? 0) / 2, (handle?.y ?? 0) + (handle?.height ?? 0) / 2];
      await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
      for (const share of [0.3, 0.6, 1]) {
        const touchPoints = [{ x, y: y + share * to }];
        await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints });
      }
      await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    };
    await draw(-300);
    await expect(page.locator('.panel')).toHaveAttribute('data-open', 'true');
    await expect(page.locator('.message.summary')).toHaveCount(0);
    await draw(-40);
    await expect(page.locator('.panel')).toHaveAttribute('data-open', 'true');
    await draw(200);
    await expect(page.locator('.panel')).toHaveAttribute('data-open', 'false');
    await page.locator('.panel-handle').tap();
    await expect(page.locator('.panel')).toHaveAttribute('data-open', 'true');
  });

  test('a tap sets the source, with the Add tool it adds one, a long press places the walker', async ({
    heatwalk,
    page,
  }) => {
    await heatwalk.open();
    await page.touchscreen.tap(...(await heatwalk.pixelOnModel()));
    await expect.poll(async () => 'face' in (await heatwalk.scene()).sources[0]).toBe(true);
    await page.getByRole('button', { name: 'Add' }).tap();
    await page.touchscreen.tap(...(await heatwalk.pixelOnModel(0.1, 0.04)));
    await expect.poll(async () => (await heatwalk.scene()).sources.length).toBe(2);

    const [x, y] = await heatwalk.pixelOnModel(-0.1, 0.05);
    const client = await page.context().newCDPSession(page);
    await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
    await expect.poll(async () => (await heatwalk.scene()).walker).toHaveProperty('face');
    await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    expect((await heatwalk.scene()).sources).toHaveLength(2);
  });

  test('a pinch zooms in', async ({ heatwalk, page }) => {
    await heatwalk.open();
    const distance = () => page.evaluate(() => window.heatwalk.camera?.[2] ?? Number.NaN);
    const before = await distance();
    const client = await page.context().newCDPSession(page);
    await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(40) });
    for (const spread of [50, 65, 80]) {
      await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: fingers(spread) });
    }
    await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await expect.poll(distance).toBeLessThan(0.7 * before);
  });
});

for (const [width, height] of [
  [390, 844],
  [844, 390],
] as const) {
  test.describe(`in a window of ${width} × ${height}`, () => {
    test.use({ viewport: { width, height } });

    test('one message at a time lies over the model', async ({ heatwalk, page }) => {
      await heatwalk.open('#v=1&m=bunny&open=kitchen&links=2');
      await expect(page.locator('.message')).toHaveCount(3);
      const seen = page.locator('.message:visible');
      await expect(seen).toContainText('links=2');
      await page.keyboard.press('Escape');
      await expect(seen).toContainText('open=kitchen is invalid');
      await page.getByRole('button', { name: 'Close the message' }).click();
      await expect(page.locator('.notice')).toHaveCount(0);
    });
  });
}

for (const locale of ['en-US', 'fr-FR']) {
  test.describe(`in ${locale}`, () => {
    test.use({ locale });

    test('the tools have their place beside the panel', async ({ heatwalk, page }) => {
      await heatwalk.open('#v=1&m=hemisphere');
      const [tools, panel] = [page.locator('.toolbar'), page.locator('.panel')];
      for (const width of [1800, 1290, 1280, 1270, 1200, 1130, 1120, 1110, 1000, 800, 720]) {
        await page.setViewportSize({ width, height: 800 });
        for (const tab of ['scene', 'ground', 'inside']) {
          await page.locator(`#tab-${tab}`).click();
          const [bar, beside] = [await tools.boundingBox(), await panel.boundingBox()];
          expect(bar?.x, `${tab} at ${width}`).toBeGreaterThanOrEqual(0);
          expect((bar?.x ?? 0) + (bar?.width ?? 0), `${tab} at ${width}`).toBeLessThanOrEqual(beside?.x ?? 0);
        }
      }
    });
  });
}

test('what was opened is said below the model, over no tool, and beside the hint or before it', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#v=1&m=hemisphere');
  await heatwalk.settled();
  const [message, hint, tools] = ['.message.summary', '.hint', '.toolbar'].map((part) => page.locator(part));
  // It stays while something of it has the focus.
  await page.getByRole('button', { name: 'Close the message' }).focus();
  for (const [width, height] of [
    [1800, 900],
    [1400, 900],
    [1290, 700],
    [1100, 720],
    [1000, 700],
    [972, 600],
    [960, 600],
    [720, 900],
  ] as const) {
    await page.setViewportSize({ width, height });
    // What floats over the model follows the window with its next pictures.
    await expect(async () => {
      const [said, below] = [await message.boundingBox(), await tools.boundingBox()];
      if (!said || !below) throw new Error('something is not there');
      const shown = (await hint.isVisible()) ? await hint.boundingBox() : null;
      expect(shown !== null, `the hint at ${width} × ${height}`).toBe(width >= 1100);
      for (const other of shown ? [shown, below] : [below]) {
        const isBeside = said.x + said.width <= other.x || other.x + other.width <= said.x;
        expect(isBeside || said.y + said.height <= other.y, `${width} × ${height}`).toBe(true);
      }
      const foot = await page.evaluate(() => 2 * window.heatwalk.centre[1]);
      const heading = await page.locator('.heading').boundingBox();
      // In the narrowest it takes two lines.
      const least = foot - (heading?.y ?? 0) - (heading?.height ?? 0) - (width < 960 ? 40 : 0);
      expect(said.y, `${width} × ${height}`).toBeGreaterThanOrEqual(least);
    }).toPass();
  }
  await page.keyboard.press('Enter');
  await expect(hint).toBeVisible();
});

test('the hint keeps beside what failed', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=hemisphere');
  await heatwalk.closeSummary();
  await heatwalk.drop([['none.off', 'OFF\n3 1 0\n']]);
  const [message, hint] = [page.locator('.message.error'), page.locator('.hint')];
  for (const [width, height] of [
    [1400, 900],
    [1100, 720],
    [1000, 700],
  ] as const) {
    await page.setViewportSize({ width, height });
    await expect(async () => {
      const said = await message.boundingBox();
      const shown = (await hint.isVisible()) ? await hint.boundingBox() : null;
      if (!said) throw new Error('Nothing is said.');
      expect(shown !== null, `the hint at ${width} × ${height}`).toBe(width >= 1100);
      if (shown) expect(said.x + said.width, `${width} × ${height}`).toBeLessThanOrEqual(shown.x);
    }).toPass({ timeout: 10_000 });
  }
});

test('a window of another shape shows as much of the model', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  await page.mouse.wheel(0, 200);
  await heatwalk.rest();
  const before = await heatwalk.page.evaluate(() => window.heatwalk.camera);
  /** Pixels of the model, and how many there would be of one that fills the free area. */
  const seen = async () => {
    const { data } = await heatwalk.drawing(0.5, true);
    let opaque = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] === 255) opaque += 1;
    return opaque;
  };
  await page.setViewportSize({ width: 844, height: 390 });
  await heatwalk.rest();
  const landscape = await seen();
  await page.setViewportSize({ width: 390, height: 844 });
  await heatwalk.rest();
  const portrait = await seen();
  expect(portrait / landscape).toBeGreaterThan(0.5);
  expect(portrait / landscape).toBeLessThan(2);
  await page.setViewportSize({ width: 1100, height: 720 });
  await heatwalk.rest();
  const after = await heatwalk.page.evaluate(() => window.heatwalk.camera);
  expect(after?.[2]).toBeCloseTo(before?.[2] ?? Number.NaN);
});

test('where frames are slow, fewer pixels are drawn while something moves, and all of them at rest', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  // By the clock of its frames the device is so slow that with all pixels what moves waits between two of them.
  await page.addInitScript(() => {
    const next = requestAnimationFrame.bind(globalThis);
    let clock = performance.now();
    globalThis.requestAnimationFrame = (callback) =>
      next(() => {
        const { width = 0, height = 0 } = document.querySelector('canvas') ?? {};
        clock += (width * height) / 375;
        callback(clock);
      });
  });
  await page.goto('./?gpu=webgl#v=1&m=icosphere');
  await page.evaluate(() => window.heatwalk.ready);
  const drawn = () =>
    page.evaluate(() => {
      const canvas = document.querySelector('canvas');
      return canvas ? canvas.width / (devicePixelRatio * canvas.clientWidth) : Number.NaN;
    });
  await page.getByRole('button', { name: 'Pause' }).click();
  await expect.poll(drawn).toBeCloseTo(1, 2);
  await openSection(page, 'numbers');
  await page.getByRole('button', { name: 'Resume' }).click();
  await expect.poll(drawn).toBeLessThan(0.8);
  await expect(page.locator('#section-numbers')).toContainText(/Pixels drawn\d?\d %/);
  await page.getByRole('button', { name: 'Pause' }).click();
  await expect.poll(drawn).toBeCloseTo(1, 2);
});

test('kiosk=1 hides the panel', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&kiosk=1');
  await expect(page.getByRole('toolbar')).toBeVisible();
  await expect(page.locator('.panel')).toHaveCount(0);
});

test('the panel collapses and remembers its sections', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await openSection(page, 'charts');
  await expect.poll(() => page.evaluate(() => localStorage.getItem('heatwalk.panel'))).toContain('"charts":true');
  await heatwalk.open();
  await expect(page.locator('#section-charts')).toHaveAttribute('open');
  await page.getByRole('button', { name: 'Collapse the panel' }).click();
  await expect(page.getByRole('button', { name: 'Open a file…' })).toBeHidden();
});

test('the panel remembers sections by the names of earlier versions', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await page.evaluate(() => localStorage.setItem('heatwalk.panel', '{"look":false,"show":false}'));
  await heatwalk.open();
  await expect(page.locator('#section-style')).not.toHaveAttribute('open');
  await expect(page.locator('#section-display')).not.toHaveAttribute('open');
});

test('every control has a name', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll('button, input, select')]
      .filter((control) => {
        const label =
          control instanceof HTMLInputElement || control instanceof HTMLSelectElement ? control.labels?.[0] : null;
        return !(control.getAttribute('aria-label') ?? label?.textContent ?? control.textContent)?.trim();
      })
      .map((control) => control.outerHTML),
  );
  expect(nameless).toEqual([]);
});

test('with reduced motion the walker stays at its start', async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await heatwalk.open();
  await page.mouse.move(...(await heatwalk.pixelOnModel()));
  await heatwalk.rest();
  expect(await page.evaluate(() => window.heatwalk.walker)).toMatchObject({ arc: 0, arrived: false });
});
