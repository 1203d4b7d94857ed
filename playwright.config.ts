import { defineConfig } from '@playwright/test';

/** Another one lets two checkouts be tested side by side. */
const PORT = Number(process.env['PORT'] ?? 4173);

const ALWAYS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
const WEBGL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
/** All of them together: any fewer give a blank canvas without an error. */
const WEBGPU = [
  ...WEBGL,
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--ignore-gpu-blocklist',
];

/** What is looked at on both backends, less the tests in it of what the page does, which is the same on either. */
const DRAWN = /(compare|display|firstvisit|lost|opening|pictures|renderers)\.spec\.ts$/;

const browser = (args: readonly string[]) => ({
  launchOptions: {
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: [...ALWAYS, ...args],
    ignoreDefaultArgs: ['--disable-gpu'],
  },
});

export default defineConfig({
  testDir: 'tests',
  forbidOnly: true,
  // Pictures are drawn by the processor here: two browsers at once only slow each other down.
  workers: 1,
  timeout: 90_000,
  expect: { timeout: 20_000 },
  reporter: [['list']],
  use: {
    baseURL: `http://localhost:${PORT}/`,
    viewport: { width: 1100, height: 720 },
    // Where details of pictures matter, a test asks for all pixels.
    deviceScaleFactor: 0.5,
    screenshot: 'only-on-failure',
    // What a service worker keeps costs time; where it is tested it is allowed.
    serviceWorkers: 'block',
  },
  projects: [
    { name: 'unit', testDir: 'tests/unit' },
    { name: 'webgl', testDir: 'tests/browser', use: browser(WEBGL) },
    // Driven by other means than the rest.
    { name: 'others', testDir: 'tests/others' },
    { name: 'webgpu', testDir: 'tests/browser', testMatch: DRAWN, grepInvert: /@page/, use: browser(WEBGPU) },
  ],
  webServer: {
    // Node itself, not npx: stopping npx would leave its child on the port.
    command: `node node_modules/vite/bin/vite.js preview --port ${PORT} --strictPort`,
    url: `http://localhost:${PORT}/`,
    reuseExistingServer: false,
  },
});
