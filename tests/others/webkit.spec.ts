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

test.beforeAll(async () => {
  host = await Host.start();
  webkit = await WebKit.start(binary ?? '', WIDTH, HEIGHT);
});

test.afterAll(async () => {
  await webkit.stop();
  await host.stop();
});

test('in WebKit a first visit opens a file, clicks, drags, draws, and follows a link', async () => {
  const scene = () => webkit.evaluate<SceneState>('window.heatwalk.scene');
  const settled = () => webkit.evaluate('window.heatwalk.settled()');
  await webkit.goto(`${host.page}#m=icosphere`);
  await settled();
  expect(await webkit.evaluate('window.heatwalk.backend')).toBe('WebGL2');

  // WebKit lets no script make a drop of files.
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

  await webkit.goto(`${host.page}#m=torus&s=12&look=gold`);
  await expect.poll(() => webkit.evaluate('window.heatwalk.mesh?.name')).toBe('torus');
  await settled();
  expect(await scene()).toMatchObject({ sources: [{ vertex: 12 }], style: { name: 'gold' } });
  expect(await webkit.evaluate('document.querySelector("[role=alert]").textContent')).toBe('');
});
