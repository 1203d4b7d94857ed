import type { OpeningStage } from '../../protocol';
import type { Session } from '../../session/session';
import { h, say } from '../dom';
import { bytes, percent, verticesWords } from '../words';
import { listed, t, type Words } from '../../texts';

/** What is going on, by the names that workers tell. */
const STAGES: Readonly<Record<OpeningStage, Words>> = {
  Fetching: t('fetching'),
  Reading: t('reading'),
  Simplifying: t('simplifying'),
  Filling: t('filling'),
  Welding: t('welding'),
  Drawing: t('drawing'),
  Propagating: t('propagating'),
  Marching: t('marching'),
  Assembling: t('assembling'),
  Ordering: t('ordering'),
  Analysing: t('analysing'),
  Factoring: t('factoring'),
};

/** Progress bar over the window: the stage, its progress, and Cancel. */
export function loadingBar(session: Session): HTMLElement {
  const bar = h('progress', { max: 1, 'aria-label': t('Opening') });
  const stage = h('span', { class: 'loading-stage', role: 'status' });
  const cancel = h(
    'button',
    { class: 'small', title: t('Stop opening (Esc)'), onclick: () => session.cancelOpening() },
    t('Cancel'),
  );
  const element = h('div', { class: 'loading', hidden: true }, bar, h('div', { class: 'loading-text' }, stage, cancel));
  session.loading.watch((loading) => {
    element.hidden = loading === null;
    if (!loading) {
      say(stage, '');
      return;
    }
    const { title, fraction, vertices, bytes: fetched } = loading;
    if (fraction === null) bar.removeAttribute('value');
    else bar.value = fraction;
    const reached = listed(
      STAGES[loading.stage],
      vertices > 0 ? verticesWords(vertices) : null,
      fetched === undefined ? null : bytes(fetched),
      fraction === null ? null : percent(fraction),
    );
    say(stage, t`${title}: ${reached}`);
  });
  return element;
}
