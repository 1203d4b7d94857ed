import { defineConfig } from '@playwright/test';
import { PAGE } from './tests/built';
import { ALWAYS, MESA, OPAQUE, WEBGL, WEBGPU } from './tools/chromium.mjs';
import { hasMesa } from './tools/needs.mjs';

/** Another one lets two checkouts be tested side by side. */
const PORT = Number(process.env['PORT'] ?? 4173);

/** What takes long by nature runs apart from all else. */
const SLOW = /@slow/;
const isSlow = Boolean(process.env['HEATWALK_SLOW']);
const chosen = isSlow ? { grep: SLOW } : { grepInvert: SLOW };

/** What is compared with reference images, which one rasterizer has drawn. */
const PICTURES = /pictures\.spec\.ts$/;
/** What is tried in Chromium as people have it. */
const WHOLE = /(firstvisit|offline)\.spec\.ts$/;
/** What is looked at on both backends, less the tests in it of what the page does, which is the same on either. */
const DRAWN = /(compare|display|lost|opening|pictures|renderers)\.spec\.ts$/;

const CHROMIUM = process.env['CHROMIUM'] ?? '/usr/bin/chromium';
/** Chromium without windows where it is there, in which the page takes four fifths of the time. */
const SHELL = process.env['CHROMIUM_SHELL'] || CHROMIUM;

/** Canvas and page are put together by the processor, which takes a seventh of the time away. */
const FAST = hasMesa() ? [...MESA, '--disable-gpu-compositing'] : WEBGL;

const browser = (executablePath: string, args: readonly string[]) => ({
  launchOptions: {
    executablePath,
    args: [...ALWAYS, ...args],
    ignoreDefaultArgs: ['--disable-gpu'],
    // Mesa draws by the processor wherever the tests run.
    env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: '1' },
  },
});

const SERVER = {
  // Node itself, not npx: stopping npx would leave its child on the port.
  command: `node node_modules/vite/bin/vite.js preview --outDir ${PAGE} --port ${PORT} --strictPort`,
  url: `http://localhost:${PORT}/`,
  reuseExistingServer: false,
};

export default defineConfig({
  testDir: 'tests',
  forbidOnly: true,
  // Pictures are drawn by the processor here, in all cores: two browsers at once take four fifths of the time, and more gain nothing.
  workers: 2,
  // Whatever hangs: what takes longest needs half of it with both cores kept busy beside.
  timeout: 180_000,
  expect: { timeout: 20_000 },
  reporter: [['list']],
  use: {
    baseURL: `http://localhost:${PORT}/`,
    viewport: { width: 1100, height: 720 },
    // Where details of pictures matter, a test asks for more pixels.
    deviceScaleFactor: 0.25,
    screenshot: 'only-on-failure',
    // What a service worker keeps costs time; where it is tested it is allowed.
    serviceWorkers: 'block',
    // A test gets the page of the one before, with its storage and cache emptied: a new profile takes a fifth of all the time.
    reuseContext: true,
    // Nothing moves by itself but where a test is about that: pictures are drawn by the processor here, which has enough to do.
    contextOptions: { reducedMotion: 'reduce' },
  },
  projects: [
    { name: 'unit', testDir: 'tests/unit', ...chosen },
    {
      name: 'webgl',
      testDir: 'tests/browser',
      testIgnore: [PICTURES, WHOLE],
      // Few pixels: what looks at them asks for more.
      use: { ...browser(SHELL, [...FAST, OPAQUE]), deviceScaleFactor: 0.1 },
      ...chosen,
    },
    { name: 'chromium', testDir: 'tests/browser', testMatch: WHOLE, use: browser(CHROMIUM, FAST), ...chosen },
    {
      name: 'pictures',
      testDir: 'tests/browser',
      testMatch: PICTURES,
      use: browser(CHROMIUM, [...WEBGL, OPAQUE]),
      ...chosen,
    },
    // The package of npm under each bundler.
    { name: 'npm', testDir: 'tests/npm', workers: 1, use: browser(SHELL, [...FAST, OPAQUE]), ...chosen },
    // Driven by other means than the rest.
    { name: 'others', testDir: 'tests/others', workers: 1, ...chosen },
    {
      name: 'webgpu',
      testDir: 'tests/browser',
      testMatch: DRAWN,
      use: browser(CHROMIUM, [...WEBGPU, OPAQUE]),
      ...chosen,
      grepInvert: isSlow ? /@page/ : [SLOW, /@page/],
    },
  ],
  // Unit tests alone need no page, which may not be built yet.
  ...(process.env['HEATWALK_NO_PAGE'] ? {} : { webServer: SERVER }),
});
