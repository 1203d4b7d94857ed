import { NO_GROUND } from '../../session/ground';
import type { Session } from '../../session/session';
import type { Signal } from '../../state/signal';
import type { Tool } from '../../state/tool';
import { type Workspace, WORKSPACES } from '../../state/workspace';
import { attribute, h, icon } from '../dom';
import { KEYS, keyName, withKey } from '../keys';
import type { Stage } from '../stage/stage';
import { t, type Words } from '../../texts';

interface ToolButton {
  tool: Tool;
  name: Words;
  tip: Words;
  path: string;
}

/** One whose tip is what it does and its key. */
const plainTool = (tool: Tool & keyof typeof KEYS, name: Words, does: Words, path: string): ToolButton => ({
  tool,
  name,
  tip: withKey(does, KEYS[tool]),
  path,
});

/** Those that are always there. */
const TOOLS: readonly ToolButton[] = [
  plainTool(
    'source',
    t('Source'),
    t('Click sets the source'),
    'M10 18s-5-5.2-5-9a5 5 0 0 1 10 0c0 3.800-5 9-5 9zM10 9.100v-.2',
  ),
  {
    tool: 'add',
    name: t('Add'),
    tip: t`Click adds a source (${KEYS.add}); ctrl + click with any tool`,
    path: 'M8 18s-5-5.200-5-9a5 5 0 0 1 8.500-3.600M14 9v6M11 12h6',
  },
  {
    tool: 'walker',
    name: t('Walker'),
    tip: t`Click places the walker (${KEYS.walker}); alt + click with any tool`,
    path: 'M11 3.500v.1M10.500 7l-1 5 3 2 1 4M9.500 12l-3 6M6 10l2-3h3l2 3 2 .5',
  },
  {
    tool: 'measure',
    name: t('Measure'),
    tip: t`Clicks measure between places (${keyName(KEYS.measure)}); the last place again ends a tape`,
    path: 'M3 13.500L13.500 3l3.500 3.500L6.500 17zM6 10.500l1.500 1.500M8.500 8l2 2M11 5.500l1.500 1.500',
  },
];

/** Those of a workspace, while it is open. */
const TOOLS_OF: Partial<Record<Workspace, readonly ToolButton[]>> = {
  scene: [
    plainTool('line', t('Line'), t('Draw a line of sources along edges'), 'M3 16l5-7 5 3 4-8'),
    plainTool('stroke', t('Stroke'), t('Draw a stroke of sources'), 'M3 14c3-9 5-9 7-4s4 5 7-4'),
    plainTool(
      'boundary',
      t('Boundary'),
      t('Make a whole boundary a source'),
      'M10 4c4 0 7 2.500 7 6s-3 6-7 6-7-2.500-7-6 3-6 7-6z',
    ),
    plainTool('part', t('Part'), t('Make a whole part a source'), 'M3 8l5-4 5 4v6l-5 3-5-3zM13 8l4-2v6l-4 2'),
  ],
  ground: [
    plainTool(
      'brush',
      t('Brush'),
      t('The pointer paints the ground'),
      'M16.500 3.500c-4 2-6.500 5-7.500 7l1.500 1.500c2-1 5-3.500 6-8.500zM8 11.500c-2 0-3 1-3 3 0 1-.5 1.500-1.500 2 3 .5 5.500-.5 6-3.500',
    ),
  ],
};
const CUT = 'M3 6l7-3 7 3v8l-7 3-7-3zM3 6l14 8';

const PAUSE = 'M7 4v12M13 4v12';
const PLAY = 'M6 4l10 6-10 6z';
const FRAME = 'M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M10 10v.1';
const VIEWS = 'M10 2.500l6.500 3.500v8L10 17.500 3.500 14V6zM3.500 6L10 9.500 16.500 6M10 9.500v8';
const TURN = 'M16.500 10a6.500 4 0 1 1-2.500-3.100M14 3.500v3.500h-3.500';
const UNDO = 'M8 4L4 8l4 4M4 8h8a4 4 0 0 1 0 8H8';
const REDO = 'M12 4l4 4-4 4M16 8H8a4 4 0 0 0 0 8h4';

