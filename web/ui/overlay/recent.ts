/** Files that were opened before and are kept in this browser, to be opened again or erased. */
import { fileName } from '../../files/paths';
import { eraseKept, type GivenInput, keepingTrouble, type KeptFile, keptFiles } from '../../session/kept';
import { sentenceOf } from '../../error';
import { h, say } from '../dom';
import { bytes } from '../words';
import { t } from '../../texts';

/** Below, the size in MiB would be 0. */
const LEAST_TOLD = 2 ** 20 / 10;

/** `show` reads them anew; the element is hidden where there are none, and nothing to tell of them. */
export function recentFiles(open: (input: GivenInput) => void): { element: HTMLElement; show: () => Promise<void> } {
  const list = h('ul');
  const trouble = h('p', { class: 'quiet', role: 'status' });
  const all = h('button', { class: 'link', onclick: () => void erase(null) }, t('Erase all'));
  const told = h('p', { class: 'quiet' }, t('Kept in this browser only.'), ' ', all);
  const element = h(
    'section',
    { class: 'recent', 'aria-label': t('Recent') },
    h('h2', {}, t('Recent')),
    list,
    told,
    trouble,
  );
  const erase = async (hash: string | null) => {
    try {
      await eraseKept(hash);
    } catch (error) {
      say(trouble, sentenceOf(error));
      return;
    }
    await show();
  };
  const row = ({ hash, bytes: size, input }: KeptFile) => {
    const name = fileName(input.mesh);
    return h(
      'li',
      {},
      h(
        'button',
        { title: t`Open ${name} again`, onclick: () => open(input) },
        h('span', {}, name),
        h('span', { class: 'quiet' }, size < LEAST_TOLD ? '' : bytes(size)),
      ),
      h(
        'button',
        { class: 'small', 'aria-label': t`Erase ${name}`, title: t`Erase ${name}`, onclick: () => void erase(hash) },
        '×',
      ),
    );
  };
  const show = async () => {
    const kept = await keptFiles();
    list.replaceChildren(...kept.map(row));
    told.hidden = kept.length === 0;
    say(trouble, keepingTrouble());
    element.hidden = kept.length === 0 && keepingTrouble() === null;
  };
  return { element, show };
}
