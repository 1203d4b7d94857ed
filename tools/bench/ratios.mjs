// Whether one of two is slower, from pairs that were measured one right after the other.

/** What counts as slower. */
export const LIMIT = 1.03;

/** How often the true median may lie beyond the interval, on either side. */
const TAIL = 0.025;

/**
 * Of ratios after / before: their median; the interval that holds the true median in 95 % of cases whatever the ratios'
 * distribution, by order statistics; and on which side of `LIMIT` it lies.
 */
export function judge(ratios) {
  const sorted = ratios.toSorted((a, b) => a - b);
  const beyond = ranksBeyond(sorted.length);
  const [low, high] = beyond < 0 ? [0, Infinity] : [sorted[beyond], sorted.at(-1 - beyond)];
  const ratio = median(sorted);
  const isCertain = high <= LIMIT || low > LIMIT;
  return {
    ratio,
    interval: [low, high],
    isCertain,
    verdict: (isCertain ? '' : 'maybe ') + (ratio > LIMIT ? 'slower' : 'same'),
  };
}

export function median(numbers) {
  const sorted = numbers.toSorted((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

/** The rank of the interval's first ratio; −1 where there are too few for an interval. */
function ranksBeyond(count) {
  let probability = 0.5 ** count;
  let sum = 0;
  for (let rank = 0; ; rank++) {
    sum += probability;
    if (sum > TAIL) return rank - 1;
    probability *= (count - rank) / (rank + 1);
  }
}
