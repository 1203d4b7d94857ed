import { expect, test } from '@playwright/test';
import { clearOf } from '../../web/ui/stage/clear';

const ROOM = { left: 0, top: 0, width: 900, height: 700 };
const SIZE = [100, 50] as const;
const BAR = { left: 400, top: 650, width: 200, height: 50 };

test('what floats stays where it is put unless something else is there, and then as near as it can', () => {
  expect(clearOf([10, 20], SIZE, ROOM, [BAR], 4)).toEqual([10, 20]);
  expect(clearOf([450, 640], SIZE, ROOM, [BAR], 4)).toEqual([450, 596]);
  expect(clearOf([310, 690], SIZE, ROOM, [BAR], 4)).toEqual([296, 690]);
  // Between both there is no space.
  const other = { left: 200, top: 580, width: 190, height: 120 };
  expect(clearOf([310, 690], SIZE, ROOM, [BAR, other], 4)).toEqual([394, 596]);
});

test('it stays in its room, and where nothing is free it is where it was put', () => {
  expect(clearOf([-50, 5000], SIZE, ROOM, [], 4)).toEqual([0, 700]);
  expect(clearOf([450, 640], SIZE, ROOM, [{ left: -9, top: -9, width: 2000, height: 2000 }], 4)).toEqual([450, 640]);
});
