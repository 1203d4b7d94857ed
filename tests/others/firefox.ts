/** Firefox on a display of its own: its headless mode has no WebGL. */
import { type ChildProcess, spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Browser, launch, type Page } from 'puppeteer-core';

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
    readonly display: ChildProcess,
  ) {}

  static async start(width: number, height: number): Promise<Firefox> {
    const saved = mkdtempSync(join(tmpdir(), 'heatwalk-'));
    const { display, number } = await startDisplay(width, height);
    const browser = await launch({
      browser: 'firefox',
      executablePath: PROGRAM,
      headless: false,
      defaultViewport: { width, height },
      extraPrefsFirefox: { ...PREFERENCES, 'browser.download.dir': saved },
      env: { ...process.env, DISPLAY: `:${number}`, LIBGL_ALWAYS_SOFTWARE: '1' },
    });
    return new Firefox(await browser.newPage(), saved, browser, display);
  }

  async stop(): Promise<void> {
    await this.browser.close();
    this.display.kill();
    rmSync(this.saved, { recursive: true, force: true });
  }
}

/** A virtual screen, which chooses a number that is free. */
async function startDisplay(width: number, height: number): Promise<{ display: ChildProcess; number: string }> {
  const screen = `${width + 100}x${height + 200}x24`;
  const display = spawn('Xvfb', ['-displayfd', '1', '-screen', '0', screen, '-nolisten', 'tcp'], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const number = await new Promise<string>((resolve, reject) => {
    display.on('error', reject);
    display.on('exit', () => reject(new Error('The virtual screen could not be started.')));
    display.stdout.once('data', (told: Buffer) => resolve(told.toString().trim()));
  });
  return { display, number };
}
