import type { Session } from '../../session/session';
import { h } from '../dom';
import { bytes, counted, percent } from '../words';

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
    const { title, fraction, vertices, bytes: fetched } = loading;
    if (fraction === null) bar.removeAttribute('value');
    else bar.value = fraction;
    const words = [loading.stage.toLowerCase()];
    if (vertices > 0) words.push(counted(vertices, 'vertex', 'vertices'));
    if (fetched !== undefined) words.push(bytes(fetched));
    if (fraction !== null) words.push(percent(fraction));
    stage.textContent = `${title}: ${words.join(', ')}`;
  });
  return element;
}
