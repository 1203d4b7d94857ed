/** The legend: what it tells, where it stands, and that it is in what is saved. */
import fs from 'node:fs';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { grid, off } from '../fixtures';
import { expect, openSection, SEEN, test, difference } from '../page';

test.use(SEEN);

const legend = (page: Page) => page.getByRole('region', { name: 'Legend' });
const words = (page: Page) => legend(page).getByRole('img').getAttribute('aria-label');

const N = 24;
/** A square of 1 m seen from above. */
const SQUARE = `up=z&unit=m&cam=0,1.5707963,2.6,0,0,0&s=0&method=auto&w=none`;

/** The length of the scale bar as it is drawn, CSS pixels: the lowest line of the legend. */
function barLength(page: Page): Promise<number> {
  return legend(page)
    .locator('canvas')
    .evaluate((canvas: HTMLCanvasElement) => {
      const row = canvas.getContext('2d')?.getImageData(0, canvas.height - 11, canvas.width, 1).data ?? [];
      return Array.from(row).filter((value, i) => i % 4 === 3 && value > 128).length;
    });
}

test('it tells heat and error where these are shown, and costs', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny&paint=heat');
  await expect.poll(() => words(page)).toMatch(/Heat \(log scale\): from 1 to 10⁻[⁰¹²³⁴-⁹]+, by color\. Scale bar/);
  await heatwalk.open('#v=1&m=bunny&paint=error');
  await expect.poll(() => words(page)).toMatch(/Relative error: from 0 % to [\d.]+ %, by color/);
  await heatwalk.open('#v=1&m=hike');
  await expect.poll(() => words(page)).toContain('Least cost (units)');
});

test('L and the switch hide it, arrows and the pointer move it, and the page remembers both', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open('#v=1&m=teapot');
  await expect(legend(page)).toBeVisible();
  const before = await legend(page).boundingBox();
  await legend(page).focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowDown');
  const nudged = await legend(page).boundingBox();
  expect([(nudged?.x ?? 0) - (before?.x ?? 0), (nudged?.y ?? 0) - (before?.y ?? 0)]).toEqual([8, 8]);
  // The arrows did not turn the model.
  expect((await heatwalk.scene()).camera).toBeNull();
  const { x, y } = nudged ?? { x: 0, y: 0 };
  await page.mouse.move(x + 10, y + 10);
  await page.mouse.down();
  await page.mouse.move(x + 310, y + 210, { steps: 3 });
  await page.mouse.up();
  const moved = await legend(page).boundingBox();
  expect([moved?.x, moved?.y]).toEqual([x + 300, y + 200]);

  await heatwalk.open('#v=1&m=teapot');
  await expect(legend(page)).toBeVisible();
  const again = await legend(page).boundingBox();
  expect(again?.x).toBeCloseTo(x + 300, 0);
  expect(again?.y).toBeCloseTo(y + 200, 0);

  await page.keyboard.press('l');
  await expect(legend(page)).toBeHidden();
  await heatwalk.open('#v=1&m=teapot');
  await openSection(page, 'display');
  await expect(page.getByRole('switch', { name: 'Legend' })).not.toBeChecked();
  await expect(legend(page)).toBeHidden();
  await page.getByRole('switch', { name: 'Legend' }).check();
  await expect(legend(page)).toBeVisible();
});

/** Names of what lies over the legend, or under it. */
function overlapping(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const box = document.querySelector('.legend')?.getBoundingClientRect() ?? new DOMRect();
    const isOver = (other: DOMRect) =>
      other.width > 0 &&
      other.left < box.right &&
      other.right > box.left &&
      other.top < box.bottom &&
      other.bottom > box.top;
    return [...document.querySelectorAll('.panel, .heading, .toolbar, .hint, .message')]
      .filter((other) => isOver(other.getBoundingClientRect()))
      .map(({ className }) => className);
  });
}

