import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { strToU8, zipSync } from 'fflate';
import { gltf, grid, obj, off, sphere } from '../fixtures';
import { expect, openSection, test } from '../page';

const BALL = sphere(8);
const TRIANGLES = BALL.triangles.length;

/** Stands in for a drag of folders, which a script cannot make: the dropped files bear their paths as names. */
async function dropFolders(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const folderEntry = (path: string, files: readonly File[]): object => {
      const inside = files.filter(({ name }) => name.startsWith(`${path}/`));
      const next = (file: File) => file.name.slice(path.length + 1).split('/');
      const folders = new Set(inside.filter((file) => next(file).length > 1).map((file) => next(file)[0]));
      const children = [
        ...inside
          .filter((file) => next(file).length === 1)
          .map((file) => ({
            isFile: true,
            isDirectory: false,
            name: next(file)[0],
            fullPath: `/${file.name}`,
            file: (done: (file: File) => void) => done(file),
          })),
        ...[...folders].map((name) => folderEntry(`${path}/${name}`, inside)),
      ];
      return {
        isFile: false,
        isDirectory: true,
        name: path.split('/').at(-1),
        fullPath: `/${path}`,
        // One child a call, as a browser may tell a large folder in pieces.
        createReader: () => ({ readEntries: (done: (entries: object[]) => void) => done(children.splice(0, 1)) }),
      };
    };
    let files: File[] = [];
    addEventListener('drop', (event) => (files = [...(event.dataTransfer?.files ?? [])]), true);
    DataTransferItem.prototype.webkitGetAsEntry = function () {
      const [root] = this.getAsFile()?.name.split('/') ?? [];
      const taken = files.filter(({ name }) => name.split('/')[0] === root);
      files = files.filter((file) => !taken.includes(file));
      return (taken.length > 0 ? folderEntry(root, taken) : null) as FileSystemEntry | null;
    };
  });
}

test('what a glTF refers to is found by its path, and by its name where the folders are others', async ({
  heatwalk,
  page,
}) => {
  await dropFolders(page);
  await heatwalk.open();
  const { json, bin } = gltf(BALL, '../data/Ball.bin');
  await heatwalk.drop([
    ['model/other/ball.bin', 'not it'],
    ['model/data/ball.bin', bin],
    ['model/mesh/ball.gltf', json],
  ]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.gltf');
  expect((await heatwalk.mesh()).triangles).toBe(TRIANGLES);
  await heatwalk.drop([
    ['flat/ball.bin', bin],
    ['flat/again.gltf', json],
  ]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('again.gltf');
});

test('a buffer that is missing is named', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await heatwalk.drop([
    ['other.bin', 'not it'],
    ['ball.gltf', gltf(BALL, 'data/ball.bin').json],
  ]);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('ball.gltf was not opened: the file refers to data/ball.bin, which was not given');
});

test('a folder is chosen with all that is in it', async ({ heatwalk, page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'heatwalk-folder-'));
  const { json, bin } = gltf(BALL, 'parts/ball.bin');
  for (const [path, content] of [
    ['scan/ball.gltf', json],
    ['scan/parts/ball.bin', bin],
    ['scan/readme.txt', 'about the scan'],
  ] as const) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), content);
  }
  await heatwalk.open();
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open a folder…' }).click();
  await (await chooser).setFiles(join(folder, 'scan'));
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.gltf');
  await expect(page.getByRole('alert')).toBeEmpty();
  rmSync(folder, { recursive: true });
});

test('an archive is opened with what its mesh refers to', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const { json, bin } = gltf(BALL, 'data/ball.bin');
  const archive = zipSync({ 'model/ball.gltf': strToU8(json), 'model/data/ball.bin': [bin, { level: 0 }] });
  await heatwalk.drop([['model.zip', Buffer.from(archive)]]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.gltf');
  expect((await heatwalk.mesh()).triangles).toBe(TRIANGLES);
  await expect(page).toHaveURL(/m=file&name=ball\.gltf&hash=[\da-f]{64}/);
  await expect(page.getByLabel('Mesh to open')).toBeHidden();
});

test('a mesh that gzip has packed is opened; a damaged one and one that only claims room are refused', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  const packed = gzipSync(off(grid(4)));
  await heatwalk.drop([['sheet.OFF.gz', packed]]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('sheet.OFF');
  expect((await heatwalk.mesh()).triangles).toBe(32);
  await heatwalk.drop([['torn.off.gz', packed.subarray(0, packed.length / 2)]]);
  await expect(page.locator('.message.error')).toContainText('torn.off.gz is damaged or cut short');
  await heatwalk.drop([['zeros.off.gz', gzipSync(Buffer.alloc(2 ** 26))]]);
  await expect(page.locator('.message.error').last()).toContainText(/zeros\.off\.gz takes more than \d\d MiB unpacked/);
  expect((await heatwalk.mesh()).name).toBe('sheet.OFF');
});

