import { expect, test } from '@playwright/test';
import { gltfReferences, librariesOf, mapsOf } from '../../web/files/references';

test('a glTF document needs its buffers, and may miss its images', () => {
  const document = {
    buffers: [{ uri: 'a%20b.bin' }, {}],
    images: [{ uri: 'c.png' }, { uri: 'data:image/png;base64,' }],
  };
  expect(gltfReferences('m/a.gltf', JSON.stringify(document))).toEqual([
    { uri: 'a%20b.bin', path: 'm/a b.bin', isNeeded: true },
    { uri: 'c.png', path: 'm/c.png', isNeeded: false },
  ]);
  expect(gltfReferences('a.gltf', 'no document')).toEqual([]);
});

test('an OBJ file refers to material libraries, and these to images beside them', () => {
  const obj = '# mtllib none.mtl\nmtllib sub\\my house.mtl\r\nv 0 0 0\nmtllib sub\\my house.mtl\n';
  expect(librariesOf('m/a.obj', obj)).toEqual([
    { uri: 'sub/my%20house.mtl', path: 'm/sub/my house.mtl', isNeeded: false },
  ]);
  const mtl =
    'newmtl a\nmap_Kd -s 2 2 1 -o 0.5 -clamp on wall of brick.png\n  bump -bm 0.5 b.png\nnorm n.png\nKd 1 1 1\nmap_d -mm 0 1 n.png\n';
  expect(mapsOf('m/a.obj', 'm/sub/my house.mtl', mtl).map(({ uri, path }) => [uri, path])).toEqual([
    ['sub/wall%20of%20brick.png', 'm/sub/wall of brick.png'],
    ['sub/b.png', 'm/sub/b.png'],
    ['sub/n.png', 'm/sub/n.png'],
  ]);
});
