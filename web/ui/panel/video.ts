/** Saves a video of one turn around the model, or of the walk. Loaded with the first of them. */
import { Failure } from '../../error';
import type { Frames } from '../../session/frames';
import type { Session } from '../../session/session';
import { save } from '../../view/picture';
import { FRAMES_A_SECOND, video } from '../../view/video';
import { measuring } from '../charts/measuring';
import { attribute, say } from '../dom';
import { fileNameOf, tenths } from '../words';
import { t } from '../../texts';

const TURN_SECONDS = 8;

/** A button that begins and cancels it, how far it is, and what came of it. */
export function videoMaker(session: Session, frames: Frames, subject: () => 'turn' | 'walk'): HTMLElement[] {
  const measure = async (signal: AbortSignal) => {
    progress.value = 0;
    const shows = subject() === 'turn' ? turned : walked;
    const { file, ending, seconds } = await frames.hold(() => shows(session, frames, signal, progress));
    save(file, `${fileNameOf(session.shown.value)}${ending}`);
    return t`Saved: ${tenths(seconds)} s, ${FRAMES_A_SECOND} frames a second.`;
  };
  const { button, progress, said } = measuring({
    label: t('Save video'),
    steps: t('Share of the video drawn'),
    measure,
    ended: () => undefined,
  });
  session.shown.watch((shown, previous) => {
    if (shown?.opened !== previous?.opened) say(said, '');
  });
  attribute(button, 'title', t('A video of one turn around the model, or of the walk'));
  return [button, progress, said];
}

type Show = (
  session: Session,
  frames: Frames,
  signal: AbortSignal,
  progress: HTMLProgressElement,
) => ReturnType<typeof video>;

/** The last frame is as far from the first as any two that follow each other. */
const turned: Show = async ({ view }, frames, signal, progress) => {
  const { camera } = view;
  if (!camera) throw new Failure(t('There is no scene to save as an image yet.'));
  const [yaw = 0, ...rest] = camera;
  const count = TURN_SECONDS * FRAMES_A_SECOND;
  const next = async (frame: number) => {
    progress.value = frame / count;
    if (frame >= count) return false;
    view.camera = [yaw + (2 * Math.PI * frame) / count, ...rest];
    await frames.advance(frame === 0 ? 0 : 1 / FRAMES_A_SECOND);
    return true;
  };
  try {
    return await video(view, next, signal);
  } finally {
    view.camera = camera;
  }
};

const walked: Show = async ({ view, walk }, frames, signal, progress) => {
  if (walk.length === 0) throw new Failure(t('There is no walker. Place one on the surface.'));
  void walk.perform();
  const next = async (frame: number) => {
    await frames.advance(frame === 0 ? 0 : 1 / FRAMES_A_SECOND);
    progress.value = walk.arc / walk.length;
    return walk.performs;
  };
  try {
    return await video(view, next, signal);
  } finally {
    walk.end();
  }
};
