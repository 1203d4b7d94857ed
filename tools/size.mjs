// npm run size: the bytes that the page loads until its first picture, after brotli, by file. Fails where they are more than MOST.

import { Page } from './bench/page.mjs';
import { bytesTable } from './bench/report.mjs';
import { bundle, publishModules } from './bundle.mjs';
import { prepare } from './needs.mjs';

const MOST = 750_000;

prepare();
publishModules();
bundle();
const page = await Page.open();
try {
  const webgpu = await page.firstPicture();
  const webgl2 = await page.firstPicture(false);
  console.log(`\n${bytesTable({ webgpu, webgl2 }).join('\n')}`);
  if (Math.max(webgpu.bytes, webgl2.bytes) > MOST) {
    console.error(`\nThe page loads more than ${MOST.toLocaleString('en')} bytes until its first picture.`);
    process.exitCode = 1;
  }
} finally {
  await page.close();
}