test('a 3MF file is a mesh, though it is an archive, and tells its unit', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const vertices = BALL.positions.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join('');
  const triangles = BALL.triangles.map(([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`).join('');
  const mesh = `<mesh><vertices>${vertices}</vertices><triangles>${triangles}</triangles></mesh>`;
  const resources = `<resources><object id="1" name="ball">${mesh}</object></resources>`;
  const model = `<model unit="inch">${resources}<build><item objectid="1"/></build></model>`;
  await heatwalk.dropAndOpen([['ball.3mf', Buffer.from(zipSync({ '3D/3dmodel.model': strToU8(model) }))]]);
  expect((await heatwalk.mesh()).triangles).toBe(TRIANGLES);
  expect((await heatwalk.mesh()).parts).toEqual(['ball']);
  await openSection(page, 'numbers');
  await expect(page.locator('.numbers')).toContainText(/Diagonal[\d.]+ in/);
});

test('where no format says a unit, the size suggests one, which is corrected, converted and undone', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.open();
  const large = { ...BALL, positions: BALL.positions.map((point) => point.map((along) => 50 * along)) };
  await heatwalk.dropAndOpen([['ball.off', off(large as typeof BALL)]]);
  await openSection(page, 'numbers');
  const numbers = page.locator('.numbers');
  await expect(numbers).toContainText(/Diagonal[\d.]+ mm \(assumed\)/);
  const [diameter] = /Diagonal[\d.]+/.exec((await numbers.textContent()) ?? '') ?? [];
  await openSection(page, 'scene');
  const unit = page.getByRole('combobox', { name: 'Correct unit' });
  await expect(unit.locator('option').first()).toHaveText('mm (assumed)');
  await unit.selectOption('in');
  // The number stays, and the size of the model changes.
  await expect(numbers).toContainText(`${diameter} in`);
  await expect(page).toHaveURL(/&unit=in/);
  // Converted, the size stays, and the number changes.
  const [inches = NaN] = (/Diagonal([\d.]+)/.exec(diameter ?? '') ?? []).slice(1).map(Number);
  await page.getByRole('combobox', { name: 'Convert to' }).selectOption('ft');
  await expect(numbers).toContainText(/Diagonal[\d.]+ ft/);
  const [feet] = (/Diagonal([\d.]+)/.exec((await numbers.textContent()) ?? '') ?? []).slice(1).map(Number);
  expect(feet / (inches / 12)).toBeCloseTo(1, 2);
  await expect(page).toHaveURL(/&unit=in&shown=ft/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(numbers).toContainText(`${diameter} in`);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(numbers).toContainText(`${diameter} mm (assumed)`);
});

test('of several meshes of an archive the others are offered', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const archive = zipSync({
    'set/large/horse.off': strToU8(off(sphere(12))),
    'set/cow.obj': strToU8(obj({ cow: BALL })),
    '__MACOSX/set/._cow.obj': strToU8('nothing'),
  });
  await heatwalk.drop([['set.zip', Buffer.from(archive)]]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('cow.obj');
  await expect(page.getByText('Opened cow.obj, one of 2 meshes.')).toBeVisible();
  const choice = page.getByLabel('Mesh to open');
  await expect(choice.getByRole('option')).toHaveText(['set/cow.obj', 'set/large/horse.off']);
  await choice.selectOption('set/large/horse.off');
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('horse.off');
  await expect(page.getByText('Opened horse.off, one of 2 meshes.')).toBeVisible();
  await expect(page.getByText('Opened cow.obj')).toBeHidden();
  // Another mesh has no part in that choice.
  await heatwalk.dropAndOpen([['ball.off', off(BALL)]]);
  await expect(choice).toBeHidden();
});

test('a link to a mesh of an archive finds it there', async ({ heatwalk, page }) => {
  await heatwalk.open('#v=1&m=file&name=horse.off&s=5');
  const archive = zipSync({ 'cow.obj': strToU8(obj({ cow: BALL })), 'horse.off': strToU8(off(sphere(12))) });
  await heatwalk.drop([['set.zip', Buffer.from(archive)]]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('horse.off');
  expect((await heatwalk.scene()).sources).toEqual([{ vertex: 5 }]);
  await expect(page.getByText('This link needs your file')).toBeHidden();
});

for (const [what, files, sentence] of [
  ['a damaged archive', { 'a.obj': strToU8('v 0 0 0') }, /set\.zip was not opened: the archive is damaged/],
  ['an archive of a COLLADA file', { 'robot.dae': strToU8('<COLLADA/>') }, /convert them to GLB, in Blender/],
  [
    'an archive without a mesh',
    { 'notes.txt': strToU8('none') },
    /^The archive set\.zip contains no mesh, only notes\.txt\. Supported formats: GLB, /,
  ],
  ['an archive of nothing', {}, /^No mesh found in set\.zip\. Supported formats: GLB, /],
] as const) {
  test(`${what} is refused with a sentence, and the scene stays`, async ({ heatwalk, page }) => {
    await heatwalk.open();
    const before = await heatwalk.scene();
    const archive = zipSync(files);
    await heatwalk.drop([['set.zip', Buffer.from(what.startsWith('a damaged') ? archive.slice(0, -9) : archive)]]);
    await expect(page.getByRole('alert')).toContainText(sentence);
    expect(await heatwalk.scene()).toEqual(before);
  });
}

test('an encrypted buffer of a mesh is the reason that is told', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const { json, bin } = gltf(BALL, 'ball.bin');
  const archive = Buffer.from(zipSync({ 'ball.gltf': strToU8(json), 'ball.bin': bin }));
  const directory = archive.lastIndexOf(Buffer.from([0x50, 0x4b, 1, 2]));
  archive.writeUInt16LE(1, directory + 8);
  await heatwalk.drop([['set.zip', archive]]);
  await expect(page.getByRole('alert')).toContainText('ball.gltf was not opened: ball.bin is encrypted; unpack');
});
