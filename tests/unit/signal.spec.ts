import { expect, test } from '@playwright/test';
import { Signal } from '../../web/state/signal';

test('a failing listener does not stop the others, and its error is reported', () => {
  const uncaught: unknown[] = [];
  const { queueMicrotask } = globalThis;
  globalThis.queueMicrotask = (task) => {
    try {
      task();
    } catch (error) {
      uncaught.push(error);
    }
  };
  try {
    const signal = new Signal(0);
    const heard: number[] = [];
    signal.watch((value) => {
      if (value === 1) throw new Error('defect');
    });
    signal.watch((value) => heard.push(value));
    signal.value = 1;
    signal.value = 2;
    expect(heard).toEqual([0, 1, 2]);
    expect(uncaught).toEqual([new Error('defect')]);
  } finally {
    globalThis.queueMicrotask = queueMicrotask;
  }
});
