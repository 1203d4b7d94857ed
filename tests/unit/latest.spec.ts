import { expect, test } from '@playwright/test';
import { Latest } from '../../web/solver/latest';

test('of messages that have come by now only the last is the last', async () => {
  const latest = new Latest();
  expect(await Promise.all([latest.isLast(), latest.isLast(), latest.isLast()])).toEqual([false, false, true]);
  expect(await latest.isLast()).toBe(true);
});
