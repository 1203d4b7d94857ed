// npm run size: the bytes that the page loads until its first picture, after brotli, by file.

import { Page } from './bench/page.mjs';
import { bytesTable } from './bench/report.mjs';
import { buildModules, npmProgram, prepare } from './steps.mjs';

prepare();
buildModules();
npmProgram('Bundling the page into dist/', 'vite/bin/vite.js', ['build', '--logLevel', 'warn'], 'See above.');
const page = await Page.open();
try {
  const webgpu = await page.firstPicture();
  const webgl2 = await page.firstPicture(false);
  console.log(`\n${bytesTable({ webgpu, webgl2 }).join('\n')}`);
} finally {
  await page.close();
}
