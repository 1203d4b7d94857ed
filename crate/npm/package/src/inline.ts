import { provide } from './parts.ts';
import reader from './reader.ts';
import solver from './solver.ts';
import { scriptOf } from './spawn.ts';
import text from './text.ts';

export * from './exports.ts';

provide({
  solver: async () => solver,
  reader: async () => reader,
  scripts: [async () => scriptOf(text)],
});
