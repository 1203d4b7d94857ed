import { expect, test } from '@playwright/test';
import { strToU8, unzipSync, zipSync } from 'fflate';
import { packScene, sceneIn } from '../../web/files/scene';
import { Archive } from '../../web/files/zip';

const LINK = 'v=1&m=file&name=cow.obj&s=7';
const file = (path: string, content: string) => ({ path, content: new Blob([content]) });

const archive = (told: string) => new Blob([zipSync({ 'heatwalk.json': strToU8(told) })]);

async function paths(packed: Blob): Promise<string[]> {
  return Object.keys(unzipSync(new Uint8Array(await packed.arrayBuffer()))).toSorted();
}

test('a scene is packed with its mesh and what that refers to, and nothing else', async () => {
  const files = [
    file('farm/cow.obj', 'mtllib cow skin.mtl\nv 0 0 0\n'),
    file('farm/cow skin.mtl', 'newmtl a\nmap_Kd maps/cow.png\n'),
    file('farm/maps/cow.png', 'png'),
    file('farm/sheep.obj', 'v 0 0 0\n'),
  ];
  const packed = await packScene(LINK, { kind: 'files', mesh: 'farm/cow.obj', files });
  expect(await paths(packed)).toEqual(['farm/cow skin.mtl', 'farm/cow.obj', 'farm/maps/cow.png', 'heatwalk.json']);
  expect(await sceneIn(packed)).toEqual({ link: LINK, mesh: 'farm/cow.obj', images: [] });
  // Of an archive the same.
  const again = await packScene(LINK, { kind: 'archive', mesh: 'farm/cow.obj', archive: packed });
  expect(await paths(again)).toEqual(await paths(packed));

  const gltf = JSON.stringify({ buffers: [{ uri: 'a%20b.bin' }], images: [{ uri: 'data:,' }, { uri: 'lost.png' }] });
  const parts = [file('m.gltf', gltf), file('a b.bin', '0'), file('other.bin', '0')];
  expect(await paths(await packScene(LINK, { kind: 'files', mesh: 'm.gltf', files: parts }))).toEqual([
    'a b.bin',
    'heatwalk.json',
    'm.gltf',
  ]);
  const pair = [file('t.node', '0'), file('t.ele', '0')];
  expect(await paths(await packScene(LINK, { kind: 'files', mesh: 't.node', files: pair }))).toHaveLength(3);
});

test('files are packed whatever their names are', async () => {
  const gltf = JSON.stringify({ buffers: [{ uri: 'constructor' }, { uri: '__proto__' }, { uri: 'toString' }] });
  const files = [file('m.gltf', gltf), file('constructor', 'a'), file('__proto__', 'b'), file('toString', 'c')];
  const packed = await packScene(LINK, { kind: 'files', mesh: 'm.gltf', files });
  const saved = await Archive.of(packed);
  expect(saved.paths.toSorted()).toEqual(['__proto__', 'constructor', 'heatwalk.json', 'm.gltf', 'toString']);
  const text = (path: string) => new TextDecoder().decode(saved.read(path));
  expect(['constructor', '__proto__', 'toString'].map(text)).toEqual(['a', 'b', 'c']);
});

test('a mesh that every page has is not packed', async () => {
  const packed = await packScene('v=1&m=bunny', null);
  expect(await paths(packed)).toEqual(['heatwalk.json']);
  expect(await sceneIn(packed)).toEqual({ link: 'v=1&m=bunny', mesh: null, images: [] });
});

test('images that lie on the surface come along', async () => {
  const packed = await packScene('v=1&m=bunny', null, [file('file-0123456789abcdef', 'png'), file('__proto__', 'gif')]);
  const { images = [] } = (await sceneIn(packed)) ?? {};
  const found = await Promise.all(images.map(async ({ path, content }) => [path, await content.text()]));
  expect(found.toSorted()).toEqual([
    ['__proto__', 'gif'],
    ['file-0123456789abcdef', 'png'],
  ]);
});

test('other archives hold no scene, and a damaged one says what is wrong', async () => {
  expect(await sceneIn(new Blob([zipSync({ 'cow.obj': strToU8('v 0 0 0') })]))).toBeNull();
  await expect(sceneIn(archive('{'))).rejects.toThrow('heatwalk.json is damaged');
  await expect(sceneIn(archive('null'))).rejects.toThrow('heatwalk.json is damaged');
  await expect(sceneIn(archive('{"heatwalk":1,"link":3,"mesh":null}'))).rejects.toThrow('heatwalk.json is damaged');
  await expect(sceneIn(archive('{"heatwalk":9,"link":"","mesh":null}'))).rejects.toThrow('another version');
  await expect(sceneIn(archive('{"heatwalk":1,"link":"","mesh":"a.obj"}'))).rejects.toThrow(
    'a.obj is not in the archive',
  );
  await expect(sceneIn(new Blob(['PK']))).rejects.toThrow('damaged');
});
