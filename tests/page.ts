/** What the browser tests share: the page on the project's backend, files dropped on it, pictures read from it. */
import { expect, type Locator, type Page, test as base } from '@playwright/test';
import { PNG } from 'pngjs';
import type { MeshPoint } from '../web/protocol';
import { cameraAtRest } from './rest';

export { expect };

/** For tests that look at pixels: of the 110 × 72 that others get, too little is seen. */
export const SEEN = { deviceScaleFactor: 0.25 };

export type DroppedFile = [name: string, content: string | Buffer];

/** Opens a section of the panel, and the workspace that it is in. */
export async function openSection(page: Page, id: string): Promise<Locator> {
  const section = page.locator(`#section-${id}`);
  const workspace = await section.evaluate((element) => element.closest('[role=tabpanel]')?.id ?? '');
  const tab = page.locator(`[aria-controls="${workspace}"]`);
  if (workspace !== '' && (await tab.getAttribute('aria-selected')) === 'false') await tab.click();
  if ((await section.getAttribute('open')) === null) await section.locator('> summary').click();
  return section;
}

/** Expands every section, and goes through all workspaces with `look`. */
export async function everyWorkspace(page: Page, look: (workspace: string) => Promise<void>): Promise<void> {
  await page.evaluate(() => {
    for (const section of document.querySelectorAll<HTMLDetailsElement>('.panel details')) section.open = true;
  });
  for (const tab of await page.getByRole('tab').all()) {
    await tab.click();
    await look((await tab.getAttribute('id')) ?? '');
  }
}

/** That each of the calls was refused for its reason, and that nothing has changed. */
export function expectRefused(
  { reasons, isKept }: { reasons: readonly string[]; isKept: boolean },
  expected: readonly string[],
): void {
  for (const [index, reason] of expected.entries()) expect(reasons[index]).toContain(reason);
  expect(isKept).toBe(true);
}

export class HeatwalkPage {
  constructor(
    readonly page: Page,
    readonly backend: 'WebGL2' | 'WebGPU',
  ) {}

  /** Opens the page and waits for the first scene; fails unless the project's backend draws it. */
  async open(fragment = ''): Promise<void> {
    // So that pictures do not depend on how fast this machine draws.
    const search = this.backend === 'WebGL2' ? '?resolution=full&gpu=webgl' : '?resolution=full';
    if (this.page.url() !== 'about:blank') await this.page.goto('about:blank');
    await this.page.goto(`./${search}${fragment}`, { waitUntil: 'commit' });
    // In another language than English, modules wait for its texts.
    await this.page.waitForFunction(() => 'heatwalk' in window);
    const backend = await this.page.evaluate(async () => {
      await window.heatwalk.ready;
      return window.heatwalk.backend;
    });
    expect(backend).toBe(this.backend);
    await this.rest();
  }

  /** Follows a link to another mesh, or to the same one by another method; it costs less than opening the page anew. */
  async follow(fragment: string): Promise<void> {
    const solves = await this.solves();
    await this.page.evaluate((link) => {
      location.hash = link;
    }, fragment);
    await expect.poll(() => this.solves()).toBeGreaterThan(solves);
    await this.settled();
    await this.rest();
  }

  /** Opens pages without the legend from now on: it takes clicks on what lies under it. */
  async withoutLegend(): Promise<void> {
    await this.page.addInitScript(() => {
      if (location.protocol !== 'about:') localStorage.setItem('heatwalk.legend', 'off');
    });
  }

  /** Closes what was said on opening, which lies over the model, unless it has gone by itself. */
  async closeSummary(): Promise<void> {
    await this.page.evaluate(() => document.querySelector<HTMLElement>('.message.summary > .close')?.click());
    await expect(this.page.locator('.message.summary')).toHaveCount(0);
  }

  /** Until the camera stands still. */
  async rest(): Promise<void> {
    await this.page.evaluate(cameraAtRest);
  }

  /** Until nothing is being opened, solved or refined. */
  async settled(): Promise<void> {
    await this.page.evaluate(() => window.heatwalk.settled());
  }

