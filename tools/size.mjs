// npm run size: the bytes that the page loads until its first picture, after brotli, by file.

import { Page } from './bench/page.mjs';
import { bytesTable } from './bench/report.mjs';
import { bundle, publishModules } from './bundle.mjs';
import { prepare } from './needs.mjs';

prepare();
publishModules();
bundle();
const page = await Page.open();
try {
  const webgpu = await page.firstPicture();
  const webgl2 = await page.firstPicture(false);
  console.log(`\n${bytesTable({ webgpu, webgl2 }).join('\n')}`);
} finally {
  await page.close();
}
