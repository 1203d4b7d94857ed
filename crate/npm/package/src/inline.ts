import { provide } from './parts.ts';
import { scriptOf } from './spawn.ts';
import reader from './reader.ts';
import solver from './solver.ts';

export * from './exports.ts';

/** The text of the worker. */
declare const WORKER: string;

provide({
  solver: async () => solver,
  reader: async () => reader,
  scripts: () => [scriptOf(WORKER)],
});
