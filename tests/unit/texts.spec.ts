import { expect, test } from '@playwright/test';
import { Failure, sentenceOf } from '../../web/error';
import { FRENCH, REPORTS } from '../../web/texts/fr';
import { retelling } from '../../web/texts/retelling';
import { counted, enumerated, Phrase, retold, speak } from '../../web/texts/translate';
import { literals, literalsOf } from '../sentences';
import { NAMES, saidBy, sources } from '../texts';

/** Keys, classes, names of formats and programs, lines of programs, and errors that are caught. */
const NO_TEXT =
  /^(Enter|Delete|Backspace|Escape|Home|End|Files|Heatwalk|Python|Rust|Fetching|(pin|initial|quiet|stack) \w+|\.initial input|<iframe .*|--.*|import \w+|# .*|(message|tape-label) \{0\}|\{0\} (ms|px|tapes\.csv)|M\{0\}.*|too (large|long)|cut off|no (run|vertex))$/;
/** Both languages write them alike. */
const ALIKE =
  /^[^a-z]*$|OBJ|DXF|CSV|[×°]|^(Animation|Image|Angle|Sources?|Style|Auto|Propagation|Cholesky|Convergence|Distances?|triangles?|contacts?|points?|exact|Distance|Contacts|Surface|Position|Triangles|Relief|Pause|Maximum|Action|Zoom|Robot|Dragon|Village|Triangle \{0\}|\{0\}, .*|\{0\} triangles|area .*|Stanford .*|distance|propagation|magma|turbo|viridis|jade|studio|contour|Ctrl\+[KV]|(face|buffer|image|skin) \{0\}|Exact\.|.* exact|\{0\} (s|ms|px|contacts?|triangles?|points?|\(P\))|\{0\} \/ s|m = \{0\}|Sources: \{0\})$/;

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

/** Literals of the crates that no user reads: what files have, and names that elements without one get. */
const NO_SENTENCE = new Set([
  'Git LFS',
  '.mtl ',
  ' at line',
  'recursion limit exceeded',
  'animation {0}',
  'camera {0}',
  'element edge',
]);

/** Literals that are told only inside these. Alone they would fit many other sentences, or say too little to be put into French. */
const TOLD_IN: Readonly<Record<string, readonly string[]>> = {
  '{0} and {1}': ['the number of triples of lengths and of glued sides is {0} and {1}; it must be {2}'],
  'the number of triples of lengths and of glued sides': [
    'the number of triples of lengths and of glued sides is {0} and {1}; it must be {2}',
  ],
  '{0} does not exist': ['the motion cannot be used: {0} does not exist'],
  '{0} is found': ['"{0}" is found'],
  '{0} has a decimal comma; save the file with decimal points': [
    '"{0}" has a decimal comma; save the file with decimal points',
  ],
  '{0} is not a vertex index; they count from 1': ['"{0}" is not a vertex index; they count from 1'],
  '{0} is not an OFF header; save it as plain OFF': ['"{0}" is not an OFF header; save it as plain OFF'],
  '{0} is expected, but {1} is found; correct the line': ['{0} is expected, but "{1}" is found; correct the line'],
  '{0} is missing': ['{0} is missing; the file is cut short, save it again'],
  '{0} is no {1} statement': ['"{0}" is no {1} statement'],
  'byte 0': ['byte {0}'],
  'buffer view': ['buffer view {0}'],
  'piece {0}, ': ['piece {0}, face {1}'],
  '{0}face {1}': ['face {0}', 'piece {0}, face {1}'],
  '{0} at vertex {1}{2}': ['{0} at vertex {1}', '{0} at vertex {1}, and out of range at {2} more'],
  ', and out of range at {0} more': ['{0} at vertex {1}, and out of range at {2} more'],
  ', or auto': ['a positive number, or auto', 'a number of mean edge lengths, 0 or more, or auto'],
  'auto, ': ['auto, {0}, or 0 or more'],
  ', or 0 or more': ['auto, {0}, or 0 or more'],
  'boundary condition': ["there is no boundary condition '{0}'; choose one of {1}"],
  'linear solver': ["there is no linear solver '{0}'; choose one of {1}"],
  'multi-source mode': ["there is no multi-source mode '{0}'; choose one of {1}"],
  'kind of edges': ["there is no kind of edges '{0}'; choose one of {1}"],
  'up axis': ["there is no up axis '{0}'; choose one of {1}"],
  "there is no {0} '{1}'; choose one of {2}": ["there is no method '{0}'; choose one of {1}"],
  '{0}of {1} curved cells the corners were taken': [
    'of {0} curved cells the corners were taken',
    '{0} were split into tetrahedra; of {1} curved cells the corners were taken',
  ],
  '{0} is {1}': ['{0} is {1}; the file is damaged or cut short, save it again'],
  '{0} is expected, but {1}': ['{0} is expected, but {1}; the file is damaged or cut short, save it again'],
  '{0} is expected, but the file ends': ['{0} is expected, but {1}; the file is damaged or cut short, save it again'],
  '{0} is expected, but {1} is found': [
    '{0} is expected, but {1} is found; the file is damaged or cut short, save it again',
  ],
};

/** Whether a literal is in French: alone, with the count before it, or as what is put behind a sentence. */
function isInFrench(text: string): boolean {
  const told = TOLD_IN[text];
  if (told) return told.every((whole) => whole in REPORTS);
  return NO_SENTENCE.has(text) || [text, `1 ${text}`, `{0} ${text}`, `{0}${text}`].some((whole) => whole in REPORTS);
}

test('every sentence of readers, solvers and renderer, and every part of one, is in French', async () => {
  const found = await literals();
  expect(found.length).toBeGreaterThan(500);
  expect(found.filter(([, text]) => !isInFrench(text))).toEqual([]);
});

test('exceptions among the sentences are still said', async () => {
  const said = new Set((await literals()).map(([, text]) => text));
  expect([...NO_SENTENCE, ...Object.keys(TOLD_IN)].filter((text) => !said.has(text))).toEqual([]);
});

test('sentences that are planted in a Rust source are found', () => {
  const source = `
    //! "No sentence of a comment".
    #[cfg_attr(feature = "a b", serde(with = "c d"))]
    #[error("cancelled")]
    fn a(b: &str) -> String {
        assert_eq!(b.len(), 2, "one value a vertex");
        let c = d.expect("it was checked");
        let e = ['"', '\\''];
        format!("{b:?} is no \\"face\\"; \\
            repair {}", f("solid", b"no text", r"nor this"))
    }
    #[cfg(test)]
    mod tests { const A: &str = "not of tests"; }`;
  expect(literalsOf(source)).toEqual(['cancelled', '{0} is no "face"; repair {1}']);
});

const inFrench = retelling(REPORTS);

test('refusals of files are French as a whole, whatever is put into them', () => {
  const refusals = [
    [
      'OBJ, line 1: a vertex needs three numbers, but there are 2; the file may be cut short: copy or export it again',
      'OBJ, ligne 1 : un sommet demande trois nombres, mais il y en a 2 ; le fichier est peut-être tronqué : copiez-le ou exportez-le de nouveau',
    ],
    [
      'OBJ, line 3: a vertex needs three numbers, but "1,5" has a decimal comma; save the file with decimal points',
      'OBJ, ligne 3 : un sommet demande trois nombres, mais « 1,5 » a une virgule décimale ; enregistrez le fichier avec des points décimaux',
    ],
    [
      'STL, byte 84: 3 of 12 triangles are missing; save it again',
      'STL, octet 84 : il manque 3 des 12 triangles ; enregistrez le fichier de nouveau',
    ],
    [
      'PLY, line 3: unknown property type: "property foo x"',
      'PLY, ligne 3 : type de propriété inconnu : « property foo x »',
    ],
    [
      'PLY, vertex 2: x should be a number, but "filling" is found; the file is damaged or cut short, save it again',
      'PLY, sommet 2 : x devrait être un nombre, mais on trouve « filling » ; le fichier est endommagé ou tronqué, enregistrez-le de nouveau',
    ],
    ['GLB, accessor 3: it does not exist', 'GLB, accesseur 3 : il n’existe pas'],
    [
      'glTF, JSON line 4 column 7: expected `,` or `}` at line 4 column 7; export it again',
      'glTF, JSON, ligne 4, colonne 7 : « , » ou « } » est attendu, ligne 4, colonne 7 ; exportez-le de nouveau',
    ],
    [
      'OFF, line 1: the number of vertices is expected, but "x" is found; correct the line',
      'OFF, ligne 1 : on attend le nombre de sommets, mais on trouve « x » ; corrigez la ligne',
    ],
    [
      'glTF, buffers[0]: invalid type: string "x", expected u64; export the file again',
      'glTF, buffers[0] : type invalide : texte « x » au lieu de u64 ; exportez le fichier de nouveau',
    ],
    [
      '3MF: encryption (3D/model.model) is not supported; save it without protection',
      '3MF : le chiffrement (3D/model.model) n’est pas pris en charge ; enregistrez-le sans protection',
    ],
    [
      'the file takes more than 126 MB of memory, the most that a file of 14 KB may take; it is damaged or made to fill memory, save it again',
      'le fichier prend plus de 126 Mo de mémoire, le maximum pour un fichier de 14 ko ; il est endommagé ou fait pour remplir la mémoire, enregistrez-le de nouveau',
    ],
    [
      'a mesh of 5000000 triangles takes 2.50 GiB of memory, more than the 512.0 MiB there are; use a mesh with fewer triangles, or the native program on a larger machine',
      'un maillage de 5000000 triangles prend 2,50 Gio de mémoire, plus que les 512,0 Mio disponibles ; utilisez un maillage de moins de triangles, ou le programme natif sur une machine plus grande',
    ],
    [
      'no triangles: a.obj holds no faces: 1 statement of a curve or a surface of free form was left out; save the model as polygons; 2 points or lines were left out',
      'aucun triangle : a.obj ne contient pas de faces : 1 instruction de courbe ou de surface de forme libre ignorée ; enregistrez le modèle en polygones ; 2 points ou lignes ignorés',
    ],
    [
      'no triangles: scan.xyz is a cloud of 120 points without faces; make a surface of it first',
      'aucun triangle : scan.xyz est un nuage de 120 points sans faces ; faites-en d’abord une surface',
    ],
    [
      'points, line 2: a point needs three numbers, but it is missing',
      'points, ligne 2 : il faut trois nombres à un point, mais rien ne suit',
    ],
    [
      'Gmsh, line 9: the number of nodes is expected, but the file ends; the file is damaged or cut short, save it again',
      'Gmsh, ligne 9 : on attend le nombre de nœuds, mais le fichier se termine ; le fichier est endommagé ou tronqué, enregistrez-le de nouveau',
    ],
    [
      '3 hexahedra, 2 prisms, 1 pyramids were split into tetrahedra',
      '3 hexaèdres, 2 prismes, 1 pyramides découpés en tétraèdres',
    ],
    [
      "there is no linear solver 'lu'; choose one of cholesky, cg",
      'le solveur linéaire « lu » n’existe pas ; choisissez parmi cholesky, cg',
    ],
    [
      'a cost is 0.0001 at vertex 3, and out of range at 7 more; it must be from 0.001 to 1000',
      'un coût vaut 0.0001 au sommet 3, et hors limites à 7 autres ; il faut de 0,001 à 1000',
    ],
  ];
  const plain = refusals.map(([english = '']) => inFrench(english).replaceAll('\u202f', ' '));
  expect(plain).toEqual(refusals.map(([, french]) => french));
});

test('what no sentence fits stays as it is', () => {
  const others = [
    'Failed to fetch',
    'the string is not valid',
    'NetworkError, code 3: it is over',
    'a.b, c: d',
    'no file is found',
    'this and that',
    'length',
    '{0}',
  ];
  expect(others.map(inFrench)).toEqual(others);
});

test('what a driver says stays as it is', () => {
  expect(inFrench('The canvas cannot be used for drawing. Reload the page. (line 7: it is missing)')).toBe(
    'Le canevas ne peut pas servir à dessiner. Rechargez la page. (line 7: it is missing)',
  );
});

/** What the readers say of a file that would fill memory. */
function overBudget(budget: string, size: string): string {
  return `the file takes more than ${budget} of memory, the most that a file of ${size} may take; it is damaged or made to fill memory, save it again`;
}

test('a long text with many signs at which it could be parted takes no time, and spoils nothing', () => {
  const long = 'cell, face: vertex; of is '.repeat(400);
  expect(inFrench(overBudget(long, '125 MB'))).toMatch(/^le fichier prend plus de cell, face: vertex/);
  expect(inFrench(overBudget('9 GB', '125 MB'))).toMatch(
    /^le fichier prend plus de 9 GB .* fichier de 125\u202fMo\u202f;/,
  );
});

test('a phrase is in the language that the page has when it is read, with its numbers, lists and reports', () => {
  const phrases = [
    counted(1234, '{0} triangle', '{0} triangles'),
    enumerated(['a', 'b', 'c']),
    retold('vertex 7 does not exist; there are 5, counted from 0'),
    retold('no triangles: out of memory while filling'),
    retold('PLY, line 5: words of a later version'),
    retold('Failed to fetch'),
  ];
  const english = phrases.map(String);
  expect(phrases[0]).toBeInstanceOf(Phrase);
  expect(english.slice(0, 2)).toEqual(['1,234 triangles', 'a, b, and c']);
  try {
    speak('fr', FRENCH, inFrench);
    expect(phrases.map(String)).toEqual([
      '1\u202f234 triangles',
      'a, b et c',
      'le sommet 7 n’existe pas\u202f; il y en a 5, comptés à partir de 0',
      'aucun triangle\u202f: mémoire épuisée (remplissage)',
      'PLY, ligne 5\u202f: words of a later version',
      'Failed to fetch',
    ]);
  } finally {
    speak('en');
  }
  expect(phrases.map(String)).toEqual(english);
});

function alone(message: string): string {
  return String(sentenceOf(new Error(message)));
}

test('a sentence of a worker that stands alone begins with a capital and ends', () => {
  expect(alone('these are 20000 isolines, and 10000 are drawn at most; choose a larger spacing')).toBe(
    'These are 20000 isolines, and 10000 are drawn at most; choose a larger spacing.',
  );
  // Names of files stay as they are, and so do sentences.
  expect(alone('cow.off holds no faces')).toBe('cow.off holds no faces.');
  expect(alone('No mesh is open.')).toBe('No mesh is open.');
  expect(String(sentenceOf(new Failure('list.csv, line 3: no source')))).toBe('list.csv, line 3: no source');
});
