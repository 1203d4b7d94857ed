import type { Session } from '../../session/session';
import { titleOf } from '../../state/presets';
import { attribute, h, icon, say } from '../dom';
import { exactnessWords, sizeWords } from '../words';
import { t, type Words } from '../../texts';

const OPEN = 'M2.500 15.500v-11h5l1.500 2h8.500v2M2.500 15.500l3-7H18.500l-3 7z';
const SEARCH = 'M9 3.500a5.500 5.500 0 1 1 0 11 5.500 5.500 0 0 1 0-11zM13 13l4 4';
const SHARE = 'M10 12V3M6.500 6L10 2.500 13.500 6M4 10v7h12v-7';
const HELP = 'M7 7.500c0-4 6-4 6-.5 0 2.500-3 2.500-3 5M10 15.500v.1';

export interface HeadingCommands {
  /** Called once: the menu is there from then on. */
  open: (beside: HTMLButtonElement) => void;
  search: () => void;
  /** Null where there is no panel. */
  share: (() => void) | null;
  help: () => void;
}

/** Top left: the name, what opens a mesh, the scene's title, the size of the mesh and how much of the distance is exact; search, share, help. */
export function heading(session: Session, { open, search, share, help }: HeadingCommands): HTMLElement {
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
  const opener = button(t('Open'), t('Open a file, a folder, an address or a preset'), OPEN, () => {
    if (!opener.popoverTargetElement) open(opener);
  });
  attribute(opener, 'aria-haspopup', 'dialog');
  return h(
    'header',
    { class: 'heading' },
    h('h1', {}, 'Heatwalk'),
    opener,
    title,
    size,
    exactness,
    button(t('Search'), t`${t('Search settings and commands')} (${'ctrl + K'})`, SEARCH, search),
    share && button(t('Share'), t('Copy a link, save images, videos and data'), SHARE, share),
    button(t('Help'), t('Keys, gestures, documents (?)'), HELP, help),
  );
}

function button(name: Words, tip: Words, path: string, run: () => void): HTMLButtonElement {
  return h('button', { title: tip, 'aria-label': name, onclick: run }, icon(path));
}
