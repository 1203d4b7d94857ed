import { h } from './dom';

/** Copies the scene as a link. */
export function shareSection(link: () => string): HTMLElement {
  const said = h('span', { class: 'quiet', role: 'status' });
  const field = h('input', { type: 'text', readonly: true, 'aria-label': 'Link to this scene', hidden: true });
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(link());
      field.hidden = true;
      said.textContent = 'Copied.';
    } catch {
      // Without leave to use the clipboard the link is shown to be copied by hand.
      field.hidden = false;
      field.value = link();
      field.select();
      said.textContent = 'Copy it from the field.';
    }
  };
  return h(
    'div',
    { class: 'stack' },
    h('button', { class: 'wide', title: 'Copy a link to exactly this scene', onclick: () => void copy() }, 'Copy link'),
    field,
    said,
    h('p', { class: 'quiet' }, 'The link holds the scene, not your file; whoever opens it is asked for the file.'),
  );
}
