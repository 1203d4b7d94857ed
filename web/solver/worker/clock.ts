/** How long things take, and how much of them a slice of time holds. */

/** A slice of searching lasts about this long. */
export const SLICE_MS = 150;
/** Windows of any slice at least. */
const LEAST_WORK = 2_000;

/** Windows of the next slice: one that was held up must not make the next ones tiny, nor a quick one the next endless. */
export function nextWork(work: number, passed: number, wanted: number): number {
  const change = Math.min(2, Math.max(0.5, wanted / Math.max(1, passed)));
  return Math.max(LEAST_WORK, Math.round(work * change));
}

/** Milliseconds since the last call. */
export function stopwatch(): () => number {
  let before = performance.now();
  return () => {
    const now = performance.now();
    const passed = now - before;
    before = now;
    return passed;
  };
}
