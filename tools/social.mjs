// node tools/social.mjs: draws public/social.jpg, which is shown beside links to the page, with the modules that were built last
// (`npm start` builds them).

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { bundle, TESTED_PAGE } from './bundle.mjs';
import { ALWAYS, WEBGL } from './chromium.mjs';
import { requireChromium } from './needs.mjs';
import { root } from './steps.mjs';

/** As previews of links have it. */
const SIZE = { width: 1200, height: 630 };
const SCENE = 'm=dragon&look=gold&cam=0.75,0.12,2.75,0,-0.04,0&kiosk=1';
const QUALITY = 80;

bundle(TESTED_PAGE);
const server = await preview({ root, logLevel: 'error', build: { outDir: TESTED_PAGE } });
const browser = await chromium.launch({
  executablePath: requireChromium(),
  args: [...ALWAYS, ...WEBGL],
  ignoreDefaultArgs: ['--disable-gpu'],
});
const tab = await browser.newPage({ viewport: SIZE, reducedMotion: 'reduce', colorScheme: 'light', bypassCSP: true });
await tab.goto(`${server.resolvedUrls.local[0]}?resolution=full&gpu=webgl#v=1&${SCENE}`);
await tab.waitForFunction(() => 'heatwalk' in window);
await tab.evaluate(async () => {
  await window.heatwalk.ready;
  await window.heatwalk.settled();
});
// Nothing but the scene.
await tab.addStyleTag({ content: '.stage ~ * { visibility: hidden !important }' });
const picture = await tab.screenshot({ type: 'jpeg', quality: QUALITY });
writeFileSync(join(root, 'public', 'social.jpg'), picture);
console.log(`public/social.jpg: ${picture.length} bytes`);
await browser.close();
await server.close();