test('it stays beside whatever else floats, wherever it is dragged, and in a smaller window', async ({
  heatwalk,
  page,
}) => {
  // With a message that stays.
  await heatwalk.open('#v=1&m=icosphere&open=kitchen');
  await expect(legend(page)).toBeVisible();
  const dragTo = async (x: number, y: number) => {
    const box = await legend(page).boundingBox();
    if (!box) throw new Error('no legend');
    await page.mouse.move(box.x + 10, box.y + 10);
    await page.mouse.down();
    await page.mouse.move(x, y, { steps: 2 });
    await page.mouse.up();
  };
  const { x = 0, y = 0, width = 0 } = (await page.getByRole('toolbar').boundingBox()) ?? {};
  for (const [left, top] of [
    [x + width / 2, y + 10],
    [0, 0],
    [0, 900],
    [1400, 450],
  ]) {
    await dragTo(left, top);
    expect(await overlapping(page), `${left}, ${top}`).toEqual([]);
  }
  // The first place is kept as shares of the window, which mean another place in another one.
  await dragTo(x, y - 60);
  for (const [across, down] of [
    [1100, 720],
    [800, 600],
    [390, 844],
  ]) {
    await page.setViewportSize({ width: across, height: down });
    await expect.poll(() => overlapping(page), { message: `${across} × ${down}` }).toEqual([]);
  }
});

function bounds(values: readonly number[]): number[] {
  return values.reduce(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [1e9, -1]);
}

test.describe(() => {
  // Its pixels are those of the window.
  test.use({ deviceScaleFactor: 1 });

  test('it tells what the colors mean in the unit that is shown, and a length that is true in the middle of the model', async ({
    heatwalk,
    page,
  }) => {
    await heatwalk.openFile('square.off', off(grid(N)), SQUARE);
    await heatwalk.settled();
    await expect.poll(() => words(page)).toContain('Distance (m): from 0 to 1.41 m, by color. Stripes 0.0707 m apart.');
    expect(await words(page)).toContain('Up is Z.');

    const middle = (N / 2) * (N + 1) + N / 2;
    const [from, to] = [await heatwalk.pixelOf({ vertex: middle }), await heatwalk.pixelOf({ vertex: middle + 1 })];
    const meter = N * Math.hypot(to[0] - from[0], to[1] - from[1]);
    const [, length] = /Scale bar: ([\d.]+) m\./.exec((await words(page)) ?? '') ?? [];
    expect(Math.abs((await barLength(page)) - Number(length) * meter)).toBeLessThan(1.5);

    await page.getByLabel('Convert to').selectOption('cm');
    await expect.poll(() => words(page)).toContain('Distance (cm): from 0 to 141 cm, by color. Stripes 7.07 cm apart.');
    expect(await words(page)).toContain(`Scale bar: ${100 * Number(length)} cm.`);
  });

  test('it is in saved images unless it is hidden, at their resolution, and in pictures of scripts that ask for it', async ({
    heatwalk,
    page,
  }) => {
    await heatwalk.open('#v=1&m=teapot');
    await heatwalk.settled();
    await expect(legend(page)).toBeVisible();
    await openSection(page, 'share');
    const saved = async () => {
      const saving = page.waitForEvent('download');
      await page.getByRole('button', { name: 'Save image' }).click();
      return PNG.sync.read(fs.readFileSync(await (await saving).path()));
    };
    /** The first and last column and row of the pixels that differ from a picture without it. */
    const traces = async (picture: PNG) => {
      const plain = await heatwalk.drawing(2, false);
      expect([picture.width, picture.height]).toEqual([plain.width, plain.height]);
      const places: [number, number][] = [];
      picture.data.forEach((value, i) => {
        if (value !== plain.data[i]) places.push([(i >> 2) % plain.width, Math.floor((i >> 2) / plain.width)]);
      });
      const [xs, ys] = [places.map(([x]) => x), places.map(([, y]) => y)];
      return { columns: bounds(xs), rows: bounds(ys) };
    };
    const box = await legend(page).boundingBox();
    if (!box) throw new Error('no legend');
    const { columns, rows } = await traces(await saved());
    // Twice as large, in the corner.
    expect(columns[0]).toBeGreaterThanOrEqual(22);
    expect(columns[1] - columns[0]).toBeGreaterThan(2 * box.width - 8);
    expect(columns[1]).toBeLessThanOrEqual(24 + 2 * box.width + 2);
    expect(rows[1] - rows[0]).toBeGreaterThan(2 * box.height - 8);
    expect(rows[1]).toBeLessThanOrEqual(24 + 2 * box.height + 2);

    const bytes = (isAsked: boolean) =>
      page.evaluate(async (asked) => (await window.heatwalk.picture(1, false, asked)).size, isAsked);
    expect(await bytes(true)).toBeGreaterThan((await bytes(false)) + 500);

    await page.keyboard.press('l');
    await expect(legend(page)).toBeHidden();
    expect((await traces(await saved())).columns).toEqual([1e9, -1]);
  });

  test('it is in frames, in forced colors too', async ({ heatwalk, page }) => {
    await page.emulateMedia({ forcedColors: 'active' });
    await page.setViewportSize({ width: 800, height: 600 });
    await heatwalk.open('#v=1&m=bunny&kiosk=1');
    await expect(legend(page)).toBeVisible();
    const darkest = await legend(page)
      .locator('canvas')
      .evaluate((canvas: HTMLCanvasElement) => {
        // Text on a ground of the system, in its color for text: black here.
        const row = canvas.getContext('2d')?.getImageData(0, 16, canvas.width, 1).data ?? [];
        return Array.from({ length: row.length / 4 }).some((_, i) => row[4 * i + 3] > 250 && row[4 * i] < 16);
      });
    expect(darkest).toBe(true);
  });
});

