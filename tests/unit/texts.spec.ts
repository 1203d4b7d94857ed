import { expect, test } from '@playwright/test';
import { FRENCH } from '../../web/texts/fr';
import { NAMES, saidBy, sources } from '../texts';

/** Keys, classes, names of formats and programs, lines of programs, and errors that are caught. */
const NO_TEXT =
  /^(Enter|Delete|Backspace|Escape|Files|Heatwalk|Python|Rust|Fetching|(pin|initial|quiet|stack) \w+|\.initial input|<iframe .*|--.*|import \w+|# \{0\} on .*|(message|tape-label) \{0\}|\{0\} (ms|px|tapes\.csv)|M\{0\}.*|too (large|long)|cut off|no (run|vertex))$/;
/** Both languages write them alike. */
const ALIKE =
  /^[^a-z]*$|OBJ|DXF|CSV|[×°]|^(Animation|Sources?|Style|Auto|Propagation|Cholesky|Convergence|Distances?|triangles?|contacts?|points?|exact|Distance|Contacts|Surface|Position|Triangles|Relief|Pause|Maximum|Action|Zoom|Robot|Dragon|Village|Triangle \{0\}|\{0\}, .*|\{0\} triangles|area .*|Stanford .*|distance|propagation|magma|turbo|viridis|jade|studio|contour|Ctrl\+V|Exact\.|.* exact)$/;

const values = (text: string) => [...text.matchAll(/\{\d\}/g)].map(([value]) => value).toSorted();

test('every text of the page is in French, and no other', async () => {
  const texts = new Set(NAMES);
  for (const [, source] of await sources()) for (const text of saidBy(source).texts) texts.add(text);
  expect(texts.size).toBeGreaterThan(800);
  expect([...texts].filter((text) => !(text in FRENCH))).toEqual([]);
  expect(Object.keys(FRENCH).filter((text) => !texts.has(text))).toEqual([]);
});

test('texts in French have the values of those in English, differ from them, and are set as French is', () => {
  const texts = Object.entries(FRENCH);
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
  const source = 'const a = t`${1} of ${2}`, b = counted(3, "hole"), c = `Save ${d} now`, e = h("p", {}, "Two words");';
  expect(saidBy(source)).toEqual({ texts: ['{0} of {1}', 'hole', 'holes'], bare: ['Save {0} now', 'Two words'] });
});
