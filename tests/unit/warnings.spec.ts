/** What the page tells of a file that was read otherwise than it is written. */
import { expect, test } from '@playwright/test';
import type { OpenedMesh } from '../../web/protocol';
import { absentSentence } from '../../web/ui/overlay/read';

test('what was left out of a file is told with its place, before what is missing', () => {
  const mesh = {
    name: 'a.obj',
    missing: ['a.mtl'],
    undecoded: [],
    warnings: [
      { code: 'lines-left-out', count: 2, place: 'line 7' },
      { code: 'trailing', count: 1, place: 'byte 134' },
    ],
  } as unknown as OpenedMesh;
  expect(String(absentSentence(mesh))).toBe(
    'a.obj, line 7: 2 points or lines left out. a.obj, byte 134: there is more behind the end; it was left out. ' +
      'a.obj refers to a.mtl, which was not given.',
  );
});
