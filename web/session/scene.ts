/** The scene on screen as a file. */
import { Failure } from '../error';
import { packScene } from '../files/scene';
import { isOfFile } from '../state/decals';
import { encodeLink } from '../state/link';
import { encodeAllSets, fitLink } from '../state/sets';
import { startOf } from '../state/start';
import { filesOfImages } from './images';
import type { Session } from './session';
import { t } from '../texts';

/** An archive with all that a link says, also what is too much for one, and with the mesh. */
export async function sceneFile({ scene, request }: Session): Promise<Blob> {
  if (!request) throw new Failure(t('There is no scene yet. Open a mesh first.'));
  const { state } = scene;
  const link = encodeLink(state, startOf(state.mesh) ?? state);
  const whole = fitLink(state.sets) ? link : `${link}&sets=${encodeAllSets(state.sets)}`;
  const images = await filesOfImages(state.decals.map(({ image }) => image).filter(isOfFile));
  return packScene(whole, state.mesh.kind === 'preset' ? null : await request.load(), images);
}
