/** Finds commands, settings, presets and styles by what is typed. Fetched when it is asked for first. */
import '../../style/search.css';
import type { Opener } from '../../session/opener';
import { PRESETS } from '../../state/presets';
import { attribute, h, say } from '../dom';
import type { Command } from '../commands';
import { KEYS, keyName } from '../keys';
import { explanationOf } from '../help/settings';
import type { Panel } from '../panel/panel';
import { type Entry, found } from './found';
import { t, type Words } from '../../texts';

interface Item extends Entry {
  run: () => void;
}

/** What is seen of many answers at once. */
const MOST_SHOWN = 60;
/** What commands are called elsewhere, by their keys. */
const OTHER_WORDS: Readonly<Record<string, Words>> = {
  [KEYS.measure]: t('tape, ruler, length'),
  [KEYS.help]: t('language, shortcuts, about, privacy'),
  [KEYS.open]: t('import, load, drop'),
  [KEYS.fit]: t('zoom, center, reset the view'),
};
/** What a panel's controls are called and are reached by. */
const CONTROLS = '.field, button:not([role=tab]):not(.card), summary';

/** Opens the search. `panel`: null where there is none; `ahead` gives the keys that were typed until now. */
export async function openSearch(
  commands: readonly Command[],
  opener: Opener,
  panel: Panel | null,
  ahead: () => readonly string[],
): Promise<void> {
  await panel?.load();
  if (document.querySelector('dialog.search[open]')) return;
  const items = [...commandItems(commands), ...presetItems(opener), ...(panel ? settingItems(panel) : [])];
  const list = h('ul', { role: 'listbox', id: 'search-list', 'aria-label': t('Found') });
  const none = h('p', { class: 'quiet', role: 'status' });
  let shown: Item[] = [];
  let at = 0;
  const field = h('input', {
    type: 'text',
    role: 'combobox',
    'aria-expanded': 'true',
    'aria-controls': 'search-list',
    'aria-label': t('Search settings and commands'),
    placeholder: t('Search settings and commands'),
    autocomplete: 'off',
    oninput: () => show(),
  });
  const choose = (index: number) => {
    const item = shown[index];
    dialog.close();
    item?.run();
  };
  const mark = (index: number) => {
    at = shown.length === 0 ? 0 : (index + shown.length) % shown.length;
    [...list.children].forEach((row, i) => row.setAttribute('aria-selected', String(i === at)));
    const row = list.children[at];
    attribute(field, 'aria-activedescendant', row?.id ?? '');
    row?.scrollIntoView({ block: 'nearest' });
  };
  const show = () => {
    shown = found(items, field.value).slice(0, MOST_SHOWN);
    list.replaceChildren(
      ...shown.map(({ name, place }, index) =>
        h(
          'li',
          { role: 'option', id: `found-${index}`, onclick: () => choose(index) },
          h('span', {}, name),
          h('span', { class: 'quiet' }, place),
        ),
      ),
    );
    say(none, shown.length === 0 ? t('Nothing has these words.') : null);
    mark(0);
  };
  const close = h(
    'button',
    { class: 'small', 'aria-label': t('Close the search'), onclick: () => dialog.close() },
    '×',
  );
  const dialog = h(
    'dialog',
    { class: 'search', 'aria-label': t('Search') },
    h('div', { class: 'search-head' }, field, close),
    none,
    list,
  );
  /** Whether a key is none that the field takes by itself. */
  const press = (key: string): boolean => {
    if (key === 'ArrowDown') mark(at + 1);
    else if (key === 'ArrowUp') mark(at - 1);
    else if (key === 'Enter') choose(at);
    else return false;
    return true;
  };
  field.addEventListener('keydown', (event) => {
    if (press(event.key)) event.preventDefault();
  });
  dialog.addEventListener('close', () => dialog.remove());
  dialog.addEventListener('click', ({ target }) => {
    // The ground behind it belongs to the dialog.
    if (target === dialog) dialog.close();
  });
  show();
  document.body.append(dialog);
  dialog.showModal();
  field.focus();
  for (const key of ahead()) {
    if (!dialog.open) return;
    if (press(key)) continue;
    if (key === 'Escape') return dialog.close();
    if (key === 'Backspace') field.value = field.value.slice(0, -1);
    else if (key.length === 1) field.value += key;
    show();
  }
}

function commandItems(commands: readonly Command[]): Item[] {
  return commands.map(({ name, keys, run }) => ({
    name: String(name),
    place: keys[0] ? String(keyName(keys[0])) : '',
    line: String(OTHER_WORDS[keys[0] ?? ''] ?? ''),
    run: () => run({}),
  }));
}

function presetItems(opener: Opener): Item[] {
  return PRESETS.map(({ id, title, credit }) => ({
    name: String(title),
    place: String(t('Preset')),
    line: String(credit),
    run: () => void opener.preset(id),
  }));
}

/** Settings, buttons and headings of the panel, to which the search leads; what only saves or copies is done at once. */
function settingItems(panel: Panel): Item[] {
  const items = [...panel.element.querySelectorAll<HTMLElement>(CONTROLS)].flatMap((control) => {
    if (control.closest('[hidden]:not([id^=workspace-])')) return [];
    const section = control.closest<HTMLElement>('details[id^="section-"]');
    const name = nameOf(control);
    if (!section || name === '') return [];
    const input = control.matches('.field') ? control.querySelector<HTMLElement>('input, select, button') : control;
    if (!input) return [];
    const choices = [...input.querySelectorAll('option')].map((option) => option.text);
    const saves = 'doneBySearch' in input.dataset ? t('download, export') : '';
    const line = [explanationOf(section.id.replace('section-', ''), name)?.line, control.title, ...choices, saves];
    const run = () => {
      panel.reveal(input);
      if ('doneBySearch' in input.dataset) input.click();
    };
    return [{ name, place: placeOf(section, name), line: line.map((each) => String(each ?? '')).join(' '), run }];
  });
  // A heading may have the name of its first button.
  return [...new Map(items.map((item) => [`${item.place} › ${item.name}`, item])).values()];
}

function nameOf(control: HTMLElement): string {
  if (control.matches('.field')) return control.querySelector('span')?.textContent.trim() ?? '';
  const text = control.getAttribute('aria-label') ?? control.textContent.trim();
  return /\p{L}/u.test(text) ? text : '';
}

/** "Look › Style": where a setting is, without a heading that says the same. */
function placeOf(section: HTMLElement, name: string): string {
  const sheet = section.closest<HTMLElement>('[id^=workspace-]');
  const tab = sheet && document.getElementById(sheet.getAttribute('aria-labelledby') ?? '');
  const heading = section.querySelector('summary')?.textContent.trim() ?? '';
  const path = [tab?.textContent.trim() ?? '', heading === name ? '' : heading].filter((each) => each !== '');
  return [...new Set(path)].join(' › ');
}
