import { expect, test } from '@playwright/test';
import { isHeard, setShortcuts } from '../../web/ui/shortcuts';

const pressed = (key: string, modifiers: Partial<KeyboardEvent> = {}) =>
  ({ key, ctrlKey: false, metaKey: false, ...modifiers }) as KeyboardEvent;

test.afterEach(() => setShortcuts(true));

test('a key of one character is heard wherever the focus is, unless shortcuts are off', () => {
  for (const key of ['a', 'P', '7', '+', '?', '[', ',']) {
    expect(isHeard(pressed(key), true), key).toBe(true);
    expect(isHeard(pressed(key), false), key).toBe(true);
    setShortcuts(false);
    expect(isHeard(pressed(key), true), key).toBe(false);
    expect(isHeard(pressed(key), false), key).toBe(false);
    setShortcuts(true);
  }
});

test('arrows, Enter and the space belong to what has the focus, and to the stage with shortcuts or without', () => {
  for (const key of ['ArrowUp', 'ArrowLeft', 'Enter', ' ']) {
    expect(isHeard(pressed(key), false), key).toBe(false);
    expect(isHeard(pressed(key, { ctrlKey: true }), false), key).toBe(false);
    setShortcuts(false);
    expect(isHeard(pressed(key), true), key).toBe(true);
  }
});

test('undo, Escape and Delete are heard everywhere', () => {
  setShortcuts(false);
  for (const event of [
    pressed('z', { ctrlKey: true }),
    pressed('y', { metaKey: true }),
    pressed('Escape'),
    pressed('Delete'),
  ])
    expect(isHeard(event, false), event.key).toBe(true);
});
