/** What the hand can do on this device, and lines on the settings. Fetched when it is asked for first. */
import '../../style/help.css';
import type { Session } from '../../session/session';
import { h, sayAgain, select } from '../dom';
import { labelled, toggle } from '../widgets';
import { hasShortcuts, setShortcuts } from '../shortcuts';
import { byHand } from '../words';
import { about } from './about';
import { addressOf } from './documents';
import { explain } from './explain';
import { GESTURES } from './gestures';
import { choose, language, type Language, LANGUAGES, t, type Words } from '../../texts';

const EXPLAINED = 'explains';
const codes = Object.keys(LANGUAGES) as Language[];

/** Settings that arrive while settings are explained: those of a section that is fetched when it is expanded first. */
const arrivals = new MutationObserver((changes) => {
  for (const { target } of changes) {
    const panel = target instanceof Element ? target.closest<HTMLElement>('.panel') : null;
    if (panel) explain(panel);
  }
});

/** Opens the help. `panel`: whose settings can be explained; null where there is none. */
export function openHelp(session: Session, panel: HTMLElement | null, failed: (error: unknown) => void): void {
  let table = gestures();
  const spoken = () => {
    sayAgain();
    const former = table;
    // Its keys are cut out of words.
    former.replaceWith((table = gestures()));
  };
  const close = h('button', { class: 'small', 'aria-label': t('Close the help'), onclick: () => dialog.close() }, '×');
  const dialog = h(
    'dialog',
    { class: 'help', 'aria-label': t('Help') },
    h('div', { class: 'help-head' }, h('h2', {}, t('Help')), close),
    ...(panel ? [explaining(panel)] : []),
    languages(spoken, failed),
    table,
    ...shortcuts(),
    h(
      'p',
      {},
      h('a', { href: addressOf(''), target: '_blank', rel: 'noopener' }, t('All documents, with a search')),
      '.',
    ),
    ...about(session),
  );
  dialog.addEventListener('close', () => dialog.remove());
  dialog.addEventListener('click', ({ target }) => {
    // The ground behind it belongs to the dialog.
    if (target === dialog) dialog.close();
  });
  document.body.append(dialog);
  dialog.showModal();
}

/** With fingers first where there is no mouse; keys where there may be some. */
function gestures(): HTMLElement {
  const head = h(
    'tr',
    {},
    ...[t('Action'), byHand(t('Mouse'), t('Touch')), t('Keyboard')].map((text) => h('th', { scope: 'col' }, text)),
  );
  const rows = GESTURES.map(({ what, mouse, touch, keys }) =>
    h('tr', {}, h('th', { scope: 'row' }, what), h('td', {}, byHand(mouse, touch) ?? '–'), keyCell(keys)),
  );
  return h('table', {}, h('thead', {}, head), h('tbody', {}, ...rows));
}

function keyCell(keys: Words | null): HTMLElement {
  const cell = h('td');
  for (const each of keys === null ? [] : String(keys).split(' ')) {
    const together = each
      .split(/(?<=.)\+(?=.)/)
      .flatMap((key, i) => (i === 0 ? [h('kbd', {}, key)] : ['+', h('kbd', {}, key)]));
    cell.append(...together, ' ');
  }
  return cell;
}

/** `spoken`: the page has another language; `failed`: its texts cannot be loaded. */
function languages(spoken: () => void, failed: (error: unknown) => void): HTMLElement {
  const { element, show } = select(t('Language'), labelled(codes, LANGUAGES), (chosen) => {
    choose(chosen).then(spoken, (error: unknown) => {
      show(language);
      failed(error);
    });
  });
  show(language);
  return element;
}

function shortcuts(): HTMLElement[] {
  const { element, show } = toggle(t('Single-key shortcuts: letters, digits and signs'), setShortcuts);
  show(hasShortcuts());
  const words = t(
    'Arrows, Enter and Space act while the model has the focus, all other keys everywhere but in fields.',
  );
  return [element, h('p', { class: 'quiet' }, words)];
}

function explaining(panel: HTMLElement): HTMLElement {
  const page = document.documentElement;
  const { element, show } = toggle(t('Explain every setting of the panel'), (on) => {
    page.classList.toggle(EXPLAINED, on);
    arrivals.disconnect();
    if (!on) return;
    explain(panel);
    arrivals.observe(panel, { childList: true, subtree: true });
  });
  show(page.classList.contains(EXPLAINED));
  return element;
}