for (const [width, height] of [
  [390, 844],
  [320, 640],
]) {
  test(`it does not cover the model in a window of ${width} × ${height}`, async ({ heatwalk, page }) => {
    await page.setViewportSize({ width, height });
    await heatwalk.open('#v=1&m=torus');
    for (const preset of ['bunny', 'teapot', 'horse', 'dragon', 'terrain']) {
      await heatwalk.follow(`#v=1&m=${preset}`);
      await expect(legend(page)).toBeVisible();
      const box = await legend(page).boundingBox();
      if (!box) throw new Error('no legend');
      const covered = await page.evaluate(({ x, y, width: across, height: down }) => {
        const places = [];
        for (let i = 0; i <= 10; i++)
          for (let j = 0; j <= 10; j++)
            if (window.heatwalk.placeAt(x + (across * i) / 10, y + (down * j) / 10)) places.push([i, j]);
        return places;
      }, box);
      expect(covered, preset).toEqual([]);
    }
  });
}

test('views are chosen by a menu, by mouse and keyboard, and by keys', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=bunny');
  const looks = async () => {
    await heatwalk.rest();
    return (await page.evaluate(() => window.heatwalk.camera))?.slice(0, 2);
  };
  const button = page.getByRole('button', { name: 'Views' });
  const menu = page.getByRole('menu', { name: 'Views' });
  await button.click();
  await menu.getByRole('menuitem', { name: 'Top' }).click();
  await expect(menu).toBeHidden();
  expect(await looks()).toEqual([0, Math.PI / 2]);
  // It is in the link.
  await expect.poll(async () => (await heatwalk.scene()).camera?.[1]).toBe(Math.PI / 2);

  await button.focus();
  await page.keyboard.press('Enter');
  await expect(menu.getByRole('menuitem', { name: 'Front' })).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  expect(await looks()).toEqual([Math.PI / 2, 0]);
  await expect(button).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(menu).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(menu).toBeHidden();

  await page.keyboard.press('8');
  await expect.poll(looks).toEqual([0, 0]);
  // All of the model is seen.
  const box = await page.locator('.stage').boundingBox();
  for (const vertex of [0, 500, 1000, 1500]) {
    const [x, y] = await heatwalk.pixelOf({ vertex });
    expect(x > 0 && x < (box?.width ?? 0) && y > 0 && y < (box?.height ?? 0)).toBe(true);
  }
  // Parallel lines of sight: what is picked there is what is drawn there, at other pixels than in perspective.
  const perspective = await heatwalk.lastPicture();
  await page.keyboard.press('v');
  await expect.poll(() => page.url()).toContain('&ortho=1');
  const parallel = await heatwalk.picture();
  expect(difference(perspective, parallel)).toBeGreaterThan(0.01);
  const [x, y] = await heatwalk.page.evaluate(() => window.heatwalk.centre);
  const place = await page.evaluate(([right, down]) => window.heatwalk.placeAt(right, down), [x + 30, y + 40] as const);
  if (!place) throw new Error('the model is not there');
  const [right, down] = await heatwalk.pixelOf(place);
  expect(Math.hypot(right - x - 30, down - y - 40)).toBeLessThan(0.5);
  await button.click();
  await expect(menu.getByRole('menuitemcheckbox', { name: 'Orthographic' })).toHaveAttribute('aria-checked', 'true');
  await menu.getByRole('menuitemcheckbox').click();
  await expect.poll(() => page.url()).not.toContain('ortho');
  await expect.poll(async () => difference(perspective, await heatwalk.picture())).toBeLessThan(0.002);
  await heatwalk.open('#v=1&m=bunny&cam=0,0,4,0,0,0&ortho=1');
  expect(await page.evaluate(() => window.heatwalk.scene.orthographic)).toBe(true);

  await page.keyboard.press('x');
  await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(true);
  await page.keyboard.press('x');
  await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(false);
});
