import { expect, test } from '@playwright/test';
import { isMesh, meshesAmong, resolve } from '../../web/files/paths';

const FILES = [
  'scan/a/scene.gltf',
  'scan/a/scene.bin',
  'scan/b/scene.bin',
  'scan/Shared/Wood Oak.PNG',
  'scan/b/bark.png',
];

for (const [uri, found] of [
  ['scene.bin', 'scan/a/scene.bin'],
  ['./scene.bin', 'scan/a/scene.bin'],
  ['../b/scene.bin', 'scan/b/scene.bin'],
  ['..\\b\\scene.bin', 'scan/b/scene.bin'],
  // By the name alone, where the folders are others.
  ['C:/Users/me/textures/bark.png', 'scan/b/bark.png'],
  ['../../../bark.png', 'scan/b/bark.png'],
  // Whatever the case.
  ['SCENE.BIN', 'scan/a/scene.bin'],
  ['../shared/wood oak.png', 'scan/Shared/Wood Oak.PNG'],
  ['wood oak.png', 'scan/Shared/Wood Oak.PNG'],
  // Not there.
  ['missing.bin', undefined],
  ['', undefined],
] as const) {
  test(`${uri || 'an empty reference'} of a mesh is ${found ?? 'nowhere'}`, () => {
    expect(resolve('scan/a/scene.gltf', uri, FILES)).toBe(found);
  });
}

test('a file that is written as it is named goes before one of another case', () => {
  expect(resolve('mesh.gltf', 'A.bin', ['a.bin', 'A.bin'])).toBe('A.bin');
  expect(resolve('mesh.gltf', 'a.bin', ['A.bin', 'a.bin'])).toBe('a.bin');
});

test('a file name that two files bear names neither', () => {
  expect(resolve('c/scene.gltf', 'scene.bin', FILES)).toBeUndefined();
});

test('accents are the same letters however they are composed', () => {
  expect(resolve('m.gltf', 'e\u0301.bin', ['\u00e9.bin'])).toBe('\u00e9.bin');
});

test('meshes come from the uppermost folder first, without what systems put there', () => {
  const paths = ['x/deep/c.stl', '__MACOSX/x/._a.obj', 'x/._b.obj', 'x/b.OBJ', 'x/notes.txt', 'x/a.ply'];
  expect(meshesAmong(paths)).toEqual(['x/b.OBJ', 'x/a.ply', 'x/deep/c.stl']);
  expect(isMesh('.hidden/a.obj')).toBe(false);
  for (const name of ['a.3mf', 'a.coff', 'a.VTK', 'a.vtp', 'a.vtu', 'lh.surf.gii', 'lh.pial'])
    expect(isMesh(name)).toBe(true);
});
