import type { Frames } from '../../session/frames';
import type { Session } from '../../session/session';
import type { SceneState } from '../../state/scene';
import { fitLink } from '../../state/sets';
import { png, save } from '../../view/picture';
import { copy } from '../clipboard';
import { h, say, select } from '../dom';
import { labelled, toggle } from '../widgets';
import { fileNameOf } from '../words';
import { t, type Words } from '../../texts';

const SCALES = ['1', '2', '4'] as const;
/** What a video can show. */
const VIDEOS = ['turn', 'walk'] as const;
type Subject = (typeof VIDEOS)[number];
const VIDEO_WORDS: Record<Subject, Words> = { turn: t('Turntable'), walk: t('The walk') };

/** Copies the scene as a link, and saves it as an image or a video. */
export function shareSection(session: Session, link: () => string, frames: Frames): HTMLElement {
  return h(
    'div',
    { class: 'stack' },
    ...linkControls(session, link),
    ...sceneControls(session),
    ...imageControls(session),
    ...videoControls(session, frames),
  );
}

/** Of the frame; its host may change it. */
const FRAME = { width: 800, height: 600 };

/** Where who opens a link has the mesh from. */
const WHENCE = {
  preset: null,
  file: t('The link contains the scene but not your file. Whoever opens it is asked for the file.'),
  address: t('The link contains the scene and the address of the mesh, which is fetched from there.'),
} satisfies Record<SceneState['mesh']['kind'], Words | null>;

/** HTML that shows the scene in another page, without the panel. */
function frameOf(link: string): string {
  const address = `${link}&kiosk=1`.replaceAll('&', '&amp;').replaceAll('"', '&quot;');
  const allowed = 'fullscreen; clipboard-write';
  return `<iframe src="${address}" title="Heatwalk" width="${FRAME.width}" height="${FRAME.height}" style="border: 0; max-width: 100%" loading="lazy" allow="${allowed}"></iframe>`;
}

function linkControls({ scene }: Session, link: () => string): HTMLElement[] {
  const said = h('span', { class: 'quiet', role: 'status' });
  const field = h('input', {
    type: 'text',
    readonly: true,
    'aria-label': t('Link to this scene, or its frame'),
    hidden: true,
  });
  const give = async (text: string) => {
    field.hidden = await copy(text);
    if (field.hidden) {
      const isWhole = fitLink(scene.state.sets);
      say(
        said,
        isWhole ? t('Copied.') : t('Copied, without lists and curves of sources: they are too many for a link.'),
      );
      return;
    }
    field.value = text;
    field.select();
    say(said, t('The clipboard is not available. Copy it from the field.'));
  };
  const whence = h('p', { class: 'quiet' });
  const show = () => say(whence, WHENCE[scene.state.mesh.kind]);
  scene.subscribe(() => {
    show();
    // What was copied is of the scene before.
    say(said, null);
  });
  show();
  return [
    h(
      'button',
      {
        class: 'wide',
        title: t('Copy a link to this scene'),
        'data-done-by-search': true,
        onclick: () => void give(link()),
      },
      t('Copy link'),
    ),
    h(
      'button',
      {
        class: 'wide',
        title: t('Copy HTML that shows this scene in a frame of another page'),
        onclick: () => void give(frameOf(link())),
      },
      t('Copy frame'),
    ),
    field,
    said,
    whence,
  ];
}

function sceneControls(session: Session): HTMLElement[] {
  const { button, run } = worker(t('Save scene'), t('An archive of the scene and its mesh, to be opened here again'));
  const file = async () => {
    const { sceneFile } = await import('../../session/scene');
    save(await sceneFile(session), `${fileNameOf(session.shown.value)}.heatwalk.zip`);
  };
  button.addEventListener('click', () => run(session, file));
  const words = t('The file holds the scene and the mesh. Open it here as any mesh; all is then as it was.');
  return [button, h('p', { class: 'quiet' }, words)];
}

function imageControls(session: Session): HTMLElement[] {
  let scale: (typeof SCALES)[number] = '2';
  let background = true;
  const size = select(
    t('Image size'),
    SCALES.map((times) => [times, t`${times} × the window`] as const),
    (value) => (scale = value),
  );
  size.show(scale);
  const behind = toggle(t('Background'), (on) => (background = on));
  behind.show(background);
  const { button, run } = worker(t('Save image'), t('A PNG of the view'));
  button.addEventListener('click', () =>
    run(session, async () =>
      save(await png(session.view, Number(scale), !background, true), `${fileNameOf(session.shown.value)}.png`),
    ),
  );
  return [size.element, behind.element, button];
}

function videoControls(session: Session, frames: Frames): HTMLElement[] {
  if (!('VideoEncoder' in globalThis)) {
    return [h('p', { class: 'quiet' }, t('This browser cannot encode videos.'))];
  }
  let shows: Subject = 'turn';
  const subject = select(t('Video'), labelled(VIDEOS, VIDEO_WORDS), (value) => (shows = value));
  subject.show(shows);
  const { button, run } = worker(t('Save video'), t('A video of one turn around the model, or of the walk'));
  const made = h('div', { class: 'stack' }, button);
  button.addEventListener('click', () =>
    run(session, async () => {
      const { videoMaker } = await import('./video');
      made.replaceChildren(...videoMaker(session, frames, () => shows));
      const begin = made.querySelector('button');
      begin?.focus();
      begin?.click();
    }),
  );
  return [subject.element, made];
}

/** A button that is disabled while it works and reports a failure to the page. */
function worker(name: Words, title: Words) {
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
