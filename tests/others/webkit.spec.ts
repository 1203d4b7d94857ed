/** What somebody does at first with the page, in WebKit. */
import { writeFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import type { SceneState } from '../../web/state/scene';
import { off, sphere } from '../fixtures';
import { Host } from '../server';
import { findWebKit, WebKit } from './webkit';

const [WIDTH, HEIGHT] = [900, 700];

const binary = findWebKit();
test.skip(binary === undefined, 'there is no WebKit');

let webkit: WebKit;
let host: Host;
/** Its address. */
let page: string;

test.beforeAll(async () => {
  host = await Host.start();
  page = host.page;
  webkit = await WebKit.start(binary ?? '', WIDTH, HEIGHT);
});

test.afterAll(async () => {
  await webkit.stop();
  await host.stop();
});

/** A page whose modules have run: they may wait for texts beyond its load. */
async function open(address: string): Promise<void> {
  await webkit.goto(`${page}${address}`);
  await expect.poll(() => webkit.evaluate(`'heatwalk' in window`)).toBe(true);
}

test('in WebKit a first visit drops a file, chooses one, clicks, drags, draws, saves, follows a link, and goes on without a network', async () => {
  const scene = () => webkit.evaluate<SceneState>('window.heatwalk.scene');
  const settled = () => webkit.evaluate('window.heatwalk.settled()');
  await open('#m=icosphere');
  await settled();
  expect(await webkit.evaluate('window.heatwalk.backend')).toBe('WebGL2');

  await webkit.evaluate(
    `((content) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], 'dropped.off'));
      for (const type of ['dragenter', 'dragover', 'drop']) {
        document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
      }
    })(...arguments)`,
    off(sphere(9)),
  );
  await expect.poll(() => webkit.evaluate('window.heatwalk.mesh?.name')).toBe('dropped.off');
  await settled();

  const file = test.info().outputPath('ball.off');
  writeFileSync(file, off(sphere(12)));
  await webkit.choose('[aria-label="Open mesh files"]', file);
  await expect.poll(() => webkit.evaluate('window.heatwalk.mesh?.name')).toBe('ball.off');
  await settled();

  // The camera stands still.
  let before = '';
  await expect
    .poll(async () => {
      const last = before;
      before = JSON.stringify(await webkit.evaluate('window.heatwalk.camera'));
      return before === last;
    })
    .toBe(true);
  const [x, y] = await webkit.evaluate<[number, number]>('window.heatwalk.centre');
  await webkit.press([x, y]);
  const place = await webkit.evaluate('window.heatwalk.placeAt(arguments[0], arguments[1])', x, y);
  await expect.poll(async () => (await scene()).sources).toEqual([place]);
  await settled();
  await webkit.press([x, y], [x + 20, y + 5], [x + 40, y + 10]);
  await expect.poll(async () => (await scene()).sources[0]).not.toEqual(place);

  const drawn = await webkit.evaluate<number>(`window.heatwalk.picture().then(async (picture) => {
    const image = await createImageBitmap(picture);
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const colors = new Set();
    for (let at = 0; at < data.length; at += 4) colors.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
    return colors.size;
  })`);
  // A blank canvas has the colors of the background alone.
  expect(drawn).toBeGreaterThan(1000);

  // What is saved, as the browser is given it.
  await webkit.evaluate(`(() => {
    const make = URL.createObjectURL;
    window.given = [];
    URL.createObjectURL = (blob) => (window.given.push(blob), make.call(URL, blob));
    document.getElementById('tab-share').click();
  })()`);
  await expect
    .poll(() => webkit.evaluate('document.querySelector(\'[title="A PNG of the view"]\') !== null'))
    .toBe(true);
  await webkit.evaluate(`document.querySelector('[title="A PNG of the view"]').click()`);
  await expect.poll(() => webkit.evaluate('window.given.length')).toBe(1);
  expect(await webkit.evaluate('createImageBitmap(window.given[0]).then(({ width }) => width)')).toBeGreaterThan(WIDTH);

  // A link to the scene shows it, once it has the file.
  const link = await webkit.evaluate<string>('location.href');
  expect(link).toContain('m=file&name=ball.off');

  await open('#m=torus&s=12&look=gold');
  await expect.poll(() => webkit.evaluate('window.heatwalk.mesh?.name')).toBe('torus');
  await settled();
  expect(await scene()).toMatchObject({ sources: [{ vertex: 12 }], style: { name: 'gold' } });
  expect(await webkit.evaluate('document.querySelector("[role=alert]").textContent')).toBe('');

  // After a visit the page goes on without a network.
  await webkit.evaluate(`(() => {
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  })()`);
  await expect.poll(() => webkit.evaluate('navigator.serviceWorker?.controller?.state ?? null')).toBe('activated');
  await host.stop();
  await open('?again#m=teapot');
  await expect.poll(() => webkit.evaluate('window.heatwalk?.mesh?.name ?? null')).toBe('teapot');
  await settled();
});
