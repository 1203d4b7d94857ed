import { formats } from '../../files/paths';
import type { Opener } from '../../session/opener';
import type { Session } from '../../session/session';
import { PRESETS } from '../../state/presets';
import { isSameUnit, unitOf } from '../../length';
import { REPORT } from '../../state/report';
import { h, say } from '../dom';
import { KEYS, keyName } from '../keys';
import { simplifiedSentence } from '../words';
import { unitControls } from './units';
import { t, type Words } from '../../texts';

/** URL of each preset's thumbnail by its path; `npm run gallery` draws them. */
const THUMBNAILS = import.meta.glob<string>('../../thumbnails/*.webp', {
  eager: true,
  query: '?url&no-inline',
  import: 'default',
});

/** The thumbnail of a preset, if it has one; fetched after the first picture, of whose bytes all of them were a tenth. */
function thumbnail(id: string, drawn: Promise<void>): HTMLElement | null {
  const address = THUMBNAILS[`../../thumbnails/${id}.webp`];
  if (!address) return null;
  const image = h('img', { alt: '', width: 84, height: 63, loading: 'lazy', draggable: 'false' });
  void drawn.then(() => image.setAttribute('src', address));
  return image;
}

/** Whether the report measures the model of a preset. */
function inReport(id: string): boolean {
  return REPORT.some(({ model }) => 'preset' in model && model.preset === id);
}

/** Gallery of presets, the buttons for files and folders, the unit of lengths and the parts of the file. `drawn`: the first picture. */
export function sceneSection(
  session: Session,
  opener: Opener,
  chooseFile: () => void,
  chooseFolder: (() => void) | null,
  drawn: Promise<void>,
): HTMLElement {
  const cards = PRESETS.map((preset) => {
    const button = h(
      'button',
      { class: 'card', title: t`${preset.title} — ${preset.credit}`, onclick: () => void opener.preset(preset.id) },
      thumbnail(preset.id, drawn),
      h('span', {}, preset.title),
    );
    return { button, id: preset.id };
  });
  const group = (name: Words, isOfReport: boolean) =>
    h(
      'div',
      { role: 'group', 'aria-label': name },
      h('p', { class: 'quiet', 'aria-hidden': 'true' }, name),
      ...cards.filter(({ id }) => inReport(id) === isOfReport).map(({ button }) => button),
    );
  const gallery = h(
    'div',
    { class: 'gallery' },
    group(t('Presets'), false),
    group(t('Models of Table 1 of the report'), true),
  );
  const credit = h('p', { class: 'quiet' });

  const simplified = h('p', { class: 'quiet', hidden: true });
  const units = unitControls(session);
  const showSimplified = () => {
    const { scene, shown } = session;
    const opened = shown.value?.opened;
    say(simplified, opened ? simplifiedSentence(opened, unitOf(scene.state, opened)) : null);
    simplified.hidden = !simplified.textContent;
  };
  session.shown.watch(showSimplified);

  const showScene = () => {
    const { mesh } = session.scene.state;
    for (const { button, id } of cards) {
      button.setAttribute('aria-pressed', String(mesh.kind === 'preset' && mesh.id === id));
    }
    const preset = mesh.kind === 'preset' ? PRESETS.find(({ id }) => id === mesh.id) : undefined;
    say(credit, preset ? t`${preset.title}: ${preset.credit}` : '');
    credit.hidden = !preset;
  };
  session.scene.subscribe((state, previous) => {
    if (state.mesh !== previous.mesh) showScene();
    if (!isSameUnit(state, previous)) showSimplified();
  });
  showScene();
  const parts = h('div', { hidden: true });
  drawn
    .then(() => import('./parts'))
    .then(({ partsControl }) => parts.replaceWith(partsControl(session, opener)), session.fail.bind(session));

  return h(
    'div',
    { class: 'stack' },
    h(
      'div',
      { class: 'openers' },
      h(
        'button',
        { title: t`Open a file (${keyName(KEYS.open)}): ${formats()}`, onclick: chooseFile },
        t('Open a file…'),
      ),
      chooseFolder &&
        h('button', { title: t('Open the folder of a mesh'), onclick: chooseFolder }, t('Open a folder…')),
    ),
    gallery,
    credit,
    simplified,
    ...units,
    parts,
  );
}
