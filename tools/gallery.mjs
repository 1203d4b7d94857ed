// npm run gallery [-- FIGURE ...]: draws the images of docs/gallery.md with the built page and writes that document; and the
// thumbnails of the presets. With names of figures and presets, only their images.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { FIGURES } from './gallery/figures.mjs';
import { galleryText } from './gallery/text.mjs';
import { bundle, publishModules } from './bundle.mjs';
import { ALWAYS, WEBGL } from './chromium.mjs';
import { prepare, requireChromium } from './needs.mjs';
import { root } from './steps.mjs';

const WINDOW = { width: 720, height: 540 };
const QUALITY = 0.86;
const FOLDER = join(root, 'docs', 'gallery');
const THUMBNAILS = join(root, 'web', 'thumbnails');
/** Twice what the panel shows, for screens with two pixels to one. */
const THUMBNAIL = { width: 168, height: 126 };

prepare();
publishModules();
bundle();

const wanted = process.argv.slice(2);
const server = await preview({ root, logLevel: 'error' });
const browser = await chromium.launch({
  executablePath: requireChromium(),
  args: [...ALWAYS, ...WEBGL],
  ignoreDefaultArgs: ['--disable-gpu'],
});
const tab = await browser.newPage({ viewport: WINDOW, reducedMotion: 'reduce', colorScheme: 'light' });
mkdirSync(FOLDER, { recursive: true });

const figures = [];
for (const { name, title, text, panels, whole = false } of FIGURES) {
  const drawn = [];
  for (const [index, [caption, link, line]] of panels.entries()) {
    const file = `${name}-${index + 1}.jpg`;
    const sources = line ? await sourcesOf(link, line) : '';
    drawn.push({ caption, file, fragment: `#v=1&${link}${sources}` });
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const bytes = await draw(link + sources, { ...WINDOW, type: 'image/jpeg', clear: false, whole });
    writeFileSync(join(FOLDER, file), bytes);
    console.log(`${file}: ${caption}`);
  }
  figures.push({ title, text, panels: drawn });
}
writeFileSync(join(root, 'docs', 'gallery.md'), galleryText(figures));
await drawThumbnails();
await browser.close();
await server.close();

async function drawThumbnails() {
  mkdirSync(THUMBNAILS, { recursive: true });
  await open('/?resolution=full&gpu=webgl');
  for (const id of await tab.evaluate(() => window.heatwalk.presets)) {
    if (wanted.length > 0 && !wanted.includes(id)) continue;
    const image = { ...THUMBNAIL, type: 'image/webp', clear: true, whole: false };
    writeFileSync(join(THUMBNAILS, `${id}.webp`), await draw(`m=${id}&w=none`, image));
    console.log(`${id}.webp`);
  }
}

/** The address of a scene. */
function addressOf(link) {
  return `/?resolution=full&gpu=webgl#v=1&${link}&kiosk=1`;
}

/** Sources under a line, for the link of a scene. */
async function sourcesOf(link, line) {
  await open(addressOf(link));
  return tab.evaluate(sourcesUnder, { line, ...WINDOW });
}

/** The image of a scene in a size and type. */
async function draw(link, image) {
  await open(addressOf(link));
  const base64 = await tab.evaluate(picture, { ...image, quality: QUALITY });
  return Buffer.from(base64, 'base64');
}

async function open(address) {
  await tab.goto('about:blank');
  await tab.goto(new URL(address, server.resolvedUrls.local[0]).href);
  await tab.evaluate(async () => {
    await window.heatwalk.ready;
    await window.heatwalk.settled();
  });
}

/** Runs in the page: the places of the model under points of the window, as a link writes them. */
function sourcesUnder({ line, width, height }) {
  const places = line.map(([x, y]) => window.heatwalk.placeAt(x * width, y * height)).filter(Boolean);
  const points = places.map(({ face, weights }) => `${face}:${weights.map((weight) => weight.toFixed(3)).join('/')}`);
  return `&s=${points.join(',')}`;
}

/** Runs in the page: the scene as an image file, base64, cut to the model unless it fills the window or is wanted `whole`. */
async function picture({ width, height, type, quality, clear, whole }) {
  const margin = 0.06;
  let place = '';
  while (place !== JSON.stringify(window.heatwalk.camera)) {
    place = JSON.stringify(window.heatwalk.camera);
    await new Promise((resolve) => setTimeout(resolve, 300));
  }
  const outline = await createImageBitmap(await window.heatwalk.picture(1, true));
  const finder = new OffscreenCanvas(outline.width, outline.height).getContext('2d');
  finder.drawImage(outline, 0, 0);
  const { data } = finder.getImageData(0, 0, outline.width, outline.height);
  let [left, top, right, bottom] = [outline.width, outline.height, 0, 0];
  for (let pixel = 0; pixel < data.length / 4; pixel++) {
    // The shadow on the floor is never opaque.
    if (data[4 * pixel + 3] < 250) continue;
    const [x, y] = [pixel % outline.width, Math.floor(pixel / outline.width)];
    [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
  }
  const aspect = width / height;
  const room = 1 + 2 * margin;
  const fitting = Math.min(outline.width, room * Math.max(right - left, aspect * (bottom - top)));
  const across = whole ? outline.width : fitting;
  const x = Math.min(Math.max(0, (left + right - across) / 2), outline.width - across);
  const y = Math.min(Math.max(0, (top + bottom - across / aspect) / 2), outline.height - across / aspect);

  const scale = 2;
  const scene = await createImageBitmap(await window.heatwalk.picture(scale, clear, whole));
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  context.drawImage(scene, scale * x, scale * y, scale * across, (scale * across) / aspect, 0, 0, width, height);
  const file = await canvas.convertToBlob({ type, quality });
  const bytes = new Uint8Array(await file.arrayBuffer());
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}
