import { expect, test } from '@playwright/test';
import type { MeshPoint } from '../../web/protocol';
import type { Session } from '../../web/session/session';
import { Scene } from '../../web/state/history';
import { emptyScene } from '../../web/state/scene';
import { Signal } from '../../web/state/signal';
import { MeasureInput } from '../../web/ui/measure/input';
import type { Tool } from '../../web/state/tool';

const pick = (x: number) => (x < 0 ? null : { point: { vertex: x }, position: [0, 0, 0] });

/** A page on which the pixel (x, y) shows vertex x; where x is negative, nothing. */
function measuring() {
  const scene = new Scene(emptyScene({ kind: 'preset', id: 'bunny' }));
  const tool = new Signal<Tool>('measure');
  const input = new MeasureInput({ scene, view: { pick } } as unknown as Session, tool);
  let time = 0;
  const click = (x: number, later = 1000, over: Partial<PointerEvent> = {}) => {
    time += later;
    return input.click({ clientX: x, clientY: 0, timeStamp: time, ...over } as PointerEvent);
  };
  const tapes = () =>
    scene.state.tapes.map(({ points, closed }) => [
      points.map((point) => (point as { vertex: number }).vertex),
      closed,
    ]);
  return { scene, tool, input, click, tapes, now: () => time };
}

test('clicks lay a tape, Escape ends it, and the next click begins another', () => {
  const { input, click, tapes } = measuring();
  for (const x of [10, 50, 90]) expect(click(x)).toBe(true);
  expect(tapes()).toEqual([[[10, 50, 90], false]]);
  expect(input.end()).toBe(true);
  expect(input.end()).toBe(false);
  click(30);
  expect(tapes()).toEqual([
    [[10, 50, 90], false],
    [[30], false],
  ]);
});

test('a double click closes the tape where it has three places, and ends it in any case', () => {
  const { click, tapes } = measuring();
  for (const x of [10, 50, 90]) click(x);
  click(91, 100);
  expect(tapes()).toEqual([[[10, 50, 90], true]]);
  for (const x of [20, 60]) click(x);
  click(60, 100);
  expect(tapes()[1]).toEqual([[20, 60], false]);
  click(5);
  expect(tapes()).toHaveLength(3);
});

test('quick clicks at different places are places', () => {
  const { click, tapes } = measuring();
  for (const x of [10, 50, 90]) click(x, 100);
  expect(tapes()).toEqual([[[10, 50, 90], false]]);
});

test('a click on the first place closes the tape that is being laid, and no other', () => {
  const { input, click, tapes, now } = measuring();
  for (const x of [10, 50, 90]) click(x);
  input.end();
  input.clickPlace(0, 0, now() + 1000);
  expect(tapes()[0][1]).toBe(false);
  for (const x of [20, 60, 80]) click(x);
  input.clickPlace(1, 1, now() + 1000);
  expect(tapes()[1][1]).toBe(false);
  input.clickPlace(1, 0, now() + 1000);
  expect(tapes()[1][1]).toBe(true);
});

test('a click on the last place ends the tape that is being laid, where it has more than one', () => {
  const { input, click, tapes, now } = measuring();
  click(20);
  input.clickPlace(0, 0, now() + 1000);
  click(60);
  input.clickPlace(0, 1, now() + 1000);
  click(80);
  expect(tapes()).toEqual([
    [[20, 60], false],
    [[80], false],
  ]);
});

test('other tools, modifiers and clicks beside the model add no place', () => {
  const { tool, input, click, tapes } = measuring();
  expect(click(-1)).toBe(true);
  expect(click(10, 1000, { shiftKey: true })).toBe(false);
  tool.value = 'source';
  expect(click(10)).toBe(false);
  expect(input.add({ vertex: 1 } as MeshPoint)).toBe(false);
  expect(tapes()).toEqual([]);
});

test('after undo of its first place, the next click begins a tape', () => {
  const { scene, click, tapes } = measuring();
  click(10);
  scene.undo();
  click(50);
  expect(tapes()).toEqual([[[50], false]]);
});
