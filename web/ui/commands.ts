/** What keys and the search do: each with its name. */
import type { GroundEditor } from '../session/ground';
import type { Opener } from '../session/opener';
import type { Session } from '../session/session';
import { RADII } from '../state/brush';
import { lookInto, turnUp } from '../state/edit';
import { DEFAULT_FILL, INSIDE_RANGES } from '../state/inside';
import type { Signal } from '../state/signal';
import type { Tool } from '../state/tool';
import type { Stage } from './stage/stage';
import { t, type Words } from '../texts';

export interface Command {
  name: Words;
  /** As `keyOf` writes them; the first one is told. */
  keys: readonly string[];
  /** `gesture`: commands of the same one are one step of undo. */
  run: (gesture: object) => void;
}

export interface CommandsOptions {
  session: Session;
  opener: Opener;
  ground: GroundEditor;
  tool: Signal<Tool>;
  stage: Stage;
  chooseFile: () => void;
  /** Null where the browser opens no folders. */
  chooseFolder: (() => void) | null;
  help: () => void;
  search: () => void;
  cameraMoved: () => void;
}

const ZOOM_STEP = 1.15;
const BRUSH_STEP = 1.2;
/** How far a key moves the cut, as a share of the way from the middle to the end. */
const CUT_STEP = 0.02;

const TOOLS: readonly (readonly [Tool, string, Words])[] = [
  ['source', '1', t('Set the source')],
  ['add', '2', t('Add a source')],
  ['walker', '3', t('Place the walker')],
  ['line', '4', t('Draw a line of sources along edges')],
  ['stroke', '5', t('Draw a stroke of sources')],
  ['boundary', '6', t('Make a whole boundary a source')],
  ['part', '7', t('Make a whole part a source')],
  ['measure', 'm', t('Measure')],
];

/** The keys of an event as commands name them: `p`, `ctrl+shift+z`; null with modifiers that no command has. */
export function keyOf({ key, ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent): string | null {
  if (altKey) return null;
  const letter = key.toLowerCase();
  if (!ctrlKey && !metaKey) return letter;
  return shiftKey ? `ctrl+shift+${letter}` : `ctrl+${letter}`;
}

export function commandsOf(options: CommandsOptions): readonly Command[] {
  const { session, opener, ground, tool, stage, chooseFile, chooseFolder, help, search } = options;
  const { scene, view } = session;
  return [
    ...TOOLS.map(([which, key, name]) => command(name, [key], () => (tool.value = which))),
    command(t('Measure from the walker to the source'), ['d'], () => measureWalk(session)),
    command(t('Brush on or off'), ['b'], () => (tool.value = ground.isOn ? 'source' : 'brush')),
    command(t('Smaller brush'), ['['], () => resizeBrush(ground, 1 / BRUSH_STEP)),
    command(t('Larger brush'), [']'], () => resizeBrush(ground, BRUSH_STEP)),
    command(t('Frame the model'), ['f'], () => moved(options, () => view.frame())),
    command(t('Zoom in'), ['+', '='], () => moved(options, () => view.zoom(ZOOM_STEP))),
    command(t('Zoom out'), ['-'], () => moved(options, () => view.zoom(1 / ZOOM_STEP))),
    command(t('View from the front'), ['8'], () => stage.show('front')),
    command(t('View from the side'), ['9'], () => stage.show('side')),
    command(t('View from above'), ['0'], () => stage.show('top')),
    command(t('Orthographic or perspective'), ['v'], () => stage.show('parallel')),
    command(t('Full screen'), ['x'], () => stage.show('screen')),
    command(t('Legend on or off'), ['l'], toggle(stage.legend)),
    command(t('Turntable'), ['t'], toggle(session.turntable)),
    command(t('Turn the next axis up'), ['u'], () => {
      if (session.shown.value) turnUp(scene, session.shown.value.opened.upright);
    }),
    command(t('Pause or resume'), ['p'], toggle(session.paused)),
    command(t('Play or stop the animation'), ['a'], () => session.animator.toggle()),
    command(t('Fill the surface, or cut it open'), ['i'], () => cutOpen(session, opener)),
    command(t('Move the cut back'), [','], (gesture) => moveCut(session, -CUT_STEP, gesture)),
    command(t('Move the cut forward'), ['.'], (gesture) => moveCut(session, CUT_STEP, gesture)),
    command(t('Undo'), ['ctrl+z'], () => scene.undo()),
    command(t('Redo'), ['ctrl+shift+z', 'ctrl+y'], () => scene.redo()),
    command(t('Open a file'), ['o'], chooseFile),
    ...(chooseFolder ? [command(t('Open a folder'), [], chooseFolder)] : []),
    command(t('Search settings and commands'), ['ctrl+k'], search),
    command(t('Help'), ['?'], help),
  ];
}

function command(name: Words, keys: readonly string[], run: (gesture: object) => unknown): Command {
  return { name, keys, run };
}

function toggle(signal: Signal<boolean>): () => void {
  return () => {
    signal.value = !signal.value;
  };
}

function moved({ cameraMoved }: CommandsOptions, move: () => void): void {
  move();
  cameraMoved();
}

function resizeBrush(ground: GroundEditor, factor: number): void {
  const radius = ground.brush.value.radius * factor;
  ground.set({ radius: Math.min(RADII[1], Math.max(RADII[0], radius)) });
}

/** A tape from the walker to the selected source, or else to the first. */
function measureWalk({ scene }: Session): void {
  const { sources, selected, tapes, walker } = scene.state;
  const source = sources[selected] ?? sources[0];
  if (walker && source) scene.edit({ tapes: [...tapes, { points: [walker, source], closed: false }] });
}

/** Cuts tetrahedra open, or closes them; a surface is filled. */
export function cutOpen({ scene, shown }: Session, opener: Opener): void {
  if (shown.value?.opened.interior === null) void opener.fill(DEFAULT_FILL);
  else lookInto(scene, { cut: scene.state.inside.cut === 'none' ? 'plane' : 'none' }, {});
}

function moveCut({ scene, shown }: Session, step: number, gesture: object): void {
  const { inside } = scene.state;
  if (!shown.value?.opened.interior || inside.cut === 'none') return;
  const [least, most] = INSIDE_RANGES.place;
  lookInto(scene, { place: Math.min(most, Math.max(least, inside.place + step)) }, gesture);
}
