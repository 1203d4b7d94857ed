/**
 * The client of the solver's workers. Every mesh gets a worker of its own: wasm memory never shrinks, so a fresh one is the
 * only way to give it back, and while a mesh is being opened the one before stays whole and in use. Cancelling an opening
 * terminates its worker and touches nothing else.
 */
import { proxy, type Remote, transfer, wrap } from 'comlink';
import type {
  DistanceField,
  MeshInput,
  OpenedMesh,
  Parameters,
  ProgressListener,
  SolverApi,
  SurfacePath,
  SurfacePoint,
  Timings,
} from './protocol';

export interface Question {
  sources: readonly SurfacePoint[];
  parameters: Parameters;
  /** Where to start the way home; null: no way is wanted. */
  from: SurfacePoint | null;
}

export interface Answer {
  question: Question;
  /** Null when there are no sources. */
  field: DistanceField | null;
  path: SurfacePath | null;
  pathMs: number;
  /** Present when the parameters changed and something was factored again. */
  timings: Timings | null;
}

export class Cancelled extends Error {
  constructor() {
    super('Cancelled.');
  }
}

/** The worker is gone: out of memory, or a defect. Nothing can be asked of this mesh until it is opened again. */
export class WorkerLost extends Error {}

class SolverWorker {
  readonly #worker: Worker;
  readonly #abort: (reason: Error) => void;
  readonly #aborted: Promise<never>;
  readonly api: Remote<SolverApi>;

  constructor() {
    this.#worker = new Worker(new URL('./solver.worker.ts', import.meta.url), { type: 'module' });
    this.api = wrap<SolverApi>(this.#worker);
    const { promise, reject } = Promise.withResolvers<never>();
    this.#abort = reject;
    this.#aborted = promise;
    // Nobody need be waiting when a worker ends.
    promise.catch(() => undefined);
    this.#worker.addEventListener('error', (event) => {
      event.preventDefault();
      this.end(new WorkerLost(event.message || 'The solver could not be started.'));
    });
  }

  /** Comlink never settles the calls of a terminated worker, so every call races against the worker's end. */
  async call<T>(answer: Promise<T>): Promise<T> {
    try {
      return await Promise.race([answer, this.#aborted]);
    } catch (error) {
      const wrapped = toError(error);
      if (isTrap(wrapped)) {
        this.end(wrapped);
        throw new WorkerLost(trapSentence(wrapped), { cause: error });
      }
      throw wrapped;
    }
  }

  end(reason: Error): void {
    this.#worker.terminate();
    this.#abort(reason);
  }
}

/** One open mesh and the worker that holds its factors. */
export class Engine {
  readonly #worker: SolverWorker;
  #parameters: Parameters;
  #busy = false;
  #waiting: { question: Question; settle: PromiseWithResolvers<Answer | null> } | null = null;

  constructor(
    worker: SolverWorker,
    readonly opened: OpenedMesh,
    parameters: Parameters,
  ) {
    this.#worker = worker;
    this.#parameters = parameters;
  }

  /** Latest wins: one question runs, one waits, and a waiting one that is overtaken answers null. */
  ask(question: Question): Promise<Answer | null> {
    this.#waiting?.settle.resolve(null);
    const settle = Promise.withResolvers<Answer | null>();
    this.#waiting = { question, settle };
    if (!this.#busy) void this.#work();
    return settle.promise;
  }

  dispose(): void {
    this.#waiting?.settle.resolve(null);
    this.#waiting = null;
    this.#worker.end(new Cancelled());
  }

  async #work(): Promise<void> {
    this.#busy = true;
    while (this.#waiting) {
      const { question, settle } = this.#waiting;
      this.#waiting = null;
      try {
        settle.resolve(await this.#answer(question));
      } catch (error) {
        settle.reject(error);
      }
    }
    this.#busy = false;
  }

  async #answer(question: Question): Promise<Answer> {
    const { api } = this.#worker;
    const { parameters } = question;
    let timings: Timings | null = null;
    if (parameters !== this.#parameters) {
      timings = await this.#worker.call(api.configure(parameters));
      this.#parameters = parameters;
    }
    if (question.sources.length === 0) return { question, field: null, path: null, pathMs: 0, timings };
    const field = await this.#worker.call(api.solve([...question.sources]));
    const before = performance.now();
    const path = question.from ? await this.#path(question.from) : null;
    return { question, field, path, pathMs: performance.now() - before, timings };
  }

  /** No way home (the start is on a part that no source reaches) is not a failure of the question. */
  async #path(from: SurfacePoint): Promise<SurfacePath | null> {
    try {
      return await this.#worker.call(this.#worker.api.path(from));
    } catch (error) {
      if (error instanceof WorkerLost || error instanceof Cancelled) throw error;
      return null;
    }
  }
}

export class SolverClient {
  #spare: SolverWorker | null = null;
  #opening: SolverWorker | null = null;

  /** `load` gives the input anew for each opening, because its buffers are handed over to the worker. */
  async open(
    load: () => Promise<MeshInput>,
    parts: readonly number[],
    parameters: Parameters,
    progress: ProgressListener,
  ): Promise<Engine> {
    this.cancel();
    const worker = this.#spare ?? new SolverWorker();
    this.#spare = null;
    this.#opening = worker;
    try {
      const input = await worker.call(load());
      const opening = worker.api.open(transfer(input, buffersOf(input)), [...parts], parameters, proxy(progress));
      const opened = await worker.call(opening);
      return new Engine(worker, opened, parameters);
    } catch (error) {
      worker.end(new Cancelled());
      throw error;
    } finally {
      if (this.#opening === worker) this.#opening = null;
    }
  }

  /** Ends the opening that is under way, if any; it rejects with `Cancelled`. */
  cancel(): void {
    this.#opening?.end(new Cancelled());
    this.#opening = null;
  }

  /** Starts the worker of the next mesh ahead of time; to be called when the page is idle. */
  warmUp(): void {
    this.#spare ??= new SolverWorker();
  }
}

function buffersOf(input: MeshInput): Transferable[] {
  switch (input.kind) {
    case 'files':
      return input.files.map(({ bytes }) => bytes.buffer);
    case 'arrays':
      return [input.positions.buffer, input.triangles.buffer];
    case 'shape':
      return [];
  }
}

function toError(thrown: unknown): Error {
  return thrown instanceof Error ? thrown : new Error(String(thrown));
}

/** A wasm module that trapped must not be called again. */
function isTrap(error: Error): boolean {
  return error.name === 'RuntimeError' || error instanceof RangeError;
}

function trapSentence(error: Error): string {
  return /memory|allocation/i.test(error.message)
    ? 'The mesh needs more memory than the browser gives; try one with fewer triangles.'
    : `The solver stopped unexpectedly (${error.message}).`;
}
