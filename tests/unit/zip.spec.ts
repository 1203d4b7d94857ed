import { expect, test } from '@playwright/test';
import { strToU8, zipSync } from 'fflate';
import { Archive } from '../../web/files/zip';

const TEXT = strToU8('v 0 0 0\n'.repeat(100));
const PLAIN = zipSync({ 'a/mesh.obj': [TEXT, { level: 0 }], 'a/packed.obj': TEXT, 'a/': new Uint8Array() });

/** The archive with a change to each entry of its central directory. */
function changed(archive: Uint8Array, change: (view: DataView, entry: number) => void): Uint8Array {
  const bytes = archive.slice();
  const view = new DataView(bytes.buffer);
  for (let at = 0; at + 4 <= bytes.length; at++) if (view.getUint32(at, true) === 0x02014b50) change(view, at);
  return bytes;
}

test('stored and deflated files come out as they went in', () => {
  const archive = new Archive(PLAIN);
  expect(archive.paths).toEqual(['a/mesh.obj', 'a/packed.obj']);
  for (const path of archive.paths) expect(archive.read(path)).toEqual(TEXT);
});

test('backslashes in names are separators', () => {
  const archive = new Archive(zipSync({ 'a\\mesh.obj': TEXT }));
  expect(archive.paths).toEqual(['a/mesh.obj']);
  expect(archive.read('a/mesh.obj')).toEqual(TEXT);
});

test('a comment at the end is no part of the archive', () => {
  expect(new Archive(zipSync({ 'mesh.obj': TEXT }, { comment: 'made by hand' })).paths).toEqual(['mesh.obj']);
});

for (const [what, change, sentence] of [
  ['an encrypted file', (view, at) => view.setUint16(at + 8, 1, true), /^a\/mesh\.obj is encrypted; unpack/],
  ['an unknown method', (view, at) => view.setUint16(at + 10, 12, true), /^a\/mesh\.obj is packed by method 12,/],
  ['an absurd ratio', (view, at) => view.setUint32(at + 24, 2 ** 30, true), /claims to be \d+ times as large/],
  ['a size that is not true', (view, at) => view.setUint32(at + 24, 2 * TEXT.length, true), /damaged or cut short/],
  ['a place beyond the end', (view, at) => view.setUint32(at + 42, 2 ** 30, true), /damaged or cut short/],
] as [string, (view: DataView, at: number) => void, RegExp][]) {
  test(`${what} is refused with a sentence`, () => {
    const archive = new Archive(changed(PLAIN, change));
    expect(() => archive.read('a/mesh.obj')).toThrow(sentence);
  });
}

test('what is unpacked counts together', () => {
  const archive = new Archive(PLAIN, 2 * TEXT.length);
  for (const path of archive.paths) archive.read(path);
  expect(() => archive.read('a/mesh.obj')).toThrow(/^a\/mesh\.obj and what is with it take more than/);
});

test('small files may take no more together than meshes of the size of the archive do', () => {
  const zeros = new Uint8Array(2 ** 24);
  const archive = new Archive(zipSync({ 'a.obj': zeros, 'b.obj': zeros, 'c.obj': zeros }));
  archive.read('a.obj');
  archive.read('b.obj');
  expect(() => archive.read('c.obj')).toThrow(/^c\.obj and what is with it take more than \d+ MiB unpacked/);
});

/** Entry `b.obj` of the directory gets a name of as many letters. */
const renamed = (name: string) =>
  changed(zipSync({ 'a.obj': TEXT, 'b.obj': new Uint8Array(9) }), (view, at) => {
    if (view.getUint8(at + 46) === 0x62) strToU8(name).forEach((byte, i) => view.setUint8(at + 46 + i, byte));
  });

test('two files of one name are refused', () => {
  expect(() => new Archive(renamed('a.obj'))).toThrow('the archive holds a.obj twice');
  expect(new Archive(renamed('c.obj')).read('c.obj')).toEqual(new Uint8Array(9));
});

test('names that objects have are names like others', () => {
  const [proto, inherited] = ['__proto__', 'constructor'];
  const archive = new Archive(
    changed(zipSync({ [inherited]: TEXT, 'long name': new Uint8Array(9) }), (view, at) => {
      if (view.getUint8(at + 46) === 0x6c) strToU8(proto).forEach((byte, i) => view.setUint8(at + 46 + i, byte));
    }),
  );
  expect(archive.paths).toEqual([inherited, proto]);
  expect(archive.read(inherited)).toEqual(TEXT);
  expect(archive.read(proto)).toEqual(new Uint8Array(9));
});

for (const length of [0, 10, 21, 22, PLAIN.length - 30, PLAIN.length - 1]) {
  test(`an archive cut to ${length} bytes is refused`, () => {
    expect(() => new Archive(PLAIN.slice(0, length))).toThrow(/damaged or cut short/);
  });
}

test('too many files are refused before they are listed', () => {
  const many = Object.fromEntries(Array.from({ length: 10_001 }, (_, i) => [`${i}.obj`, new Uint8Array()]));
  expect(() => new Archive(zipSync(many, { level: 0 }))).toThrow('holds 10001 files, more than 10000');
});
