/** Distances at places in faces and tetrahedra, of the field that is shown. */
import { isUnsolved } from '../error';
import type { MeshPoint } from '../protocol';
import { type ModelLength, ofModel } from '../length';
import type { Session } from './session';

/** Null where the worker holds no field, as where the question that came last has failed. */
async function known<T>(asked: Promise<T>): Promise<T | null> {
  return asked.catch((error: unknown) => {
    if (isUnsolved(error)) return null;
    throw error;
  });
}

/** Those of places; null where not all of the field is exact, and inside of tetrahedra. */
export async function exactDistances(
  { engine, shown }: Session,
  places: readonly MeshPoint[],
): Promise<readonly ModelLength[] | null> {
  if (!engine || shown.value?.answer.field?.exactBelow !== Infinity) return null;
  const distances = await known(engine.queries.exactDistances(places));
  return distances && Array.from(distances, (each) => ofModel(each));
}

/** That of one place, likewise. */
export async function exactDistanceAt(session: Session, place: MeshPoint): Promise<ModelLength | null> {
  const distances = await exactDistances(session, [place]);
  return distances?.[0] ?? null;
}

/**
 * The best that is known at one place: exact where all of the field is. Where costs differ and inside of tetrahedra it is that along the
 * path from there, unless the field is by heat; else it is interpolated. Null without a field.
 */
export async function bestDistanceAt({ engine, shown }: Session, place: MeshPoint): Promise<ModelLength | null> {
  if (!engine || !shown.value?.answer.field) return null;
  const distance = await known(engine.queries.distanceAt(place));
  return distance === null ? null : ofModel(distance);
}
