import type { Page, Route } from '@playwright/test';
import { strToU8, zipSync } from 'fflate';
import { gltf, obj, off, sphere } from '../fixtures';
import { expect, test } from '../page';

const BALL = sphere(8);
const HOST = 'https://models.example';
const OPEN_TO_ALL = { 'Access-Control-Allow-Origin': '*' };
const OPEN_TO_ANOTHER = { 'Access-Control-Allow-Origin': 'https://elsewhere.example' };

type Served = string | Buffer | ((route: Route) => unknown);

/** Serves files of another host, open to every page; what is not among them is not found. */
async function serve(page: Page, files: Readonly<Record<string, Served>>): Promise<string[]> {
  const asked: string[] = [];
  await page.route(`${HOST}/**`, async (route) => {
    const { pathname } = new URL(route.request().url());
    asked.push(pathname);
    const file = files[pathname];
    if (typeof file === 'function') await file(route);
    else await route.fulfill({ status: file === undefined ? 404 : 200, headers: OPEN_TO_ALL, body: file ?? '' });
  });
  return asked;
}

/** Pastes text, or a file. */
function paste(page: Page, pasted: { text: string } | { name: string; content: string }, target = 'body') {
  return page.evaluate(
    ([what, selector]) => {
      const clipboardData = new DataTransfer();
      if ('text' in what) clipboardData.setData('text/plain', what.text);
      else clipboardData.items.add(new File([what.content], what.name));
      const event = new ClipboardEvent('paste', { bubbles: true, cancelable: true, clipboardData });
      document.querySelector(selector)?.dispatchEvent(event);
    },
    [pasted, target] as const,
  );
}

