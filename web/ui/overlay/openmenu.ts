/** What opens a mesh: a file, a folder, an address, a preset, a file that was opened before. Fetched when it is asked for first. */
import '../../style/search.css';
import { addressIn } from '../../files/address';
import { formats } from '../../files/paths';
import type { Opener } from '../../session/opener';
import { KEYS, keyName } from '../keys';
import { placeMenu } from '../popover';
import { recentFiles } from './recent';
import { h, say } from '../dom';
import { t, type Words } from '../../texts';

export interface OpenMenuOptions {
  opener: Opener;
  chooseFile: () => void;
  /** Null where the browser opens no folders. */
  chooseFolder: (() => void) | null;
  /** Shows the presets; null where there is no panel. */
  presets: (() => void) | null;
}

/** Opens the menu below a button, which opens and closes it from then on. */
export function openMenu(
  beside: HTMLButtonElement,
  { opener, chooseFile, chooseFolder, presets }: OpenMenuOptions,
): void {
  // Asked for twice before it was here.
  if (beside.popoverTargetElement) return;
  const item = (name: Words, key: Words, tip: Words, run: () => void) =>
    h(
      'button',
      {
        title: tip,
        onclick: () => {
          menu.hidePopover();
          run();
        },
      },
      name,
      h('kbd', { class: 'quiet' }, key),
    );
  const said = h('p', { class: 'quiet', role: 'status' });
  const field = h('input', {
    type: 'text',
    inputmode: 'url',
    placeholder: 'https://',
    'aria-label': t('Address of a mesh or a .zip'),
  });
  const form = h('form', {}, field, h('button', { type: 'submit' }, t('Open')));
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const address = addressIn(field.value);
    if (!address) {
      say(said, t('This is no http or https address.'));
      return;
    }
    menu.hidePopover();
    void opener.address(address);
  });
  const recent = recentFiles((input) => {
    menu.hidePopover();
    void opener.again(input);
  });
  const menu = h(
    'div',
    { class: 'open-menu', popover: 'auto', role: 'dialog', 'aria-label': t('Open') },
    h(
      'div',
      {},
      item(t('Open a file…'), keyName(KEYS.open), t`Open a file (${keyName(KEYS.open)}): ${formats()}`, chooseFile),
      chooseFolder && item(t('Open a folder…'), '', t('Open the folder of a mesh'), chooseFolder),
      presets && item(t('Presets'), '', t('Show the presets'), presets),
      form,
      said,
      recent.element,
    ),
  );
  // Before it opens: the other event may come after an answer to what was typed.
  menu.addEventListener('beforetoggle', () => say(said, null));
  menu.addEventListener('toggle', (event) => {
    if ((event as ToggleEvent).newState !== 'open') return;
    placeMenu(menu, beside, 'below');
    void recent.show().then(() => placeMenu(menu, beside, 'below'));
  });
  document.body.append(menu);
  beside.popoverTargetElement = menu;
  menu.showPopover();
}
