/** From the empty page to each end in three actions at most, by mouse, keyboard and touch. */
import { readFile } from 'node:fs/promises';
import type { Download, Locator } from '@playwright/test';
import { grid, off } from '../fixtures';
import { expect, type HeatwalkPage, test } from '../page';

const MOST = 3;
const FILE = { name: 'sheet.off', mimeType: 'text/plain', buffer: Buffer.from(off(grid(8))) };

/** Does what a user does, and counts it. Typing a word is one action. */
class User {
  #actions = 0;

  constructor(
    readonly heatwalk: HeatwalkPage,
    readonly isTouching: boolean,
  ) {}

  /** Since the last time. */
  get actions(): number {
    const count = this.#actions;
    this.#actions = 0;
    return count;
  }

  async press(target: Locator): Promise<void> {
    this.#actions += 1;
    await (this.isTouching ? target.tap() : target.click());
  }

  async pressAt(dx: number, dy: number, modifiers: 'ControlOrMeta'[] = []): Promise<void> {
    this.#actions += 1;
    const { page } = this.heatwalk;
    const [x, y] = await this.heatwalk.pixelOnModel(dx, dy);
    if (this.isTouching) return page.touchscreen.tap(x, y);
    for (const key of modifiers) await page.keyboard.down(key);
    await page.mouse.click(x, y);
    for (const key of modifiers) await page.keyboard.up(key);
  }

  async key(key: string): Promise<void> {
    this.#actions += 1;
    await this.heatwalk.page.keyboard.press(key);
  }

  async type(text: string): Promise<void> {
    this.#actions += 1;
    await this.heatwalk.page.keyboard.type(text);
  }

  async choose(target: Locator, label: string): Promise<void> {
    this.#actions += 1;
    await target.selectOption({ label });
  }
}

/** What is pressed to have each end, from the page as it is opened. */
interface Ways {
  file: (user: User) => Promise<void>;
  source: (user: User) => Promise<void>;
  tape: (user: User) => Promise<void>;
  curve: (user: User) => Promise<void>;
  link: (user: User) => Promise<void>;
}

const byName = (user: User, role: 'button' | 'tab', name: string) =>
  user.heatwalk.page.getByRole(role, { name, exact: true });

async function searched(user: User, text: string): Promise<void> {
  await user.key('Control+k');
  await expect(user.heatwalk.page.getByRole('combobox', { name: 'Search settings and commands' })).toBeFocused();
  await user.type(text);
  await user.key('Enter');
}

/** The same for mouse and touch. */
const pressed: Pick<Ways, 'file' | 'tape' | 'curve' | 'link'> = {
  file: async (user) => {
    const { page } = user.heatwalk;
    await user.press(byName(user, 'button', 'Open').first());
    await user.press(page.getByRole('dialog', { name: 'Open' }).getByText('Open a file…'));
  },
  tape: async (user) => {
    await user.press(byName(user, 'button', 'Measure').first());
    await user.pressAt(0.05, 0.02);
    await user.pressAt(-0.08, 0.02);
  },
  curve: async (user) => {
    await user.press(byName(user, 'tab', 'Share'));
    await user.press(byName(user, 'button', 'Save isolines'));
  },
  link: async (user) => {
    await user.press(byName(user, 'button', 'Share'));
    await user.press(byName(user, 'button', 'Copy link'));
  },
};

const WAYS: Record<'mouse' | 'touch' | 'keyboard', Ways> = {
  mouse: { ...pressed, source: (user) => user.pressAt(0.05, 0.02, ['ControlOrMeta']) },
  touch: {
    ...pressed,
    source: async (user) => {
      await user.press(byName(user, 'button', 'Add'));
      await user.pressAt(0.05, 0.02);
    },
  },
  keyboard: {
    file: (user) => user.key('o'),
    source: (user) => user.key('Shift+Enter'),
    tape: (user) => user.key('d'),
    curve: async (user) => {
      await searched(user, 'save isolines');
    },
    link: async (user) => {
      await searched(user, 'copy link');
    },
  },
};

for (const means of ['mouse', 'touch', 'keyboard'] as const) {
  test.describe(means, () => {
    if (means === 'touch') test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

    test(`a file, a source, a tape, a curve at true scale and a link take ${MOST} actions at most`, async ({
      heatwalk,
      page,
    }) => {
      await heatwalk.withoutLegend();
      await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
      // Listened for from the beginning: a key opens the dialog faster than a new listener is heard.
      page.on('filechooser', (chooser) => void chooser.setFiles(FILE));
      await heatwalk.open('#v=1&m=bunny&unit=cm');
      await heatwalk.closeSummary();
      const user = new User(heatwalk, means === 'touch');
      const ways = WAYS[means];
      const counts: Record<string, number> = {};

      await ways.source(user);
      counts['source'] = user.actions;
      await expect.poll(async () => (await heatwalk.scene()).sources.length).toBe(2);

      await ways.tape(user);
      counts['tape'] = user.actions;
      await expect.poll(async () => (await heatwalk.scene()).tapes[0]?.points.length).toBe(2);
      await page.keyboard.press('Escape');

      const saving = page.waitForEvent('download');
      await ways.curve(user);
      counts['curve'] = user.actions;
      expect(await textOf(await saving)).toMatch(/\$INSUNITS\s+70\s+4\b/);

      await ways.link(user);
      counts['link'] = user.actions;
      await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain('#v=1&m=bunny');

      await ways.file(user);
      counts['file'] = user.actions;
      await expect.poll(async () => (await heatwalk.mesh()).name).toBe(FILE.name);
      expect(Object.entries(counts).filter(([, count]) => count > MOST)).toEqual([]);
    });
  });
}

async function textOf(download: Download): Promise<string> {
  return readFile(await download.path(), 'utf8');
}
