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
  ['a size beyond 2 GiB', (view, at) => view.setUint32(at + 24, 2 ** 31 + 1, true), /more than 2 GiB unpacked/],
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

for (const length of [0, 10, 21, 22, PLAIN.length - 30, PLAIN.length - 1]) {
  test(`an archive cut to ${length} bytes is refused`, () => {
    expect(() => new Archive(PLAIN.slice(0, length))).toThrow(/damaged or cut short/);
  });
}

test('too many files are refused before they are listed', () => {
  const many = Object.fromEntries(Array.from({ length: 10_001 }, (_, i) => [`${i}.obj`, new Uint8Array()]));
  expect(() => new Archive(zipSync(many, { level: 0 }))).toThrow('holds 10001 files, more than 10000');
});
