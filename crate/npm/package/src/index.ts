import { provide } from './parts.ts';
import { scriptOf } from './spawn.ts';

export * from './exports.ts';

/** The text of the worker, for what does not take its file along. */
declare const WORKER: string;

// Bundlers take the file along where it is named in this way.
const beside = new URL('./worker.js', import.meta.url);

provide({
  solver: async () => (await import('./solver.ts')).default,
  reader: async () => (await import('./reader.ts')).default,
  scripts: () => [beside, scriptOf(WORKER)],
});
