// node tools/icons.mjs: the page's icons as PNG, from public/icon.svg. A maskable icon has no corners of its own: platforms cut it.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { requireChromium } from './needs.mjs';
import { root } from './steps.mjs';

const folder = join(root, 'public');
const drawing = readFileSync(join(folder, 'icon.svg'), 'utf8');
/** What is drawn lies in the middle 80 % of a maskable icon: its circle of that diameter is never cut. */
const maskable = drawing.replace('rx="96"', '');

const browser = await chromium.launch({ executablePath: requireChromium(), args: ['--no-sandbox'] });
try {
  await draw(drawing, 192, 'icon-192.png');
  await draw(drawing, 512, 'icon-512.png');
  await draw(maskable, 512, 'icon-maskable.png');
} finally {
  await browser.close();
}

async function draw(svg, size, name) {
  const page = await browser.newPage({ viewport: { width: size, height: size } });
  await page.setContent(`<style>body { margin: 0 } svg { display: block }</style>${svg}`);
  await page.screenshot({ path: join(folder, name), omitBackground: true });
  await page.close();
}
