import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { FRENCH, REPORTS } from '../../web/texts/fr';
import { counted, enumerated, Phrase, retold, speak } from '../../web/texts/translate';
import { NAMES, saidBy, sources } from '../texts';

/** Keys, classes, names of formats and programs, lines of programs, and errors that are caught. */
const NO_TEXT =
  /^(Enter|Delete|Backspace|Escape|Files|Heatwalk|Python|Rust|Fetching|(pin|initial|quiet|stack) \w+|\.initial input|<iframe .*|--.*|import \w+|# .*|(message|tape-label) \{0\}|\{0\} (ms|px|tapes\.csv)|M\{0\}.*|too (large|long)|cut off|no (run|vertex))$/;
/** Both languages write them alike. */
const ALIKE =
  /^[^a-z]*$|OBJ|DXF|CSV|[×°]|^(Animation|Sources?|Style|Auto|Propagation|Cholesky|Convergence|Distances?|triangles?|contacts?|points?|exact|Distance|Contacts|Surface|Position|Triangles|Relief|Pause|Maximum|Action|Zoom|Robot|Dragon|Village|Triangle \{0\}|\{0\}, .*|\{0\} triangles|area .*|Stanford .*|distance|propagation|magma|turbo|viridis|jade|studio|contour|Ctrl\+[KV]|Exact\.|.* exact|\{0\} (s|ms|px|contacts?|triangles?|\(P\))|\{0\} \/ s|m = \{0\}|Sources: \{0\})$/;

const values = (text: string) => [...text.matchAll(/\{\d\}/g)].map(([value]) => value).toSorted();

test('every text of the page is in French, and no other', async () => {
  const texts = new Set(NAMES);
  for (const [, source] of await sources()) for (const text of saidBy(source).texts) texts.add(text);
  expect(texts.size).toBeGreaterThan(800);
  expect([...texts].filter((text) => !(text in FRENCH))).toEqual([]);
  expect(Object.keys(FRENCH).filter((text) => !texts.has(text))).toEqual([]);
});

test('texts in French have the values of those in English, differ from them, and are set as French is', () => {
  const texts = Object.entries({ ...FRENCH, ...REPORTS });
  expect(texts.filter(([english, french]) => String(values(english)) !== String(values(french)))).toEqual([]);
  expect(texts.filter(([english, french]) => english === french && !ALIKE.test(english))).toEqual([]);
  // A narrow no-break space, never one at which lines break, stands before what is of two parts.
  const isWrong = /[^\S\u202f][;!?»%]|[^\S\u202f]:(?!\w)|«(?!\u202f)|'/;
  expect(texts.filter(([, french]) => isWrong.test(french))).toEqual([]);
});

test('no text of the page is beside the function that translates', async () => {
  const names = new Set(NAMES);
  const bare: string[] = [];
  for (const [path, source] of await sources()) {
    const found = saidBy(source).bare.filter((text) => !NO_TEXT.test(text) && !names.has(text));
    bare.push(...found.map((text) => `${path}: ${text}`));
  }
  expect(bare).toEqual([]);
});

test('what is planted is found', () => {
  const source =
    'const a = t`${1} of ${2}`, b = counted(3, "{0} hole", "{0} holes"), c = `Save ${d} now`, e = h("p", {}, "Two words");';
  expect(saidBy(source)).toEqual({
    texts: ['{0} of {1}', '{0} hole', '{0} holes'],
    bare: ['Save {0} now', 'Two words'],
  });
});

/** Sentences of the crates whose errors reach the page, with `{0}` for the first value. */
async function ofCrates(): Promise<string[]> {
  const root = new URL('../../crate/', import.meta.url).pathname;
  const paths = (await readdir(root, { recursive: true })).filter((path) =>
    /^(model|surface|solver|volume|curves|viewer|basis)\/src\/(\w+\/)*error\.rs$/.test(path),
  );
  const files = await Promise.all(paths.map((path) => readFile(join(root, path), 'utf8')));
  const attributes = files.flatMap((source) => Array.from(source.matchAll(/#\[error\(\s*"((?:[^"\\]|\\.)*)"/gs)));
  return attributes.map(([, text = '']) => {
    let value = 0;
    return text.replaceAll(/\\\s*\n\s*/g, '').replaceAll(/\{[^}]*\}/g, () => `{${value++}}`);
  });
}

test('every error of the solver and of the renderer has a sentence in French', async () => {
  const sentences = await ofCrates();
  expect(sentences.length).toBeGreaterThan(60);
  expect(sentences.filter((sentence) => !(sentence in REPORTS))).toEqual([]);
});

test('a phrase is in the language that the page has when it is read, with its numbers, lists and reports', () => {
  const phrases = [
    counted(1234, '{0} triangle', '{0} triangles'),
    enumerated(['a', 'b', 'c']),
    retold('vertex 7 does not exist; there are 5, counted from 0'),
    retold('no triangles: out of memory while filling'),
    retold('PLY, line 5: a face ends too soon'),
    retold('Failed to fetch'),
  ];
  const english = phrases.map(String);
  expect(phrases[0]).toBeInstanceOf(Phrase);
  expect(english.slice(0, 2)).toEqual(['1,234 triangles', 'a, b, and c']);
  try {
    speak('fr', FRENCH, REPORTS);
    expect(phrases.map(String)).toEqual([
      '1\u202f234 triangles',
      'a, b et c',
      'le sommet 7 n’existe pas\u202f; il y en a 5, comptés à partir de 0',
      'aucun triangle\u202f: mémoire épuisée (remplissage)',
      'PLY, ligne 5\u202f: a face ends too soon',
      'Failed to fetch',
    ]);
  } finally {
    speak('en');
  }
  expect(phrases.map(String)).toEqual(english);
});
