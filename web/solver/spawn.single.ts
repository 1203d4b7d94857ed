/** The same as spawn.ts where the page is one file: the worker is in it. */
// oxlint-disable-next-line import/default -- the bundler makes it
import EntryWorker from './worker/entry.ts?worker&inline';

export function spawn(): Worker {
  return new EntryWorker();
}
