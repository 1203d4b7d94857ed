/** A worker of the solver, and the ways in which it can end. */
import { type Remote, wrap } from 'comlink';
import { OUT_OF_MEMORY, type SolverApi } from '../protocol';
import { isOutOfMemory, isTrap } from './trap';

export class Cancelled extends Error {
  constructor() {
    super('Cancelled.');
  }
}

/** The worker is gone: out of memory, or a defect. Nothing can be asked of this mesh until it is opened again. */
export class WorkerLost extends Error {}

const NOT_STARTED = 'The solver could not be started.';

/** One worker and the calls to it. */
export class SolverWorker {
  readonly #worker: Worker;
  readonly #abort: (reason: Error) => void;
  readonly #aborted: Promise<never>;
  readonly api: Remote<SolverApi>;

  /** `module`: the solver's, compiled. */
  constructor(module: Promise<WebAssembly.Module>) {
    this.#worker = new Worker(new URL('./worker/entry.ts', import.meta.url), { type: 'module' });
    this.api = wrap<SolverApi>(this.#worker);
    const { promise, reject } = Promise.withResolvers<never>();
    this.#abort = reject;
    this.#aborted = promise;
    // Nobody need be waiting when a worker ends.
    promise.catch(() => undefined);
    this.#worker.addEventListener('error', (event) => {
      event.preventDefault();
      this.end(new WorkerLost(event.message || NOT_STARTED));
    });
    module
      .then((compiled) => this.api.start(compiled))
      .catch((error: unknown) => this.end(new WorkerLost(NOT_STARTED, { cause: error })));
  }

  /** Comlink never settles the calls of a terminated worker, so every call races against the worker's end. */
  async call<T>(answer: Promise<T>): Promise<T> {
    try {
      return await Promise.race([answer, this.#aborted]);
    } catch (error) {
      const wrapped = toError(error);
      if (isTrap(wrapped)) {
        this.end(wrapped);
        throw lost(wrapped);
      }
      throw wrapped;
    }
  }

  end(reason: Error): void {
    this.#worker.terminate();
    this.#abort(reason);
  }
}

function toError(thrown: unknown): Error {
  return thrown instanceof Error ? thrown : new Error(String(thrown));
}

function lost(trap: Error): WorkerLost {
  if (!isOutOfMemory(trap)) {
    return new WorkerLost(`The solver stopped unexpectedly (${trap.message}).`, { cause: trap });
  }
  const error = new WorkerLost(
    'The mesh needs more memory than the browser gives; use one with fewer triangles, or the native program.',
    { cause: trap },
  );
  error.name = OUT_OF_MEMORY;
  return error;
}
