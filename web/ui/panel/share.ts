import type { Session } from '../../session/session';
import { fitLink } from '../../state/sets';
import { canRecord, png, save, video } from '../../view/picture';
import { h, select, toggle } from '../dom';

const SCALES = ['1', '2', '4'] as const;
/** What a video can show. */
const VIDEOS = [
  ['turn', 'Turntable'],
  ['walk', 'The walk'],
] as const;
const TURN_SECONDS = 8;

/** Copies the scene as a link, and saves it as an image or a video. */
export function shareSection(session: Session, link: () => string): HTMLElement {
  return h(
    'div',
    { class: 'stack' },
    ...linkControls(session, link),
    ...imageControls(session),
    ...(canRecord ? videoControls(session) : []),
  );
}

function linkControls({ scene }: Session, link: () => string): HTMLElement[] {
  const said = h('span', { class: 'quiet', role: 'status' });
  const field = h('input', { type: 'text', readonly: true, 'aria-label': 'Link to this scene', hidden: true });
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(link());
      field.hidden = true;
      said.textContent = fitLink(scene.state.sets)
        ? 'Copied.'
        : 'Copied, without lists and curves of sources: they are too many for a link.';
    } catch {
      // Without permission to use the clipboard the link is shown to be copied by hand.
      field.hidden = false;
      field.value = link();
      field.select();
      said.textContent = 'The clipboard is not available. Copy the link from the field.';
    }
  };
  return [
    h('button', { class: 'wide', title: 'Copy a link to this scene', onclick: () => void copy() }, 'Copy link'),
    field,
    said,
    h(
      'p',
      { class: 'quiet' },
      'The link contains the scene but not your file. Whoever opens it is asked for the file.',
    ),
  ];
}

function imageControls(session: Session): HTMLElement[] {
  let scale: (typeof SCALES)[number] = '2';
  let background = true;
  const size = select(
    'Image size',
    SCALES.map((times) => [times, `${times} × the window`] as const),
    (value) => (scale = value),
  );
  size.show(scale);
  const behind = toggle('Background', (on) => (background = on));
  behind.show(background);
  const { button, run } = worker('Save image', 'A PNG of the view');
  button.addEventListener('click', () =>
    run(session, async () => save(await png(session.view, Number(scale), !background), `${nameOf(session)}.png`)),
  );
  return [size.element, behind.element, button];
}

function videoControls(session: Session): HTMLElement[] {
  const { view, walk } = session;
  let shows: (typeof VIDEOS)[number][0] = 'turn';
  const subject = select('Video', VIDEOS, (value) => (shows = value));
  subject.show(shows);
  const { button, run } = worker('Save video', 'A WebM video of one turn around the model, or of the walk');
  const turn = async () => {
    view.spin = (2 * Math.PI) / TURN_SECONDS;
    try {
      return await video(view, new Promise((resolve) => setTimeout(resolve, 1000 * TURN_SECONDS)));
    } finally {
      session.showTurntable();
    }
  };
  const walkVideo = () => {
    if (walk.length === 0) throw new Error('There is no walker. Alt + click the surface to place one.');
    return video(view, walk.perform());
  };
  const record = async () => save(await (shows === 'turn' ? turn() : walkVideo()), `${nameOf(session)}.webm`);
  button.addEventListener('click', () => run(session, record));
  return [subject.element, button];
}

/** A button that is disabled while it works and reports a failure to the page. */
function worker(name: string, title: string) {
  const button = h('button', { class: 'wide', title }, name);
  const run = (session: Session, work: () => Promise<void>) => {
    button.disabled = true;
    work()
      .catch((error: unknown) => session.fail(error))
      .finally(() => {
        button.disabled = false;
      });
  };
  return { button, run };
}

function nameOf(session: Session): string {
  return (session.shown.value?.opened.name ?? 'heatwalk').replace(/\.\w+$/, '');
}
