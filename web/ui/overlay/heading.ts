import type { Session } from '../../session/session';
import { titleOf } from '../../state/presets';
import { h, say } from '../dom';
import { exactnessWords, sizeWords } from '../words';
import { t } from '../../texts';

/** Top left: the name, the scene's title, the size of the mesh and how much of the distance is exact; and help. */
export function heading(session: Session, help: () => void): HTMLElement {
  const title = h('span', { class: 'title' });
  const size = h('span', { class: 'quiet size' });
  const exactness = h('span', { class: 'quiet exactness' });
  const tell = () => {
    const preview = session.preview.value;
    const shown = session.shown.value;
    const opened = (preview ?? shown)?.opened;
    const field = preview ? null : shown?.answer.field;
    say(title, preview?.title ?? titleOf(session.scene.state.mesh));
    say(size, opened ? sizeWords(opened) : '');
    say(exactness, field ? exactnessWords(field) : '');
  };
  session.shown.watch(tell);
  session.preview.watch(tell);
  session.scene.subscribe((state, previous) => {
    if (state.mesh !== previous.mesh) tell();
  });
  const ask = h(
    'button',
    { class: 'small', title: t('Keys, gestures, documents (?)'), 'aria-label': t('Help'), onclick: help },
    '?',
  );
  return h('header', { class: 'heading' }, h('h1', {}, 'Heatwalk'), title, size, exactness, ask);
}
