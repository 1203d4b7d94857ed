/** The keys of commands, as `keyOf` writes them, and how a person reads them. */
import { t, type Words } from '../texts';

export const KEYS = {
  source: '1',
  add: '2',
  walker: '3',
  line: '4',
  stroke: '5',
  boundary: '6',
  part: '7',
  measure: 'm',
  tape: 'd',
  brush: 'b',
  smaller: '[',
  larger: ']',
  fit: 'f',
  nearer: '+',
  farther: '-',
  front: '8',
  side: '9',
  top: '0',
  parallel: 'v',
  screen: 'x',
  legend: 'l',
  turntable: 't',
  up: 'u',
  pause: 'p',
  play: 'a',
  cut: 'i',
  back: ',',
  forward: '.',
  undo: 'ctrl+z',
  redo: 'ctrl+shift+z',
  open: 'o',
  search: 'ctrl+k',
  help: '?',
} as const;

/** The keys of an event: `p`, `ctrl+shift+z`; null with modifiers that no command has. */
export function keyOf({ key, ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent): string | null {
  if (altKey) return null;
  const letter = key.toLowerCase();
  if (!ctrlKey && !metaKey) return letter;
  return shiftKey ? `ctrl+shift+${letter}` : `ctrl+${letter}`;
}

/** As it stands on a keyboard: `P`, `Ctrl+Shift+Z`. */
export function keyName(key: string): Words {
  const letter = key.slice(-1).toUpperCase();
  if (key.startsWith('ctrl+shift')) return t`Ctrl+Shift+${letter}`;
  return key.startsWith('ctrl') ? `Ctrl+${letter}` : letter;
}

/** What a button does, and the key that does it too. */
export function withKey(what: Words, key: string): Words {
  return t`${what} (${keyName(key)})`;
}
