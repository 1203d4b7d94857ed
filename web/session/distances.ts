/** Exact distances at places in faces, of the field that is shown. */
import type { MeshPoint } from '../protocol';
import type { Session } from './session';

/** Those of places, in the file's unit; null where not all of the field is exact, and inside of tetrahedra. */
export async function exactDistances(
  { engine, shown }: Session,
  places: readonly MeshPoint[],
): Promise<Float64Array | null> {
  return engine && shown.value?.answer.field?.exactBelow === Infinity ? engine.queries.exactDistances(places) : null;
}

/** That of one place, likewise. */
export async function exactDistanceAt(session: Session, place: MeshPoint): Promise<number | null> {
  const distances = await exactDistances(session, [place]);
  return distances?.[0] ?? null;
}
