import type { OpenedMesh } from '../../protocol';
import type { Opener } from '../../session/opener';
import type { Session } from '../../session/session';
import { attribute, h, say } from '../dom';
import { trianglesWords } from '../words';
import { count, t } from '../../texts';

interface Row {
  element: HTMLElement;
  show: (hidden: readonly number[]) => void;
}

/** Which parts of a file are active, and which of the others are shown. */
export function partsControl(session: Session, opener: Opener): HTMLElement {
  const { scene } = session;
  const list = h('fieldset', { class: 'parts', hidden: true });
  let rows: readonly Row[] = [];

  const fill = ({ parts, active }: OpenedMesh) => {
    const choose = (index: number, on: boolean) => {
      const others = active.filter((part) => part !== index);
      void opener.parts(on ? [...others, index].toSorted((a, b) => a - b) : others);
    };
    rows = parts.map(({ name, triangles }, index) => {
      const isActive = active.includes(index);
      const title = name || t`Part ${index + 1}`;
      const box = h('input', {
        type: 'checkbox',
        checked: isActive,
        // The last active part stays: a surface needs at least one.
        disabled: isActive && active.length === 1,
        onchange: () => {
          choose(index, box.checked);
          // The old choice stays until the new one is solved.
          box.checked = isActive;
        },
      });
      const size = h('small', { title: trianglesWords(triangles) }, count(triangles));
      const eye = isActive ? null : h('button', { onclick: () => toggle(index) });
      const show = (hidden: readonly number[]) => {
        if (!eye) return;
        const isHidden = hidden.includes(index);
        say(eye, isHidden ? t('Show') : t('Hide'));
        attribute(eye, 'aria-label', isHidden ? t`Show ${title}` : t`Hide ${title}`);
      };
      return { element: h('div', { class: 'part' }, h('label', {}, box, h('span', {}, title), size), eye), show };
    });
    list.hidden = parts.length < 2;
    list.replaceChildren(
      h('legend', {}, t`Active parts, ${active.length} of ${parts.length}`),
      ...rows.map(({ element }) => element),
    );
  };

  const showHidden = () => {
    for (const { show } of rows) show(scene.state.hidden);
  };
  const toggle = (index: number) => {
    const { hidden } = scene.state;
    const others = hidden.filter((part) => part !== index);
    scene.set({ hidden: hidden.includes(index) ? others : [...others, index].toSorted((a, b) => a - b) });
  };

  session.shown.watch((shown, previous) => {
    if (!shown || shown.opened === previous?.opened) return;
    fill(shown.opened);
    showHidden();
  });
  scene.subscribe((state, previous) => {
    if (state.hidden !== previous.hidden) showHidden();
  });
  return list;
}
