/** What to do first: one hint after the other, each until the hand has done it. Who knows all of them sees none again. */
import type { Session } from '../../session/session';
import type { SceneState } from '../../state/scene';
import { h, say } from '../dom';
import { remember, remembered } from '../memory';
import { t, type Words } from '../../texts';

const MEMORY = 'heatwalk.hints';

interface Hint {
  mouse: Words;
  touch: Words;
  /** Whether the hand has just done it. */
  isDone: (state: SceneState, previous: SceneState, dragging: boolean) => boolean;
}

const HINTS: readonly Hint[] = [
  {
    mouse: t('Click the surface'),
    touch: t('Tap the surface'),
    isDone: (state, previous) => state.sources !== previous.sources,
  },
  {
    mouse: t('Drag the pin: the stripes follow'),
    touch: t('Drag the pin: the stripes follow'),
    isDone: (state, previous, dragging) => dragging && state.sources !== previous.sources,
  },
  {
    mouse: t('Alt + click sends the walker there'),
    touch: t('A long press sends the walker there'),
    isDone: (state, previous) => state.walker !== previous.walker && state.walker !== null,
  },
];

/** The hints, shown from `begin` on. */
export function hints(session: Session): { element: HTMLElement; begin: () => void } {
  const byTouch = matchMedia('(pointer: coarse)').matches;
  const text = h('span', { 'aria-live': 'polite' });
  const close = h(
    'button',
    { class: 'small', 'aria-label': t('Show no more hints'), onclick: () => turn(HINTS.length) },
    '×',
  );
  const element = h('div', { class: 'hint', hidden: true }, text, close);
  let known = Number(remembered(MEMORY) ?? 0);
  const show = () => {
    const hint = HINTS[known];
    element.hidden = hint === undefined;
    if (hint) say(text, byTouch ? hint.touch : hint.mouse);
  };
  const turn = (next: number) => {
    known = next;
    remember(MEMORY, String(known));
    show();
  };
  return {
    element,
    begin: () => {
      show();
      const end = session.scene.subscribe((state, previous) => {
        // Another mesh brings places of its own.
        if (state.mesh !== previous.mesh) return;
        // What the hand can do already needs no hint either.
        const done = HINTS.findLastIndex(({ isDone }) => isDone(state, previous, session.dragging));
        if (done >= known) turn(done + 1);
        if (known >= HINTS.length) end();
      });
    },
  };
}