/** `open`: the workspace whose tools are there too; null where there are none. `cut`: cuts what has an inside open. */
export function toolbar(
  session: Session,
  tool: Signal<Tool>,
  stage: Pick<Stage, 'menu'>,
  open: Signal<Workspace> | null,
  pinned: Signal<Workspace | null>,
  cut: () => void,
): HTMLElement {
  const { scene, view, paused } = session;
  const toolButton = ({ tool: which, name, tip, path }: ToolButton) => {
    const choose = () => {
      tool.value = which;
    };
    const button = h('button', { class: 'tool', title: tip, onclick: choose }, icon(path), h('span', {}, name));
    tool.watch((value) => button.setAttribute('aria-pressed', String(value === which)));
    if (which === 'brush') {
      session.shown.watch((shown, previous) => {
        if (shown?.opened === previous?.opened) return;
        button.disabled = Boolean(shown?.opened.interior);
        attribute(button, 'title', button.disabled ? NO_GROUND : tip);
      });
    }
    return button;
  };
  const tools = TOOLS.map(toolButton);
  const tip = withKey(t('Fill the surface, or cut it open'), KEYS.cut);
  const cutting = h('button', { class: 'tool', title: tip, onclick: cut }, icon(CUT), h('span', {}, t('Cut')));
  session.scene.subscribe(({ inside }) => cutting.setAttribute('aria-pressed', String(inside.cut !== 'none')));
  const groups = (open ? WORKSPACES : []).map((workspace) => {
    const own = (TOOLS_OF[workspace] ?? []).map(toolButton);
    const group = h('div', { class: 'tools-of', role: 'group' }, ...own, ...(workspace === 'inside' ? [cutting] : []));
    if (group.childElementCount === 0) return null;
    attribute(group, 'aria-label', t('Tools of the workspace'));
    group.classList.toggle('drawing', workspace === 'scene');
    const show = () => (group.hidden = workspace !== open?.value && workspace !== pinned.value);
    for (const each of [open, pinned]) each?.watch(show);
    return group;
  });
  const undo = plain(t('Undo'), withKey(t('Undo'), KEYS.undo), UNDO, () => scene.undo());
  const redo = plain(t('Redo'), withKey(t('Redo'), KEYS.redo), REDO, () => scene.redo());
  const showHistory = () => {
    undo.disabled = !scene.canUndo;
    redo.disabled = !scene.canRedo;
  };
  scene.subscribe(showHistory);
  showHistory();

  const pause = plain(t('Pause'), '', PAUSE, () => {
    paused.value = !paused.value;
  });
  paused.watch((value) => {
    const name = value ? t('Resume') : t('Pause');
    attribute(pause, 'title', withKey(name, KEYS.pause));
    attribute(pause, 'aria-label', name);
    pause.replaceChildren(icon(value ? PLAY : PAUSE));
  });
  const frame = plain(t('Frame'), withKey(t('Frame the model'), KEYS.fit), FRAME, () => view.frame());
  const views = plain(t('Views'), t('Front, side, top, full screen'), VIEWS, () => stage.menu(views));
  const turn = plain(t('Turntable'), withKey(t('Rotate the model'), KEYS.turntable), TURN, () => {
    session.turntable.value = !session.turntable.value;
  });
  turn.classList.add('turn');
  session.turntable.watch((on) => turn.setAttribute('aria-pressed', String(on)));
  return h(
    'div',
    { class: 'toolbar', role: 'toolbar', 'aria-label': t('Tools') },
    ...tools,
    ...groups,
    rule(),
    undo,
    redo,
    rule(),
    pause,
    turn,
    frame,
    views,
  );
}

function rule(): HTMLElement {
  return h('hr', { 'aria-orientation': 'vertical' });
}

function plain(name: Words, tip: Words, path: string, run: () => void): HTMLButtonElement {
  return h('button', { class: 'tool', 'aria-label': name, title: tip, onclick: run }, icon(path));
}
