import { provide } from './parts.ts';
import { scriptOf } from './spawn.ts';

export * from './exports.ts';

// Bundlers take the file along where it is named in this way.
const beside = new URL('./worker.js', import.meta.url);

provide({
  solver: async () => (await import('./solver.ts')).default,
  reader: async () => (await import('./reader.ts')).default,
  // The text is for what does not take the file along.
  scripts: [async () => beside, async () => scriptOf((await import('./text.ts')).default)],
});
