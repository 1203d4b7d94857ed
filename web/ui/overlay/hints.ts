/**
 * What to do first: one hint after the other, each until the hand has done it. Who knows all of them sees none again. Fetched after the
 * first picture.
 */
import type { Session } from '../../session/session';
import type { SceneState } from '../../state/scene';
import type { Signal } from '../../state/signal';
import type { Tool } from '../../state/tool';
import { h, say } from '../dom';
import { remember, remembered } from '../memory';
import { byHand } from '../words';
import { t, type Words } from '../../texts';

const MEMORY = 'heatwalk.hints';

interface Hint {
  mouse: Words;
  touch: Words;
  /** Whether there is what it is about. */
  isFor: (state: SceneState) => boolean;
  /** Whether the hand has just done it. */
  isDone: (state: SceneState, previous: SceneState, dragging: boolean) => boolean;
}

/** Also what is told again where there are no sources. */
const SET_SOURCE: Hint = {
  mouse: t('Click the surface'),
  touch: t('Tap the surface'),
  isFor: () => true,
  isDone: ({ sources }, previous) => sources.some((source) => !previous.sources.includes(source)),
};

const HINTS: readonly Hint[] = [
  SET_SOURCE,
  {
    mouse: t('Drag the pin: the stripes follow'),
    touch: t('Drag the pin: the stripes follow'),
    isFor: ({ sources }) => sources.length > 0,
    isDone: (state, previous, dragging) => dragging && state.sources !== previous.sources,
  },
  {
    mouse: t('Alt + click sends the walker there'),
    touch: t('A long press sends the walker there'),
    isFor: ({ sources, sets }) => sources.length + sets.length > 0,
    isDone: (state, previous) => state.walker !== previous.walker && state.walker !== null,
  },
];

/** Tools with which a click does what hints say. */
const TOOLS: ReadonlySet<Tool> = new Set(['source', 'add']);

/** Shows the hints in an element. `before`: the scene of the first picture, since which the hand may have done something. */
export function showHints(element: HTMLElement, session: Session, tool: Signal<Tool>, before: SceneState): void {
  const text = h('span', { 'aria-live': 'polite' });
  const close = h(
    'button',
    { class: 'small', 'aria-label': t('Show no more hints'), onclick: () => turn(HINTS.length) },
    '×',
  );
  element.append(text, close);
  let known = Number(remembered(MEMORY) ?? 0);
  const show = () => {
    const next = HINTS[known];
    element.hidden = next === undefined || !TOOLS.has(tool.value);
    if (!next) return;
    const hint = next.isFor(session.scene.state) ? next : SET_SOURCE;
    say(text, byHand(hint.mouse, hint.touch));
  };
  const turn = (next: number) => {
    known = next;
    remember(MEMORY, String(known));
    show();
  };
  const follow = (state: SceneState, previous: SceneState) => {
    // Another mesh brings places of its own.
    const isSame = state.mesh === previous.mesh;
    // What the hand can do already needs no hint either.
    const done = isSame ? HINTS.findLastIndex(({ isDone }) => isDone(state, previous, session.dragging)) : -1;
    if (done >= known) turn(done + 1);
    else show();
  };
  tool.watch(show);
  session.scene.subscribe(follow);
  follow(session.scene.state, before);
}