  async drop(files: readonly DroppedFile[]): Promise<void> {
    const packed = files.map(([name, content]) => [name, Buffer.from(content).toString('base64')] as const);
    await this.page.evaluate((entries) => {
      const dataTransfer = new DataTransfer();
      for (const [name, content] of entries) {
        const bytes = Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
        dataTransfer.items.add(new File([bytes], name));
      }
      for (const type of ['dragenter', 'dragover', 'drop']) {
        document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
      }
    }, packed);
  }

  async dropAndOpen(files: readonly DroppedFile[]): Promise<void> {
    const solves = await this.solves();
    await this.drop(files);
    await expect.poll(() => this.page.evaluate(() => window.heatwalk.mesh?.name)).toBe(files[0][0]);
    // The mesh before may have had the same name.
    await expect.poll(() => this.solves()).toBeGreaterThan(solves);
    await this.rest();
  }

  /** Until the browser keeps the file that is open, for a visit that comes later. */
  async kept(): Promise<void> {
    const hash = /&hash=([\da-f]+)/.exec(this.page.url())?.[1];
    if (!hash) throw new Error('The address names no file.');
    await expect
      .poll(() =>
        this.page.evaluate(
          (key) =>
            new Promise<boolean>((resolve) => {
              const opening = indexedDB.open('heatwalk', 1);
              // Where none was kept yet, there is nothing to open.
              opening.addEventListener('upgradeneeded', () => opening.transaction?.abort());
              opening.addEventListener('error', () => resolve(false));
              opening.addEventListener('success', () => {
                const asked = opening.result.transaction('files').objectStore('files').getKey(key);
                asked.addEventListener('success', () => {
                  opening.result.close();
                  resolve(asked.result !== undefined);
                });
              });
            }),
          hash,
        ),
      )
      .toBe(true);
  }

  /** Erases the files that the page has kept. */
  async forgetFiles(): Promise<void> {
    // What is kept later would be there.
    await this.kept();
    await this.page.evaluate(
      () =>
        new Promise<void>((resolve, reject) => {
          const erasing = indexedDB.deleteDatabase('heatwalk');
          erasing.addEventListener('success', () => resolve());
          erasing.addEventListener('error', () => reject(new Error('The files were not erased.')));
        }),
    );
  }

  /** Opens a file with the state that a link gives it: `options` as in a link, `s=3&near=0`. */
  async openFile(name: string, content: string, options: string): Promise<void> {
    await this.open(`#v=1&m=file&name=${name}&${options}`);
    await this.dropAndOpen([[name, content]]);
  }

  /** The same without what lies over the model, and with a section of the panel open. */
  async openInSection(section: string, name: string, content: string, options: string): Promise<void> {
    await this.withoutLegend();
    await this.openFile(name, content, options);
    await this.settled();
    await this.closeSummary();
    await openSection(this.page, section);
  }

  scene() {
    return this.page.evaluate(() => window.heatwalk.scene);
  }

  mesh() {
    return this.page.evaluate(() => {
      const { mesh } = window.heatwalk;
      if (!mesh) throw new Error('no mesh');
      return mesh;
    });
  }

  field() {
    return this.page.evaluate(() => {
      const { field } = window.heatwalk;
      if (!field) throw new Error('no field');
      return field;
    });
  }

  refining() {
    return this.page.evaluate(() => window.heatwalk.refining);
  }

  solves(): Promise<number> {
    return this.page.evaluate(() => window.heatwalk.solves);
  }

  distanceAt(point: MeshPoint): Promise<number> {
    return this.page.evaluate((place) => window.heatwalk.distanceAt(place), point);
  }

  async pixelOf(point: MeshPoint): Promise<[number, number]> {
    const pixel = await this.page.evaluate((place) => window.heatwalk.pixelOf(place), point);
    if (!pixel) throw new Error('the place is not in view');
    return pixel;
  }

  /** A pixel on the model, as shares of the free area away from its middle; that area begins at the upper left corner. */
  async pixelOnModel(dx = 0, dy = 0): Promise<[number, number]> {
    const [x0, y0] = await this.page.evaluate(() => window.heatwalk.centre);
    const pixel: [number, number] = [x0 * (1 + 2 * dx), y0 * (1 + 2 * dy)];
    const place = await this.page.evaluate(([x, y]) => window.heatwalk.placeAt(x, y), pixel);
    if (!place) throw new Error(`the model is not at ${pixel.join(', ')}`);
    return pixel;
  }

