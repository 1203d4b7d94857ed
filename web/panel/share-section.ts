import { canRecord, film, keep, png } from '../picture';
import type { Session } from '../session';
import { h, select, toggle } from './dom';

const SCALES = ['1', '2', '4'] as const;
/** Of a film: one turn of the turntable. */
const FILM_SECONDS = 8;

/** Copies the scene as a link, and saves it as a picture or a film. */
export function shareSection(session: Session, link: () => string): HTMLElement {
  return h(
    'div',
    { class: 'stack' },
    ...linkControls(link),
    ...pictureControls(session),
    ...(canRecord ? filmControls(session) : []),
  );
}

function linkControls(link: () => string): HTMLElement[] {
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
  return [
    h('button', { class: 'wide', title: 'Copy a link to exactly this scene', onclick: () => void copy() }, 'Copy link'),
    field,
    said,
    h('p', { class: 'quiet' }, 'The link holds the scene, not your file; whoever opens it is asked for the file.'),
  ];
}

function pictureControls(session: Session): HTMLElement[] {
  let scale: (typeof SCALES)[number] = '2';
  let background = true;
  const size = select(
    'Picture',
    SCALES.map((times) => [times, `${times} × the window`] as const),
    (value) => (scale = value),
  );
  size.show(scale);
  const behind = toggle('With background', (on) => (background = on));
  behind.show(background);
  const { button, run } = worker('Save picture', 'A PNG of what is shown');
  button.addEventListener('click', () =>
    run(session, async () => keep(await png(session.view, Number(scale), !background), `${nameOf(session)}.png`)),
  );
  return [size.element, behind.element, button];
}

function filmControls(session: Session): HTMLElement[] {
  const { view } = session;
  const { button, run } = worker('Save film', `A WebM of ${FILM_SECONDS} seconds: one turn around the model`);
  const record = async () => {
    view.spin = (2 * Math.PI) / FILM_SECONDS;
    try {
      keep(await film(view.canvas, FILM_SECONDS), `${nameOf(session)}.webm`);
    } finally {
      session.showTurntable();
    }
  };
  button.addEventListener('click', () => run(session, record));
  return [button];
}

/** A button that waits for its work and tells the page of a failure. */
function worker(name: string, title: string) {
  const button = h('button', { class: 'wide', title }, name);
  const run = (session: Session, work: () => Promise<void>) => {
    button.disabled = true;
    work()
      .catch((error: unknown) => {
        session.failure.value = error instanceof Error ? error : new Error(String(error));
      })
      .finally(() => {
        button.disabled = false;
      });
  };
  return { button, run };
}

function nameOf(session: Session): string {
  return (session.shown.value?.opened.name ?? 'heatwalk').replace(/\.\w+$/, '');
}
