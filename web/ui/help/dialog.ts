/** What the hand can do on this device, and lines on the settings. Fetched when it is asked for first. */
import '../../style/help.css';
import { h, toggle } from '../dom';
import { explain } from './explain';
import { GESTURES } from './gestures';

const EXPLAINED = 'explains';

/** Opens the help. `panel`: whose settings can be explained; null where there is none. */
export function openHelp(panel: HTMLElement | null): void {
  const close = h('button', { class: 'small', 'aria-label': 'Close the help', onclick: () => dialog.close() }, '×');
  const dialog = h(
    'dialog',
    { class: 'help', 'aria-label': 'Help' },
    h('div', { class: 'help-head' }, h('h2', {}, 'Help'), close),
    ...(panel ? [explaining(panel)] : []),
    gestures(),
    h('p', {}, h('a', { href: './docs/', target: '_blank', rel: 'noopener' }, 'All documents, with a search'), '.'),
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
  const byTouch = matchMedia('(pointer: coarse)').matches;
  const head = h(
    'tr',
    {},
    ...['', byTouch ? 'Touch' : 'Mouse', 'Keyboard'].map((text) => h('th', { scope: 'col' }, text)),
  );
  const rows = GESTURES.map(({ what, mouse, touch, keys }) =>
    h('tr', {}, h('th', { scope: 'row' }, what), h('td', {}, (byTouch ? touch : mouse) ?? '–'), keyCell(keys)),
  );
  return h('table', {}, h('thead', {}, head), h('tbody', {}, ...rows));
}

function keyCell(keys: string | null): HTMLElement {
  const cell = h('td');
  for (const each of keys?.split(' ') ?? []) {
    const together = each
      .split(/(?<=.)\+(?=.)/)
      .flatMap((key, i) => (i === 0 ? [h('kbd', {}, key)] : ['+', h('kbd', {}, key)]));
    cell.append(...together, ' ');
  }
  return cell;
}

function explaining(panel: HTMLElement): HTMLElement {
  const body = document.documentElement;
  const { element, show } = toggle('Explain every setting of the panel', (on) => {
    if (on) explain(panel);
    body.classList.toggle(EXPLAINED, on);
  });
  show(body.classList.contains(EXPLAINED));
  return element;
}
