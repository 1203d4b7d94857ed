/** A worker of the solver, and the ways in which it can end. */
import { type Remote, wrap } from 'comlink';
import { Failure, toError } from '../error';
import { OUT_OF_MEMORY } from '../wasm/contract';
import { spawn } from './spawn';
import { isOutOfMemory, isTrap } from './trap';
import type { SolverApi } from './worker/entry';
import { t } from '../texts';

export class Cancelled extends Failure {
  constructor() {
    super(t('Cancelled.'));
  }
}

/** The worker is gone: out of memory, or a defect. Its mesh must be opened again in another one. */
export class WorkerLost extends Failure {}

const NOT_STARTED = t('The solver could not be started.');

/** The functions of an object, each called where `make` wants it. */
export function calling<T extends object>(object: T, make: <R>(call: () => Promise<R>) => Promise<R>): T {
  const called =
    (name: string | symbol) =>
    (...given: unknown[]) =>
      make(() => Reflect.get(object as object, name)(...given));
  return new Proxy({} as T, { get: (_, name) => called(name) });
}

/** One worker and the calls to it. */
export class SolverWorker {
  readonly #worker: Worker;
  readonly #ended = Promise.withResolvers<never>();
  /** Its calls; each ends with the worker. */
  readonly api: Remote<SolverApi>;
  /** Resolves when the worker is lost, whether or not a call was under way; not when it is ended on purpose. */
  readonly lost: Promise<WorkerLost>;

  /** `module`: the solver's, compiled. */
  constructor(module: Promise<WebAssembly.Module>) {
    this.#worker = spawn();
    this.api = calling(wrap<SolverApi>(this.#worker), (call) => this.during(call()));
    this.lost = new Promise((resolve) => {
      this.#ended.promise.catch((reason: unknown) => {
        if (reason instanceof WorkerLost) resolve(reason);
      });
    });
    this.#worker.addEventListener('error', (event) => {
      event.preventDefault();
      this.end(event.message ? stopped(event.message, event) : new WorkerLost(NOT_STARTED));
    });
    module
      .then((compiled) => this.api.start(compiled))
      .catch((error: unknown) => this.end(new WorkerLost(NOT_STARTED, { cause: error })));
  }

  /** Comlink never settles the calls of a terminated worker, so every call races against the worker's end. */
  async during<T>(answer: Promise<T>): Promise<T> {
    try {
      return await Promise.race([answer, this.#ended.promise]);
    } catch (error) {
      const wrapped = toError(error);
      if (!isTrap(wrapped)) throw wrapped;
      this.end(lostTo(wrapped));
      return this.#ended.promise;
    }
  }

  /** The first reason counts. */
  end(reason: Cancelled | WorkerLost): void {
    this.#worker.terminate();
    this.#ended.reject(reason);
  }
}

function lostTo(trap: Error): WorkerLost {
  if (!isOutOfMemory(trap)) return stopped(trap.message, trap);
  const error = new WorkerLost(
    t('The mesh needs more memory than the browser gives; use one with fewer triangles, or the native program.'),
    { cause: trap },
  );
  error.name = OUT_OF_MEMORY;
  return error;
}

function stopped(reason: string, cause: unknown): WorkerLost {
  return new WorkerLost(t`The solver stopped unexpectedly (${reason}).`, { cause });
}
