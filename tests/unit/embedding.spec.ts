import { expect, test } from '@playwright/test';
import { addressed, parseRequest } from '../../web/ui/embedding/requests';
import { filePlace } from '../../web/session/nearest';
import { UP } from '../../web/wasm/contract';

const ask = (method: string, rest: object = {}) => parseRequest({ heatwalk: 1, id: 1, method, ...rest });

test('messages of others are none of ours', () => {
  for (const other of [null, 'heatwalk', 5, [], {}, { id: 1 }, { heatwalk: 1 }, { heatwalk: 1, id: '1' }])
    expect(addressed(other)).toBeNull();
  expect(addressed({ heatwalk: 2, id: 3 })).toEqual({ id: 3, version: 2 });
});

test('requests are taken as they are meant, without what does not belong to them', () => {
  expect(ask('state', { more: 1 })).toEqual({ heatwalk: 1, id: 1, method: 'state' });
  expect(ask('open', { preset: 'torus', options: { near: 0 } })).toMatchObject({
    preset: 'torus',
    options: { near: 0 },
  });
  const content = new ArrayBuffer(4);
  expect(ask('open', { files: [{ name: 'a.off', content }] })).toMatchObject({ files: [{ name: 'a.off', content }] });
  const sources = [
    { vertex: 3, more: 1 },
    { face: 0, weights: [0.5, 0.5, 0], offset: 2 },
  ];
  expect(ask('setSources', { sources })).toMatchObject({
    sources: [{ vertex: 3 }, { face: 0, weights: [0.5, 0.5, 0], offset: 2 }],
  });
  expect(ask('setWalker', { walker: { tetrahedron: 1, weights: [0.25, 0.25, 0.25, 0.25] } })).toMatchObject({
    walker: { tetrahedron: 1 },
  });
  expect(ask('setWalker', { walker: null })).toMatchObject({ walker: null });
  expect(ask('picture')).toMatchObject({ scale: 1, clear: false });
});

for (const [what, method, rest, sentence] of [
  ['no method', 'toString', {}, 'There is no method “toString”; there are hello, open,'],
  ['nothing to open', 'open', {}, 'open takes one of preset, url, files, link.'],
  ['two things to open', 'open', { preset: 'a', url: 'b' }, 'open takes one of'],
  ['a preset that is no text', 'open', { preset: 5 }, 'preset is 5; a text is needed.'],
  ['no files', 'open', { files: [] }, 'files is a list of one file at least.'],
  ['a file without a name', 'open', { files: [{ content: new ArrayBuffer(1) }] }, 'files[0].name is missing'],
  ['a file that is a text', 'open', { files: [{ name: 'a.off', content: 'OFF' }] }, 'files[0].content is “OFF”'],
  ['options of a link', 'open', { link: '#m=a', options: {} }, 'leave out one of link and options'],
  [
    'an option of the address',
    'set',
    { options: { kiosk: 1 } },
    'kiosk is no option: in a link it hides the panel, when the page is loaded; write it into the address of the page.',
  ],
  [
    'a workspace',
    'set',
    { options: { open: 'look' } },
    'open is no option: in a link it names the workspace of the panel, when the page is loaded; write it into the address',
  ],
  [
    'a mesh among the options',
    'set',
    { options: { m: 'torus' } },
    'm is no option: in a link it says which mesh is shown; give open one of preset, url, files, link.',
  ],
  ['the version of a link', 'set', { options: { v: 1 } }, 'v is no option: it is the version of a link; leave it out.'],
  ['an option that is a list', 'set', { options: { s: [1] } }, 'The option s is [1]; a text or a number is needed.'],
  ['an option that is no number', 'set', { options: { near: NaN } }, 'The option near is NaN'],
  ['sources that are none', 'setSources', { sources: 'all' }, 'sources is “all”; a list is needed.'],
  ['a vertex below 0', 'setSources', { sources: [{ vertex: -1 }] }, 'sources[0] is {"vertex":-1}'],
  ['two kinds of place', 'setWalker', { walker: { vertex: 1, face: 1 } }, 'walker is {"vertex":1,"face":1}'],
  ['weights too few', 'setWalker', { walker: { face: 1, weights: [1, 0] } }, 'walker.weights is [1,0]; 3 numbers'],
  ['weights that miss 1', 'setWalker', { walker: { face: 1, weights: [1, 0.5, 0] } }, '3 numbers from 0 that sum to 1'],
  ['an offset below 0', 'setSources', { sources: [{ vertex: 1, offset: -1 }] }, 'sources[0].offset is -1'],
  ['too large a picture', 'picture', { scale: 5 }, 'scale is 5; a number from 1 to 4 is needed.'],
] as const) {
  test(`${what}: refused with a sentence`, () => {
    expect(() => ask(method, rest)).toThrow(sentence);
  });
}

test('another version is refused with both numbers', () => {
  expect(() => parseRequest({ heatwalk: 2, id: 1, method: 'state' })).toThrow('version 1 of the messages');
});

test('what is drawn goes back to the axes of the file, whatever points up', () => {
  // As the solver turns them: `Up::turned`.
  const turned = {
    y: ([x, y, z]: number[]) => [x, y, z],
    z: ([x, y, z]: number[]) => [x, z, -y],
    x: ([x, y, z]: number[]) => [-y, x, z],
    '-y': ([x, y, z]: number[]) => [x, -y, -z],
    '-z': ([x, y, z]: number[]) => [x, -z, y],
    '-x': ([x, y, z]: number[]) => [y, -x, z],
  };
  const center: [number, number, number] = [10, 20, 30];
  for (const up of UP.names) {
    const [x = NaN, y = NaN, z = NaN] = turned[up]([1, 2, 3].map((along) => along / 2));
    expect(filePlace([x, y, z], { center, scale: 0.5, up })).toEqual([11, 22, 33]);
  }
});
