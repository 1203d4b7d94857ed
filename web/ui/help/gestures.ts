/** What the hand can do: with a mouse, with fingers or a pen, and with the keyboard. Null: nothing does it. */
import { KEYS, keyName } from '../keys';
import { Phrase, t, type Words } from '../../texts';

export interface Gesture {
  what: Words;
  mouse: Words | null;
  touch: Words | null;
  /** Keys that are pressed together have a plus sign between them. */
  keys: Words | null;
}

/** With a blank between them. */
function keys(...commands: readonly (keyof typeof KEYS)[]): Words {
  return new Phrase(() => commands.map((command) => keyName(KEYS[command])).join(' '));
}

export const GESTURES: readonly Gesture[] = [
  { what: t('Orbit'), mouse: t('drag'), touch: t('one finger'), keys: '← → ↑ ↓' },
  {
    what: t('Pan'),
    mouse: t('right-drag, or shift-drag beside the model'),
    touch: t('two fingers'),
    keys: t('Ctrl+arrows'),
  },
  { what: t('Zoom'), mouse: t('wheel'), touch: t('pinch'), keys: '+ −' },
  { what: t('Frame the model'), mouse: t('double-click focuses a point'), touch: t('button'), keys: keys('fit') },
  {
    what: t('From the front, the side, above'),
    mouse: t('button'),
    touch: t('button'),
    keys: keys('front', 'side', 'top'),
  },
  { what: t('Full screen'), mouse: t('button'), touch: t('button'), keys: keys('screen') },
  { what: t('Turntable'), mouse: t('button'), touch: t('button'), keys: keys('turntable') },
  { what: t('Set the source'), mouse: t('click'), touch: t('tap'), keys: t('Enter') },
  { what: t('Add a source'), mouse: t('ctrl + click'), touch: t('tap with the Add tool'), keys: t('Shift+Enter') },
  {
    what: t('Line of sources'),
    mouse: t('shift + click'),
    touch: t('Draw, in the Sources section'),
    keys: keys('line'),
  },
  {
    what: t('Stroke, boundary, part as sources'),
    mouse: t('Draw, in the Sources section'),
    touch: t('Draw, in the Sources section'),
    keys: keys('stroke', 'boundary', 'part'),
  },
  {
    what: t('List of sources'),
    mouse: t('drop a CSV file'),
    touch: t('field in the Sources section'),
    keys: t('Ctrl+V'),
  },
  { what: t('Move a source'), mouse: t('drag its pin'), touch: t('drag its pin'), keys: t('arrows') },
  {
    what: t('Move a corner of the selected line'),
    mouse: t('drag'),
    touch: t('drag'),
    keys: t('Tab arrows'),
  },
  { what: t('Remove the selected source'), mouse: t('× in the list'), touch: t('× in the list'), keys: t('Delete') },
  { what: t('Place the walker'), mouse: t('alt + click'), touch: t('long press'), keys: 'W' },
  { what: t('Read the distance'), mouse: t('hover'), touch: null, keys: t('arrows') },
  {
    what: t('Tools: source, add, walker, measure'),
    mouse: t('buttons'),
    touch: t('buttons'),
    keys: keys('source', 'add', 'walker', 'measure'),
  },
  { what: t('Measure, with that tool'), mouse: t('click'), touch: t('tap'), keys: t('Enter') },
  { what: t('Measure from the walker to the source'), mouse: null, touch: null, keys: keys('tape') },
  {
    what: t('Close a tape'),
    mouse: t('double-click, or its first place'),
    touch: t('its first place'),
    keys: t('Enter there'),
  },
  { what: t('Move a place of a tape'), mouse: t('drag'), touch: t('drag'), keys: t('arrows') },
  { what: t('Pause or resume'), mouse: t('button'), touch: t('button'), keys: keys('pause') },
  { what: t('Play or stop the animation'), mouse: t('button'), touch: t('button'), keys: keys('play') },
  {
    what: t('Brush on or off; its size'),
    mouse: t('switch'),
    touch: t('switch'),
    keys: keys('brush', 'smaller', 'larger'),
  },
  {
    what: t('Fill the surface, cut it open; move the cut'),
    mouse: t('drag its handle'),
    touch: t('drag its handle'),
    keys: keys('cut', 'back', 'forward'),
  },
  { what: t('Turn the next axis up'), mouse: t('Display section'), touch: t('Display section'), keys: keys('up') },
  { what: t('Legend on or off'), mouse: t('Display section'), touch: t('Display section'), keys: keys('legend') },
  { what: t('Move the legend'), mouse: t('drag'), touch: t('drag'), keys: t('Tab arrows') },
  { what: t('Open a file'), mouse: t('drop it, or paste it'), touch: t('button'), keys: keys('open') },
  { what: t('Undo, redo'), mouse: t('buttons'), touch: t('buttons'), keys: keys('undo', 'redo') },
  { what: t('Cancel, close, back out'), mouse: t('button'), touch: t('button'), keys: t('Esc') },
  {
    what: t('Search settings and commands'),
    mouse: t('button'),
    touch: t('button'),
    keys: keys('search'),
  },
  { what: t('This help'), mouse: t('button'), touch: t('button'), keys: keys('help') },
];
