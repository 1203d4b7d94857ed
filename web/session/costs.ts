/** Costs that files give, painted in the place of what is painted. Fetched with the first of these. */
import { Failure } from '../error';
import { codesOfRows, codesOfVertices } from '../state/costs';
import { entry } from '../state/entry';
import { withFaces } from '../state/ground';
import type { Session } from './session';
import { t } from '../texts';

/** Paints what the rows of a CSV file say that triangles cost. Throws where a row is none. */
export function paintRows(session: Session, name: string, text: string): void {
  const opened = session.shown.value?.opened;
  if (opened?.interior) throw new Failure(t`${name} is for surfaces: inside of tetrahedra nothing is painted.`);
  repaint(session, codesOfRows(name, text, (opened?.surface.triangles.length ?? 0) / 3));
}

/** Paints what the file of the mesh says that vertices cost. */
export function paintWeights(session: Session): void {
  const opened = session.shown.value?.opened;
  if (!opened?.weights) return;
  const { surface, inputVertices, weights } = opened;
  const corners = surface.triangles.map((drawn) => entry(inputVertices, drawn));
  try {
    repaint(session, codesOfVertices(weights.name, weights.values, corners));
  } catch (error) {
    session.fail(error);
  }
}

function repaint({ scene }: Session, codes: Uint8Array): void {
  scene.edit({ ground: withFaces(scene.state.ground, codes) });
}
