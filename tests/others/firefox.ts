/** Firefox on a display of its own: its headless mode has no WebGL. */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Browser, launch, type Page } from 'puppeteer-core';
import { type Screen, startScreen } from './screen';

/** WebGL by software, and files saved without a question. */
const PREFERENCES = {
  'webgl.force-enabled': true,
  'webgl.disable-fail-if-major-performance-caveat': true,
  'gfx.webrender.software': true,
  'browser.download.folderList': 2,
  'browser.download.always_ask_before_handling_new_types': false,
  'browser.helperApps.neverAsk.saveToDisk': 'image/png',
  'datareporting.policy.dataSubmissionEnabled': false,
};

/** Where Firefox is, if it is anywhere. */
export const PROGRAM = process.env['FIREFOX'] ?? '/usr/bin/firefox-esr';

export class Firefox {
  private constructor(
    readonly page: Page,
    /** Where files are saved. */
    readonly saved: string,
    readonly browser: Browser,
    readonly screen: Screen,
  ) {}

  static async start(width: number, height: number): Promise<Firefox> {
    const saved = mkdtempSync(join(tmpdir(), 'heatwalk-'));
    const screen = await startScreen(width, height);
    const browser = await launch({
      browser: 'firefox',
      executablePath: PROGRAM,
      headless: false,
      defaultViewport: { width, height },
      extraPrefsFirefox: { ...PREFERENCES, 'browser.download.dir': saved },
      env: screen.environment,
    });
    return new Firefox(await browser.newPage(), saved, browser, screen);
  }

  async stop(): Promise<void> {
    await this.browser.close();
    this.screen.display.kill();
    rmSync(this.saved, { recursive: true, force: true });
  }
}
