import type { Session } from '../../session/session';
import { h } from '../dom';
import { counted, percent } from '../words';

/** Progress bar over the window: the stage, its progress, and Cancel. */
export function loadingBar(session: Session): HTMLElement {
  const bar = h('progress', { max: 1, 'aria-label': 'Opening' });
  const stage = h('span', { class: 'loading-stage', role: 'status' });
  const cancel = h(
    'button',
    { class: 'small', title: 'Stop opening (Esc)', onclick: () => session.cancelOpening() },
    'Cancel',
  );
  const element = h('div', { class: 'loading', hidden: true }, bar, h('div', { class: 'loading-text' }, stage, cancel));
  session.loading.watch((loading) => {
    element.hidden = loading === null;
    if (!loading) {
      stage.textContent = '';
      return;
    }
    const { title, fraction, vertices } = loading;
    bar.value = fraction;
    const size = vertices > 0 ? `, ${counted(vertices, 'vertex', 'vertices')}` : '';
    stage.textContent = `${title}: ${loading.stage.toLowerCase()}${size}, ${percent(fraction)}`;
  });
  return element;
}
