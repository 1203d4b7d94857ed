import { expect, test } from '@playwright/test';
import { Walk } from '../../web/view/walk';

const DIAMETER = 7;

test('walks at constant speed, rests a second on arrival and starts again', () => {
  const walk = new Walk();
  walk.follow(3, true);
  expect(walk.advance(1, DIAMETER)).toBe(true);
  expect(walk.arc).toBeCloseTo(1);
  walk.advance(5, DIAMETER);
  expect(walk.arrived).toBe(true);
  expect(walk.arc).toBe(3);
  expect(walk.advance(0.6, DIAMETER)).toBe(false);
  expect(walk.advance(0.6, DIAMETER)).toBe(true);
  expect(walk.arc).toBe(0);
});

test('walks as many times slower as it costs', () => {
  const walk = new Walk();
  walk.follow(3, true, (arc) => (arc < 1 ? 4 : 0.5));
  for (let i = 0; i < 40; i++) walk.advance(0.1, DIAMETER);
  expect(walk.arc).toBeCloseTo(1);
  for (let i = 0; i < 5; i++) walk.advance(0.1, DIAMETER);
  expect(walk.arc).toBeCloseTo(2);
});

test('stands still while paused and without a path', () => {
  const walk = new Walk();
  expect(walk.advance(1, DIAMETER)).toBe(false);
  walk.follow(3, true);
  walk.paused = true;
  expect(walk.advance(1, DIAMETER)).toBe(false);
  expect(walk.arc).toBe(0);
});

test('keeps its share of the path when the path changes', () => {
  const walk = new Walk();
  walk.follow(4, true);
  walk.advance(1, DIAMETER);
  walk.follow(8, false);
  expect(walk.arc).toBeCloseTo(2);
  walk.follow(8, true);
  expect(walk.arc).toBe(0);
});

test('a performance runs once from the start even while paused, and resolves after arrival and rest', async () => {
  const walk = new Walk();
  walk.follow(3, true);
  walk.advance(2, DIAMETER);
  walk.paused = true;
  const performance = walk.perform();
  expect(walk.arc).toBe(0);
  expect(walk.advance(3, DIAMETER)).toBe(true);
  expect([walk.arrived, walk.performs]).toEqual([true, true]);
  walk.advance(1, DIAMETER);
  await performance;
  expect(walk.performs).toBe(false);
  expect(walk.advance(1, DIAMETER)).toBe(false);
});

test('a performance ends when its path is removed', async () => {
  const walk = new Walk();
  walk.follow(3, true);
  const performance = walk.perform();
  walk.follow(0, false);
  await performance;
  expect(walk.performs).toBe(false);
});

test('another performance ends the first and starts over', async () => {
  const walk = new Walk();
  walk.follow(3, true);
  const first = walk.perform();
  walk.advance(2, DIAMETER);
  const second = walk.perform();
  await first;
  expect([walk.arc, walk.performs]).toEqual([0, true]);
  walk.advance(3, DIAMETER);
  walk.advance(1, DIAMETER);
  await second;
  expect(walk.performs).toBe(false);
});
