/** What the hand can do: with a mouse, with fingers or a pen, and with the keyboard. Null: nothing does it. */
export interface Gesture {
  what: string;
  mouse: string | null;
  touch: string | null;
  /** Keys that are pressed together have a plus sign between them. */
  keys: string | null;
}

export const GESTURES: readonly Gesture[] = [
  { what: 'Orbit', mouse: 'drag', touch: 'one finger', keys: '← → ↑ ↓' },
  { what: 'Pan', mouse: 'right-drag, or shift-drag beside the model', touch: 'two fingers', keys: 'Ctrl+arrows' },
  { what: 'Zoom', mouse: 'wheel', touch: 'pinch', keys: '+ −' },
  { what: 'Frame the model', mouse: 'double-click focuses a point', touch: 'button', keys: 'F' },
  { what: 'Turntable', mouse: 'button', touch: 'button', keys: 'T' },
  { what: 'Set the source', mouse: 'click', touch: 'tap', keys: 'Enter' },
  { what: 'Add a source', mouse: 'ctrl + click', touch: 'tap with the Add tool', keys: 'Shift+Enter' },
  { what: 'Line of sources', mouse: 'shift + click', touch: 'Draw, in the Sources section', keys: '4' },
  {
    what: 'Stroke, boundary, part as sources',
    mouse: 'Draw, in the Sources section',
    touch: 'Draw, in the Sources section',
    keys: '5 6 7',
  },
  { what: 'List of sources', mouse: 'drop a CSV file', touch: 'field in the Sources section', keys: 'Ctrl+V' },
  { what: 'Move a source', mouse: 'drag its pin', touch: 'drag its pin', keys: 'arrows' },
  { what: 'Remove the selected source', mouse: '× in the list', touch: '× in the list', keys: 'Delete' },
  { what: 'Place the walker', mouse: 'alt + click', touch: 'long press', keys: 'W' },
  { what: 'Read the distance', mouse: 'hover', touch: null, keys: 'arrows' },
  { what: 'Tools: source, add, walker, measure', mouse: 'buttons', touch: 'buttons', keys: '1 2 3 M' },
  { what: 'Measure, with that tool', mouse: 'click', touch: 'tap', keys: 'Enter' },
  { what: 'Close a tape', mouse: 'double-click, or its first place', touch: 'its first place', keys: 'Enter there' },
  { what: 'Move a place of a tape', mouse: 'drag', touch: 'drag', keys: 'arrows' },
  { what: 'Pause or resume', mouse: 'button', touch: 'button', keys: 'P' },
  { what: 'Play or stop the animation', mouse: 'button', touch: 'button', keys: 'A' },
  { what: 'Brush on or off; its size', mouse: 'switch', touch: 'switch', keys: 'B [ ]' },
  {
    what: 'Fill the surface, cut it open; move the cut',
    mouse: 'drag its handle',
    touch: 'drag its handle',
    keys: 'I , .',
  },
  { what: 'Turn the next axis up', mouse: 'Display section', touch: 'Display section', keys: 'U' },
  { what: 'Open a file', mouse: 'drop it, or paste it', touch: 'button', keys: 'O' },
  { what: 'Undo, redo', mouse: 'buttons', touch: 'buttons', keys: 'Ctrl+Z Ctrl+Shift+Z' },
  { what: 'Cancel, close, back out', mouse: 'button', touch: 'button', keys: 'Esc' },
  { what: 'This help', mouse: 'button', touch: 'button', keys: '?' },
];
