import { PRESETS } from '../presets';
import type { Opener } from '../opener';
import { FORMATS } from '../opener';
import type { Session } from '../session';
import { count, counted } from '../words';
import { h } from './dom';

/** Address of each preset's picture by its path; `npm run gallery` draws them. */
const THUMBNAILS = import.meta.glob<string>('../thumbnails/*.webp', {
  eager: true,
  query: '?url&no-inline',
  import: 'default',
});

function thumbnail(id: string): HTMLElement | null {
  const address = THUMBNAILS[`../thumbnails/${id}.webp`];
  return address
    ? h('img', { src: address, alt: '', width: 84, height: 63, loading: 'lazy', draggable: 'false' })
    : null;
}

/** Gallery of presets, the file button, and which parts of a file are walked on. */
export function sceneSection(session: Session, opener: Opener, chooseFile: () => void): HTMLElement {
  const gallery = h('div', { class: 'gallery', role: 'group', 'aria-label': 'Presets' });
  const buttons = PRESETS.map((preset) => {
    const button = h(
      'button',
      { class: 'card', title: `${preset.title} — ${preset.credit}`, onclick: () => void opener.preset(preset.id) },
      thumbnail(preset.id),
      h('span', {}, preset.title),
    );
    gallery.append(button);
    return { button, id: preset.id };
  });
  const credit = h('p', { class: 'quiet' });
  const parts = h('fieldset', { class: 'parts', hidden: true });

  const showScene = () => {
    const { mesh } = session.scene.state;
    for (const { button, id } of buttons) {
      button.setAttribute('aria-pressed', String(mesh.kind === 'preset' && mesh.id === id));
    }
    const preset = mesh.kind === 'preset' ? PRESETS.find(({ id }) => id === mesh.id) : undefined;
    credit.textContent = preset ? `${preset.title}: ${preset.credit}` : '';
    credit.hidden = !preset;
  };
  session.scene.subscribe((state, previous) => {
    if (state.mesh !== previous.mesh) showScene();
  });
  showScene();

  session.shown.watch((shown, previous) => {
    if (!shown || shown.opened === previous?.opened) return;
    const { opened } = shown;
    parts.hidden = opened.parts.length < 2;
    parts.replaceChildren(
      h('legend', {}, `Parts walked on, ${opened.walked.length} of ${opened.parts.length}`),
      ...opened.parts.map((part, index) => {
        const box = h('input', {
          type: 'checkbox',
          checked: opened.walked.includes(index),
          onchange: () => {
            const walked = new Set(opened.walked);
            if (box.checked) walked.add(index);
            else walked.delete(index);
            box.checked = opened.walked.includes(index);
            void opener.parts([...walked].toSorted((a, b) => a - b));
          },
        });
        // The last part stays: there must be something to walk on.
        box.disabled = opened.walked.length === 1 && opened.walked[0] === index;
        const size = h('small', { title: counted(part.triangles, 'triangle') }, count(part.triangles));
        return h('label', { class: 'part' }, box, h('span', {}, part.name || `Part ${index + 1}`), size);
      }),
    );
  });

  return h(
    'div',
    { class: 'stack' },
    gallery,
    credit,
    h('button', { class: 'wide', title: `Open a file (O): ${FORMATS}`, onclick: chooseFile }, 'Open a file…'),
    parts,
  );
}