test('a mesh by a link is offered, fetched when it is opened, and shared with the scene', async ({
  heatwalk,
  page,
}) => {
  const asked = await serve(page, { '/set/ball.off': off(BALL) });
  await heatwalk.open(`#model=${HOST}/set/ball.off&s=5&look=gold`);
  expect((await heatwalk.scene()).mesh).toEqual({ kind: 'preset', id: 'bunny' });
  const offer = page.locator('.message', { hasText: 'This link shows ball.off from models.example.' });
  await expect(offer).toContainText('512 MiB at most');
  expect(asked).toEqual([]);
  await offer.getByRole('button', { name: 'Open', exact: true }).click();
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.off');
  await expect(offer).toBeHidden();
  expect(asked).toEqual(['/set/ball.off']);
  const scene = await heatwalk.scene();
  expect(scene).toMatchObject({ sources: [{ vertex: 5 }], method: 'auto', style: { name: 'gold' } });
  expect(scene.mesh).toMatchObject({ kind: 'address', address: `${HOST}/set/ball.off`, path: '' });
  await expect(page).toHaveURL(/#v=1&model=https:\/\/models\.example\/set\/ball\.off&hash=[\da-f]{64}&s=5&/);
  await expect(page.locator('.heading')).toContainText('ball.off');

  await page.reload();
  await page.evaluate(() => window.heatwalk.ready);
  await expect(offer).toBeVisible();
  expect(asked).toHaveLength(1);
});

test('a mesh of an archive at an address is in the link, and another of it can be opened', async ({
  heatwalk,
  page,
}) => {
  const set = zipSync({ 'cow.obj': strToU8(obj({ cow: BALL })), 'x/horse.off': strToU8(off(sphere(6))) });
  await serve(page, { '/set.zip': Buffer.from(set) });
  await heatwalk.open(`#model=${HOST}/set.zip&name=x/horse.off`);
  await page.locator('.message').getByRole('button', { name: 'Open', exact: true }).click();
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('horse.off');
  await page.getByLabel('Mesh to open').selectOption('cow.obj');
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('cow.obj');
  await expect(page).toHaveURL(/model=https:\/\/models\.example\/set\.zip&name=cow\.obj&/);
});

test('buffers of a glTF are fetched from beside it; an image may be missing', async ({ heatwalk, page }) => {
  const { json, bin } = gltf(BALL, 'data/my%20ball.bin');
  const document = JSON.stringify({ ...JSON.parse(json), images: [{ uri: 'none.png' }] });
  const asked = await serve(page, { '/set/ball.gltf': document, '/set/data/my%20ball.bin': bin });
  await heatwalk.open();
  await paste(page, { text: `${HOST}/set/ball.gltf` });
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.gltf');
  expect(asked).toEqual(['/set/ball.gltf', '/set/data/my%20ball.bin', '/set/none.png']);
});

for (const [what, files, sentence] of [
  ['an address where nothing is', {}, 'models.example answered with status 404'],
  ['a web page', { '/ball.off': '<!DOCTYPE html><p>Log in</p>' }, 'the address gives a web page, not a mesh'],
  ['a text', { '/ball.off': 'no mesh at all' }, 'ball.off was not opened: OFF'],
  [
    'a server that lets nobody read',
    { '/ball.off': (route) => route.fulfill({ headers: OPEN_TO_ANOTHER, body: off(BALL) }) },
    'models.example does not allow other pages to read it (CORS); download the file and drop it here',
  ],
  [
    'a server that cannot be reached',
    { '/ball.off': (route) => route.abort('connectionrefused') },
    'models.example could not be reached; check the address and the connection',
  ],
  [
    'what is too large',
    { '/ball.off': (route) => route.fulfill({ headers: { ...OPEN_TO_ALL, 'Content-Length': `${2 ** 29 + 1}` } }) },
    'it is larger than 512 MiB, the most that is fetched',
  ],
  [
    'a buffer on another server',
    { '/ball.off': gltf(BALL, 'https://elsewhere.example/ball.bin').json },
    'it refers to https://elsewhere.example/ball.bin, but only files of models.example are fetched for it',
  ],
  [
    'a buffer that is missing',
    { '/ball.off': gltf(BALL, 'ball.bin').json },
    'it refers to ball.bin, but models.example answered with status 404',
  ],
] as [string, Record<string, Served>, string][]) {
  test(`${what} is told in plain words, and the offer stays`, async ({ heatwalk, page }) => {
    await serve(page, files);
    await heatwalk.open(`#model=${HOST}/ball.off`);
    const before = await heatwalk.scene();
    await page.locator('.message').getByRole('button', { name: 'Open', exact: true }).click();
    await expect(page.getByRole('alert')).toContainText(sentence);
    expect(await heatwalk.scene()).toEqual(before);
    await expect(page.getByText('This link shows ball.off')).toBeVisible();
  });
}

test('without a network that is said', async ({ heatwalk, page, context }) => {
  await heatwalk.open();
  await context.setOffline(true);
  await paste(page, { text: `${HOST}/ball.off` });
  await expect(page.getByRole('alert')).toContainText('ball.off was not opened: there is no connection to the network');
});

test('fetching shows its progress and can be cancelled', async ({ heatwalk, page }) => {
  await serve(page, { '/ball.off': () => undefined });
  await heatwalk.open();
  const before = await heatwalk.scene();
  await paste(page, { text: `${HOST}/ball.off` });
  const stage = page.getByRole('status').filter({ hasText: 'ball.off: fetching' });
  await expect(stage).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(stage).toBeHidden();
  expect(await heatwalk.scene()).toEqual(before);
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('an address that is none of a server is refused with a notice', async ({ heatwalk, page }) => {
  await heatwalk.open('#model=javascript:alert(1)');
  await expect(page.getByText("The link's model=javascript:alert(1) is no http or https address")).toBeVisible();
  expect((await heatwalk.scene()).mesh).toEqual({ kind: 'preset', id: 'bunny' });
});

test('the file that a link cannot fetch may be dropped in its place', async ({ heatwalk, page }) => {
  await heatwalk.open(`#model=${HOST}/set/ball.off&s=5`);
  await heatwalk.dropAndOpen([['ball.off', off(BALL)]]);
  expect((await heatwalk.scene()).sources).toEqual([{ vertex: 5 }]);
  await expect(page).toHaveURL(/model=https:\/\/models\.example\/set\/ball\.off/);
  await expect(page.getByText('This link shows')).toBeHidden();
});

test('a file is pasted; text that is nothing is told as such, and numbers far from the model ask first', async ({
  heatwalk,
  page,
}) => {
  const asked = await serve(page, { '/ball.off': off(BALL) });
  await heatwalk.open();
  const before = [await heatwalk.mesh(), await heatwalk.scene()];
  for (const [text, told] of [
    ['some\nwords', 'What was pasted, “some words”, is no mesh, no address of one, no link and no list of sources.'],
    [`${HOST}/about`, 'This address of models.example names no mesh'],
    ['ball.off', 'What was pasted, “ball.off”, is no mesh'],
    [new URL('#m=unknown', page.url()).href, 'The link that was pasted names no mesh that can be opened.'],
    ['12 apples\n3 pears', 'What was pasted, “12 apples 3 pears”, is no mesh'],
    ['2024 1300 75', /The numbers pasted \(1 place\) lie [\d.,]+ \S* ?away from the model\./],
    ['2024 1300 75\n2025 1420 80', /The numbers pasted \(2 places\) lie up to [\d.,]+ \S* ?away from the model\./],
  ] as const) {
    await paste(page, { text });
    await expect(page.getByText(told)).toBeVisible();
    // One remark in the place of the one before.
    await expect(page.locator('.message.notice')).toHaveCount(1);
  }
  // Nor is what is pasted into a field, and blanks are nothing.
  await paste(page, { text: `${HOST}/ball.off` }, '.sources input');
  await paste(page, { text: ' \n' });
  await heatwalk.settled();
  expect(asked).toEqual([]);
  expect([await heatwalk.mesh(), await heatwalk.scene()]).toEqual(before);
  const add = page.getByRole('button', { name: 'Add the nearest places as sources' });
  await add.click();
  await expect.poll(async () => (await heatwalk.scene()).sets).toHaveLength(1);
  await expect(add).toBeHidden();

  await paste(page, { name: 'pasted.off', content: off(BALL) });
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('pasted.off');
  await expect(page.locator('.message.notice')).toHaveCount(0);
  // What lies on the model is added at once; one that is meant says so by its heading.
  await paste(page, { text: '0 1 0' });
  await expect.poll(async () => (await heatwalk.scene()).sources).toHaveLength(2);
  await paste(page, { text: 'x,y,z\n0,0,50\n0,50,0' });
  await expect.poll(async () => (await heatwalk.scene()).sets).toHaveLength(1);
  // A link of the page is followed.
  await paste(page, { text: new URL('?lang=en#m=torus&s=7', page.url()).href });
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('torus');
  expect((await heatwalk.scene()).sources).toEqual([{ vertex: 7 }]);

  // An empty file is called empty.
  for (const name of ['empty.obj', 'empty.zip', 'empty.msh', 'empty.csv', 'empty.txt']) {
    await heatwalk.drop([[name, '']]);
    await expect(page.getByRole('alert')).toContainText(`${name} is empty: nothing is in it.`);
  }
});

/** Drops what a link or an image of another page drags along. */
function drag(page: Page, list: string, image?: string) {
  return page.evaluate(
    ([uris, name]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.setData('text/uri-list', uris);
      if (name) dataTransfer.items.add(new File(['pixels'], name));
      for (const type of ['dragenter', 'dragover', 'drop'])
        document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
    },
    [list, image] as const,
  );
}

test('a link that is dragged from another page is fetched, and so is one on an image', async ({ heatwalk, page }) => {
  await serve(page, { '/ball.off': off(BALL), '/cow.obj': obj({ cow: BALL }) });
  await heatwalk.open();
  await drag(page, `# from a page\r\n${HOST}/ball.off\r\n`);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.off');
  await drag(page, `${HOST}/cow.obj`, 'cow.png');
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('cow.obj');
});
