/** What the period of stripes is a share of. */
import { hasCosts } from '../state/ground';
import { entry } from '../state/entry';
import { distance, vectorAt } from '../state/vector';
import type { Shown } from './prepare';

/** So many triangles tell what the surface costs. */
const SAMPLES = 1000;

/**
 * The diameter. With costs, that times the power of two nearest to the median of what a unit of length costs, so that stripes on most
 * of the surface are about as far apart as without costs, and seldom jump while these change. Few places that cost far more do not count.
 */
export function wholeOfDistance(shown: Shown): number {
  const { answer, places } = shown;
  const rate = hasCosts(answer.question.ground) ? medianRate(shown) : 1;
  return places.diameter * 2 ** Math.round(Math.log2(rate));
}

/** By how much the field grows with a unit of length, as the median over what is reached. */
function medianRate({ opened: { surface, drawTransform }, answer: { field } }: Shown): number {
  if (!field) return 1;
  const { positions, triangles } = surface;
  const step = 3 * Math.max(1, Math.floor(triangles.length / (3 * SAMPLES)));
  const rates: number[] = [];
  for (let first = 0; first + 2 < triangles.length; first += step) {
    const corners = [0, 1, 2].map((k) => {
      const vertex = entry(triangles, first + k);
      return { place: vectorAt(positions, vertex), value: entry(field.distance, field.byCorner ? first + k : vertex) };
    });
    const along = corners.map(({ place, value }, k) => {
      const next = entry(corners, (k + 1) % 3);
      return (Math.abs(next.value - value) / distance(place, next.place)) * drawTransform.scale;
    });
    const rate = Math.max(...along);
    if (rate > 0 && Number.isFinite(rate)) rates.push(rate);
  }
  return rates.length > 0
    ? entry(
        rates.toSorted((a, b) => a - b),
        rates.length >> 1,
      )
    : 1;
}