  /** The scene drawn beside the canvas, with `scale` pixels for a CSS pixel of the window; on a transparent ground if `clear`. */
  async drawing(scale: number, clear: boolean): Promise<PNG> {
    const base64 = await this.page.evaluate(
      async ([times, isClear]) => {
        const picture = await window.heatwalk.picture(times / devicePixelRatio, isClear);
        const bytes = new Uint8Array(await picture.arrayBuffer());
        return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
      },
      [scale, clear] as const,
    );
    return PNG.sync.read(Buffer.from(base64, 'base64'));
  }

  /** The window as drawn once everything has settled, without what floats over the canvas. */
  async picture(): Promise<PNG> {
    await this.settled();
    return this.screen();
  }

  /** The same once it changes no more: where frames are slow, some are drawn after the page has settled. */
  async lastPicture(): Promise<PNG> {
    let last = await this.picture();
    const change = async () => {
      const before = last;
      last = await this.picture();
      return difference(before, last);
    };
    await expect.poll(change, { intervals: [500] }).toBe(0);
    return last;
  }

  /** Adds rules to the page's style until the function that is given back is called; elements with rules are not allowed on the page. */
  async style(rules: string): Promise<() => Promise<void>> {
    const sheet = await this.page.evaluateHandle((text) => {
      const made = new CSSStyleSheet();
      made.replaceSync(text);
      document.adoptedStyleSheets.push(made);
      return made;
    }, rules);
    return () =>
      sheet.evaluate((made) => {
        document.adoptedStyleSheets = document.adoptedStyleSheets.filter((other) => other !== made);
      });
  }

  /** The same at once, whatever is under way. */
  async screen(): Promise<PNG> {
    const end = await this.style('.stage ~ * { visibility: hidden !important }');
    const image = await this.page.screenshot({ scale: 'css' });
    await end();
    return PNG.sync.read(image);
  }
}

export const test = base.extend<{ heatwalk: HeatwalkPage }>({
  heatwalk: async ({ page }, use, info) => {
    const errors: string[] = [];
    page.on('pageerror', (error) => errors.push(error.message));
    await page.addInitScript(() => {
      addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sourceFile, lineNumber }) =>
        reportError(new Error(`Refused by policy: ${violatedDirective} ${blockedURI} ${sourceFile}:${lineNumber}`)),
      );
    });
    await use(new HeatwalkPage(page, info.project.name === 'webgpu' ? 'WebGPU' : 'WebGL2'));
    // A request that comes as the page closes has nobody left to answer to.
    await page.unrouteAll({ behavior: 'ignoreErrors' });
    // The next test has the same browser profile, of which these two are not set back.
    await page.context().setOffline(false);
    await page.context().clearPermissions();
    expect(errors, 'errors that nobody caught').toEqual([]);
  },
});

export function brightness({ data, width }: PNG, x: number, y: number): number {
  const i = 4 * (Math.round(y) * width + Math.round(x));
  return (0.2126 * data[i] + 0.7152 * data[i + 1] + 0.0722 * data[i + 2]) / 255;
}

/** How often the brightness along a vertical line crosses from dark to light or back, by a clear step. */
export function crossings(picture: PNG, x: number, from: number, to: number): number {
  const values: number[] = [];
  for (let y = Math.round(from); y < to; y++) values.push(brightness(picture, x, y));
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const [dark, light] = [low + 0.35 * (high - low), low + 0.65 * (high - low)];
  let state = '';
  let count = 0;
  for (const value of values) {
    const next = value < dark ? 'dark' : value > light ? 'light' : state;
    if (state !== '' && next !== state) count += 1;
    state = next;
  }
  return high - low > 0.25 ? count : 0;
}

/** Share of the pixels of two pictures that differ by more than 8 of 255 in some channel. */
export function difference(a: PNG, b: PNG): number {
  expect([b.width, b.height]).toEqual([a.width, a.height]);
  let differing = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    if ([0, 1, 2].some((channel) => Math.abs(a.data[i + channel] - b.data[i + channel]) > 8)) differing += 1;
  }
  return (4 * differing) / a.data.length;
}
