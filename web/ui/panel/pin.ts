/** A workspace that is pinned stays beside the one that is open, where the window has room for both. */
import '../../style/pin.css';
import { entry } from '../../state/entry';
import type { Signal } from '../../state/signal';
import { isWorkspace, type Workspace, WORKSPACES } from '../../state/workspace';
import { h, icon } from '../dom';
import { remember, remembered } from '../memory';
import { type Panel, PINNED, type WorkspaceContent } from './panel';
import { t } from '../../texts';

const PIN = 'M12 2.500l5.500 5.500-2 .5-3.500 3.500.5 3L11 16.500 3.500 9 5 7.500l3 .5 3.500-3.500zM7 13l-4 4';
/** So that more than half of the window is left for the model. */
const WIDE = matchMedia('(min-width: 1500px)');

/** `pinned`: what stays, where the window is wide. */
export function pinning(
  panel: Panel,
  contents: Record<Workspace, WorkspaceContent>,
  open: Signal<Workspace>,
  pinned: Signal<Workspace | null>,
): void {
  const { element, body, column, sheets } = panel;
  const before = remembered(PINNED);
  let wish = before !== null && isWorkspace(before) ? before : null;
  const beside = h('div', { class: 'panel-beside' });
  const choose = (name: Workspace) => {
    wish = wish === name ? null : name;
    remember(PINNED, wish ?? '');
    show();
    // What is pinned no longer may be gone, with its button.
    const left = sheets.findIndex((sheet) => !sheet.hidden);
    if (document.activeElement === document.body) entry(buttons, left).focus();
  };
  const buttons = WORKSPACES.map((name) =>
    h(
      'button',
      {
        class: 'pin-button',
        'aria-label': t`Pin ${contents[name].name}`,
        title: t('Keeps this workspace beside the next one'),
        onclick: () => choose(name),
      },
      icon(PIN),
    ),
  );
  const show = () => {
    pinned.value = WIDE.matches ? wish : null;
    const second = pinned.value === open.value ? null : pinned.value;
    WORKSPACES.forEach((name, index) => {
      const [sheet, button] = [entry(sheets, index), entry(buttons, index)];
      const isSecond = name === second;
      const place = isSecond ? beside : column;
      // Moving it once more would scroll it, and take the focus from it.
      if (sheet.parentElement !== place) place.prepend(sheet);
      // The tab is that of the open one.
      sheet.setAttribute('role', isSecond ? 'region' : 'tabpanel');
      sheet.hidden = !isSecond && name !== open.value;
      button.hidden = !WIDE.matches || (wish !== null && wish !== name);
      button.setAttribute('aria-pressed', String(wish === name));
    });
    element.toggleAttribute('data-two', second !== null);
    if (second === null) beside.remove();
    else if (!beside.isConnected) body.prepend(beside);
  };
  sheets.forEach((sheet, index) => sheet.prepend(entry(buttons, index)));
  open.watch((name, previous) => {
    show();
    if (name !== previous) column.scrollTop = 0;
  });
  WIDE.addEventListener('change', show);
}
