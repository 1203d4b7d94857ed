/** Distances at places in faces and tetrahedra, of the field that is shown. */
import type { MeshPoint } from '../protocol';
import { type ModelLength, ofModel } from '../length';
import { isWeighted } from '../state/ground';
import type { Session } from './session';

/** Those of places; null where not all of the field is exact, and inside of tetrahedra. */
export async function exactDistances(
  { engine, shown }: Session,
  places: readonly MeshPoint[],
): Promise<readonly ModelLength[] | null> {
  if (!engine || shown.value?.answer.field?.exactBelow !== Infinity) return null;
  const distances = await engine.queries.exactDistances(places);
  return distances && Array.from(distances, (each) => ofModel(each));
}

/** That of one place, likewise. */
export async function exactDistanceAt(session: Session, place: MeshPoint): Promise<ModelLength | null> {
  const distances = await exactDistances(session, [place]);
  return distances?.[0] ?? null;
}

/**
 * What the path from a place costs where distances cannot be exact, for costs or inside of tetrahedra, and the field comes from the
 * same way of finding paths; null otherwise. It is the length of a path that exists, the field between vertices only a mean.
 */
export async function distanceAlongPath({ engine, shown }: Session, place: MeshPoint): Promise<ModelLength | null> {
  const answer = shown.value?.answer;
  if (!engine || !answer?.field || answer.field.timeFactor !== undefined || answer.pathKind === 'descent') return null;
  const { ground, sources } = answer.question;
  const isDirect = sources.every(({ offset = 0 }) => offset === 0);
  if (!isDirect || !(answer.field.inner || isWeighted(ground))) return null;
  const cost = await engine.queries.pathCost(place, answer.pathKind);
  return cost === null ? null : ofModel(cost);
}
