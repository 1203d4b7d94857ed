import type { Session } from '../../session/session';
import { canRecord, film, keep, png } from '../../view/picture';
import { h, select, toggle } from '../dom';

const SCALES = ['1', '2', '4'] as const;
/** What a film can show. */
const FILMS = [
  ['turn', 'One turn'],
  ['walk', 'The walk home'],
] as const;
const TURN_SECONDS = 8;

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
  const { view, walk } = session;
  let shows: (typeof FILMS)[number][0] = 'turn';
  const subject = select('Film', FILMS, (value) => (shows = value));
  subject.show(shows);
  const { button, run } = worker('Save film', 'A WebM of one turn around the model, or of the walk home');
  const turn = async () => {
    view.spin = (2 * Math.PI) / TURN_SECONDS;
    try {
      return await film(view.canvas, new Promise((resolve) => setTimeout(resolve, 1000 * TURN_SECONDS)));
    } finally {
      session.showTurntable();
    }
  };
  const way = () => {
    if (walk.length === 0) throw new Error('Nobody walks here: give the walker a start first.');
    return film(view.canvas, walk.perform());
  };
  const record = async () => keep(await (shows === 'turn' ? turn() : way()), `${nameOf(session)}.webm`);
  button.addEventListener('click', () => run(session, record));
  return [subject.element, button];
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
