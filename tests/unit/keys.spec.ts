/** docs/page.md, undo and the link speak of the same keys. */
import fs from 'node:fs';
import path from 'node:path';
import { expect, test } from '@playwright/test';
import { ADDRESS_KEYS, isOpenedWith, isUndoable, KEYS } from '../../web/state/link';
import { emptyScene, type SceneState } from '../../web/state/scene';

const PAGE = fs.readFileSync(path.join(import.meta.dirname, '../../docs/page.md'), 'utf8');
const [LINK = ''] = PAGE.split('## Link\n').slice(1);
const EMPTY = emptyScene({ kind: 'file', name: '', hash: '' });
const codes = (text: string) => [...text.matchAll(/`([^`]*)`/g)].map(([, code = '']) => code);

test('the documents have each key of the link, and no other', () => {
  const table = LINK.split('\n\n').find((block) => block.startsWith('| key')) ?? '';
  const told = table.split('\n').flatMap((row) => codes(row.split('|')[1] ?? ''));
  expect(told.toSorted()).toEqual([...ADDRESS_KEYS, ...KEYS.map(({ key }) => key)].toSorted());
  expect(new Set(told).size).toBe(told.length);
});

test('the defaults in the documents are those of a scene', () => {
  const told = LINK.split('\n\n').find((block) => block.startsWith('The defaults are')) ?? '';
  const defaults = codes(told).filter((code) => code.includes('='));
  expect(defaults.length).toBeGreaterThan(40);
  const known = new Set(KEYS.map(({ key, encode }) => `${key}=${encode(EMPTY)}`));
  expect(defaults.filter((code) => !known.has(code))).toEqual([]);
});

test('every field of a scene is in its link, but for what is of the moment', () => {
  const fields = (Object.keys(EMPTY) as (keyof SceneState)[]).filter(
    (field) => field !== 'mesh' && field !== 'selected',
  );
  expect(new Set(KEYS.map(({ field }) => field))).toEqual(new Set(fields));
  expect(fields.filter((field) => isUndoable(field) && isOpenedWith(field))).toEqual([]);
});
