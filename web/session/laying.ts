/** Lays further images on the surface. */
import { Failure } from '../error';
import { ofModel } from '../length';
import type { InputFile } from '../protocol';
import { MOST_DECALS } from '../state/decals';
import { keepImage } from './images';
import type { Session } from './session';
import { count, t } from '../texts';

/** The size of a new one as a share of the diameter. */
const SIZE = 0.12;

/**
 * Lays an image, by its name in a scene, on what is seen at a place of the window, or else in the middle of what is seen; where nothing
 * is there, where the walker is, or the first source.
 */
export function layImage(
  { view, scene, shown, decal }: Session,
  image: string,
  at: readonly [number, number] = view.centre,
): void {
  const { decals, walker, sources } = scene.state;
  if (!shown.value) return;
  if (shown.value.opened.interior) throw new Failure(t('Images are on surfaces alone.'));
  if (decals.length >= MOST_DECALS) throw new Failure(t`There can be up to ${count(MOST_DECALS)} images.`);
  const hit = view.pick(...at) ?? view.pick(...view.centre);
  const place = hit?.point ?? walker ?? sources[0] ?? { vertex: 0 };
  const size = ofModel(SIZE * shown.value.places.diameter);
  scene.edit({ decals: [...decals, { place, size, angle: 0, image }] });
  decal.value = decals.length;
}

/** The same with images of files. */
export async function layFiles(
  session: Session,
  files: readonly InputFile[],
  at?: readonly [number, number],
): Promise<void> {
  try {
    for (const { path, content } of files) layImage(session, await keepImage(content, path), at);
  } catch (error) {
    session.fail(error);
  }
}
