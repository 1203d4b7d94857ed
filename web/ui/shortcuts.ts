/** Which keys are heard where, as WCAG 2.1.4 asks: by voice or by a slip, a key of one character is soon typed. */
import { remember, remembered } from './memory';

const MEMORY = 'heatwalk.shortcuts';

/** Keys that are heard wherever the focus is, as characters are while shortcuts are on. */
const ANYWHERE: ReadonlySet<string> = new Set(['Escape', 'Delete', 'Backspace']);

let areOn = remembered(MEMORY) !== 'off';

/** Whether letters, digits and signs do something by themselves. */
export function hasShortcuts(): boolean {
  return areOn;
}

export function setShortcuts(on: boolean): void {
  areOn = on;
  remember(MEMORY, on ? 'on' : 'off');
}

export function isHeard({ key, ctrlKey, metaKey }: KeyboardEvent, onStage: boolean): boolean {
  // The space presses what has the focus.
  const isCharacter = key.length === 1 && key !== ' ';
  const isCommand = isCharacter && (ctrlKey || metaKey);
  if (isCommand || ANYWHERE.has(key)) return true;
  return isCharacter ? areOn : onStage;
}
