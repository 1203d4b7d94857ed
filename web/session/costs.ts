/** What is painted everywhere at once, in the place of what was: costs that files give, or the material of the brush. */
import { Failure } from '../error';
import type { Brush } from '../state/brush';
import { codesOfRows, codesOfVertices } from '../state/costs';
import { entry } from '../state/entry';
import { withFaces } from '../state/ground';
import { codeOfMaterial } from '../state/painting';
import type { Session } from './session';
import { t } from '../texts';

/** Paints what the rows of a CSV file say that triangles cost. Throws where a row is none. */
export function paintRows(session: Session, name: string, text: string): void {
  const opened = session.shown.value?.opened;
  if (opened?.interior) throw new Failure(t`${name} is for surfaces: inside of tetrahedra nothing is painted.`);
  repaint(session, codesOfRows(name, text, trianglesOf(session)));
}

/** Paints all of it with the material of a brush. */
export function paintAll(session: Session, brush: Brush): void {
  repaint(session, new Uint8Array(trianglesOf(session)).fill(codeOfMaterial(brush)));
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

function trianglesOf({ shown }: Session): number {
  return (shown.value?.opened.surface.triangles.length ?? 0) / 3;
}

function repaint({ scene }: Session, codes: Uint8Array): void {
  scene.edit({ ground: withFaces(scene.state.ground, codes) });
}
