/** What keys and the search do: each with its name. */
import type { GroundEditor } from '../session/ground';
import type { Opener } from '../session/opener';
import type { Session } from '../session/session';
import { RADII } from '../state/brush';
import { lookInto, turnUp } from '../state/edit';
import { DEFAULT_FILL, INSIDE_RANGES } from '../state/inside';
import type { Signal } from '../state/signal';
import type { Tool } from '../state/tool';
import { KEYS } from './keys';
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

const TOOLS: readonly (readonly [Tool & keyof typeof KEYS, Words])[] = [
  ['source', t('Set the source')],
  ['add', t('Add a source')],
  ['walker', t('Place the walker')],
  ['line', t('Draw a line of sources along edges')],
  ['stroke', t('Draw a stroke of sources')],
  ['boundary', t('Make a whole boundary a source')],
  ['part', t('Make a whole part a source')],
  ['measure', t('Measure')],
];

export function commandsOf(options: CommandsOptions): readonly Command[] {
  const { session, opener, ground, tool, stage, chooseFile, chooseFolder, help, search } = options;
  const { scene, view } = session;
  return [
    ...TOOLS.map(([which, name]) => command(name, [KEYS[which]], () => (tool.value = which))),
    command(t('Measure from the walker to the source'), [KEYS.tape], () => measureWalk(session)),
    command(t('Brush on or off'), [KEYS.brush], () => {
      if (ground.isOn) tool.value = 'source';
      else ground.take({});
    }),
    command(t('Smaller brush'), [KEYS.smaller], () => resizeBrush(ground, 1 / BRUSH_STEP)),
    command(t('Larger brush'), [KEYS.larger], () => resizeBrush(ground, BRUSH_STEP)),
    command(t('Frame the model'), [KEYS.fit], () => moved(options, () => view.frame())),
    command(t('Zoom in'), [KEYS.nearer, '='], () => moved(options, () => view.zoom(ZOOM_STEP))),
    command(t('Zoom out'), [KEYS.farther], () => moved(options, () => view.zoom(1 / ZOOM_STEP))),
    command(t('View from the front'), [KEYS.front], () => stage.show('front')),
    command(t('View from the side'), [KEYS.side], () => stage.show('side')),
    command(t('View from above'), [KEYS.top], () => stage.show('top')),
    command(t('Orthographic or perspective'), [KEYS.parallel], () => stage.show('parallel')),
    command(t('Full screen'), [KEYS.screen], () => stage.show('screen')),
    command(t('Legend on or off'), [KEYS.legend], toggle(stage.legend)),
    command(t('Turntable'), [KEYS.turntable], toggle(session.turntable)),
    command(t('Turn the next axis up'), [KEYS.up], () => {
      if (session.shown.value) turnUp(scene, session.shown.value.opened.upright);
    }),
    command(t('Pause or resume'), [KEYS.pause], toggle(session.paused)),
    command(t('Play or stop the animation'), [KEYS.play], () => session.animator.toggle()),
    command(t('Fill the surface, or cut it open'), [KEYS.cut], () => cutOpen(session, opener)),
    command(t('Move the cut back'), [KEYS.back], (gesture) => moveCut(session, -CUT_STEP, gesture)),
    command(t('Move the cut forward'), [KEYS.forward], (gesture) => moveCut(session, CUT_STEP, gesture)),
    command(t('Undo'), [KEYS.undo], () => scene.undo()),
    command(t('Redo'), [KEYS.redo, 'ctrl+y'], () => scene.redo()),
    command(t('Open a file'), [KEYS.open], chooseFile),
    ...(chooseFolder ? [command(t('Open a folder'), [], chooseFolder)] : []),
    command(t('Search settings and commands'), [KEYS.search], search),
    command(t('Help'), [KEYS.help], help),
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
