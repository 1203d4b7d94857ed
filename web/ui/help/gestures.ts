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

const gesture = (what: Words, mouse: Words | null, touch: Words | null, pressed: Words | null): Gesture => ({
  what,
  mouse,
  touch,
  keys: pressed,
});

const byButton = (what: Words, ...commands: readonly (keyof typeof KEYS)[]): Gesture =>
  gesture(what, t('button'), t('button'), keys(...commands));

export const GESTURES: readonly Gesture[] = [
  gesture(t('Orbit'), t('drag'), t('one finger'), '← → ↑ ↓'),
  gesture(t('Pan'), t('right-drag, or shift-drag beside the model'), t('two fingers'), t('Ctrl+arrows')),
  gesture(t('Zoom'), t('wheel'), t('pinch'), '+ −'),
  gesture(t('Frame the model'), t('double-click focuses a point'), t('button'), keys('fit')),
  byButton(t('From the front, the side, above'), 'front', 'side', 'top'),
  byButton(t('Full screen'), 'screen'),
  byButton(t('Turntable'), 'turntable'),
  gesture(t('Set the source'), t('click'), t('tap'), t('Enter')),
  gesture(t('Add a source'), t('ctrl + click'), t('tap with the Add tool'), t('Shift+Enter')),
  gesture(t('Line of sources'), t('shift + click'), t('Draw, in the Sources section'), keys('line')),
  gesture(
    t('Stroke, boundary, part as sources'),
    t('Draw, in the Sources section'),
    t('Draw, in the Sources section'),
    keys('stroke', 'boundary', 'part'),
  ),
  gesture(t('List of sources'), t('drop a CSV file'), t('field in the Sources section'), t('Ctrl+V')),
  gesture(t('Move a source'), t('drag its pin'), t('drag its pin'), t('arrows')),
  gesture(t('Move a corner of the selected line'), t('drag'), t('drag'), t('Tab arrows')),
  gesture(t('Remove the selected source'), t('× in the list'), t('× in the list'), t('Delete')),
  gesture(t('Place the walker'), t('alt + click'), t('long press'), 'W'),
  gesture(t('Read the distance'), t('hover'), null, t('arrows')),
  gesture(
    t('Tools: source, add, walker, measure'),
    t('buttons'),
    t('buttons'),
    keys('source', 'add', 'walker', 'measure'),
  ),
  gesture(t('Measure, with that tool'), t('click'), t('tap'), t('Enter')),
  gesture(t('Measure from the walker to the source'), null, null, keys('tape')),
  gesture(t('End a tape'), t('its last place'), t('its last place'), t('Esc')),
  gesture(t('Close a tape'), t('double-click, or its first place'), t('its first place'), t('Enter there')),
  gesture(t('Move a place of a tape'), t('drag'), t('drag'), t('arrows')),
  byButton(t('Pause or resume'), 'pause'),
  byButton(t('Play or stop the animation'), 'play'),
  gesture(t('Brush on or off; its size'), t('switch'), t('switch'), keys('brush', 'smaller', 'larger')),
  gesture(
    t('Fill the surface, cut it open; move the cut'),
    t('drag its handle'),
    t('drag its handle'),
    keys('cut', 'back', 'forward'),
  ),
  gesture(t('Turn the next axis up'), t('Display section'), t('Display section'), keys('up')),
  gesture(t('Legend on or off'), t('Display section'), t('Display section'), keys('legend')),
  gesture(t('Move the legend'), t('drag'), t('drag'), t('Tab arrows')),
  gesture(t('Open a file'), t('drop it, or paste it'), t('button'), keys('open')),
  gesture(t('Undo, redo'), t('buttons'), t('buttons'), keys('undo', 'redo')),
  gesture(t('Cancel, close, back out'), t('button'), t('button'), t('Esc')),
  byButton(t('Search settings and commands'), 'search'),
  byButton(t('This help'), 'help'),
];
