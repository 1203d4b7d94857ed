// npm run size: the bytes that the page loads until its first picture, after brotli, by file; fails where they are too many.

import { Page } from './bench/page.mjs';
import { bytesTable } from './bench/report.mjs';
import { bundle, publishModules } from './bundle.mjs';
import { prepare } from './needs.mjs';
import { fail } from './steps.mjs';

/** Bytes of all files until the first picture, on either backend. */
const BAR = 0.75e6;

prepare();
publishModules();
bundle();
const page = await Page.open();
try {
  const webgpu = await page.firstPicture();
  const webgl2 = await page.firstPicture(false);
  console.log(`\n${bytesTable({ webgpu, webgl2 }).join('\n')}`);
  const most = Math.max(webgpu.bytes, webgl2.bytes);
  if (most > BAR) fail(`The first picture takes ${most} bytes; ${BAR} are the most that it may.`);
} finally {
  await page.close();
}
