/** A worker with the solver, from a file of its own. */
export function spawn(): Worker {
  return new Worker(new URL('./worker/entry.ts', import.meta.url), { type: 'module' });
}
