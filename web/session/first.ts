/** The first source of a mesh for which nobody wishes one. */
import type { Source } from '../protocol';
import type { Answer } from '../solver/engine';
import type { Places } from '../state/places';
import { entry } from '../state/entry';
import type { Vector } from '../state/vector';

/** Where it lies: towards the eye of the view from which meshes are framed. */
const TOWARDS: Vector = [0.5, 0.4, 0.75];
/** Groups that are looked at: the largest of more is found where it is none of the smallest. */
const MOST_TRIES = 6;

/** A source in the largest of the groups between which no distance leads, by their areas, and what is answered to it, by the same array. */
export async function firstSource(
  places: Places,
  ask: (sources: readonly Source[]) => Promise<Answer>,
): Promise<{ sources: readonly Source[]; answer: Answer }> {
  const sources = [places.extreme(TOWARDS)];
  let best = { sources, answer: await ask(sources) };
  const { field } = best.answer;
  if (!field || field.byCorner || field.unreachableVertices === 0) return best;
  const areas = places.vertexAreas();
  const isSeen = new Uint8Array(areas.length);
  let [tried, most, rest] = [best, 0, areas.reduce((sum, area) => sum + area, 0)];
  for (let tries = 1; ; tries += 1) {
    let area = 0;
    tried.answer.field?.distance.forEach((value, drawn) => {
      if (isSeen[drawn] || value === Infinity) return;
      isSeen[drawn] = 1;
      area += entry(areas, drawn);
    });
    rest -= area;
    if (area > most) [best, most] = [tried, area];
    if (tries === MOST_TRIES || most >= rest) break;
    const next = [places.extreme(TOWARDS, isSeen)];
    tried = { sources: next, answer: await ask(next) };
  }
  // The solver holds what it answered last.
  return best === tried ? best : { ...best, answer: await ask(best.sources) };
}
