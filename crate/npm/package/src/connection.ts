import { HeatwalkError } from './errors.ts';
import { KEEP_AGENTS, type KeptAgents, type Opening, type Question, type Told } from './messages.ts';
import type { QueryOptions } from './options.ts';
import { modules } from './parts.ts';
import { type Port, spawn } from './spawn.ts';

interface Job {
  method: string;
  args: unknown[];
  agents: number | undefined;
  progress: QueryOptions['progress'];
  /** Whether it may end the worker other than by a failure of the agents themselves. */
  mayEnd: boolean;
  settle(error: unknown, value?: unknown): void;
}

/**
 * A mesh in a worker of its own, whose memory is given back with it. Questions are answered in turn. The worker is ended where one is aborted
 * or where it fails; the next question makes another, with the same mesh and
 * the same agents.
 */
export class Connection {
  readonly #opening: Opening;
  readonly #waiting: Job[] = [];
  #running: Job | undefined;
  #port: Port | undefined;
  #last = 0;
  #agents: readonly KeptAgents[] = [];
  /** Whether those of the worker are as they were kept. */
  #areAgentsKept = true;
  #isDisposed = false;

  constructor(opening: Opening) {
    this.#opening = opening;
  }

  /** The answer of a method of the module's mesh, or of agents on it. */
  ask(method: string, args: unknown[], { signal, progress }: QueryOptions = {}, agents?: number): Promise<unknown> {
    return new Promise((resolve, reject) => {
      if (this.#isDisposed) return reject(disposed());
      if (signal?.aborted) return reject(signal.reason);
      const abort = () => {
        this.#drop(job);
        job.settle(signal?.reason);
      };
      const job: Job = {
        method,
        args,
        agents,
        progress,
        mayEnd: agents === undefined || signal !== undefined,
        settle: (error, value) => {
          signal?.removeEventListener('abort', abort);
          if (error === undefined) resolve(value);
          else reject(error);
        },
      };
      signal?.addEventListener('abort', abort);
      this.#waiting.push(job);
      void this.#next();
    });
  }

  /** Ends the worker, and rejects what waits for it. */
  dispose() {
    this.#isDisposed = true;
    this.#end();
    const left = [this.#running, ...this.#waiting.splice(0)];
    this.#running = undefined;
    for (const job of left) job?.settle(disposed());
  }

  async #next() {
    if (this.#running) return;
    const isAtRisk = !this.#areAgentsKept && this.#waiting[0]?.mayEnd;
    const job = (this.#running = isAtRisk ? this.#keeping() : this.#waiting.shift());
    if (!job) return;
    const id = ++this.#last;
    const question: Question = { id, method: job.method, args: job.args, agents: job.agents };
    try {
      if (!this.#port) {
        question.opening = { modules: await modules('bytes' in this.#opening), mesh: this.#opening, agents: this.#agents };
        // It may have been aborted meanwhile.
        if (this.#running !== job) return;
        const port = await spawn(
          (told) => this.#hear(told),
          (reason) => this.#fail(reason),
        );
        if (this.#running !== job) return port.terminate();
        this.#port = port;
      }
      this.#port.post(question);
    } catch (error) {
      if (this.#running === job) this.#finish(error);
    }
  }

  #hear(told: Told) {
    const job = this.#running;
    if (!job || told.id !== this.#last) return;
    if ('fraction' in told) return job.progress?.(told.fraction, told.stage);
    if ('value' in told) return this.#finish(undefined, told.value);
    if (told.isFatal) this.#end();
    this.#finish(new HeatwalkError(told.message, told.code));
  }

  #fail(reason: string) {
    this.#end();
    this.#finish(new HeatwalkError(`the worker of the mesh cannot run: ${reason}`, 'no-worker'));
  }

  #finish(error: unknown, value?: unknown) {
    const job = this.#running;
    this.#running = undefined;
    if (job?.agents !== undefined && this.#port) this.#areAgentsKept = false;
    job?.settle(error, value);
    void this.#next();
  }

  /** What keeps the agents on this side, before what may end the worker. */
  #keeping(): Job {
    const settle = (_error: unknown, agents: unknown) => {
      this.#agents = (agents ?? []) as KeptAgents[];
      this.#areAgentsKept = true;
    };
    return { method: KEEP_AGENTS, args: [], agents: undefined, progress: undefined, mayEnd: false, settle };
  }

  #drop(job: Job) {
    if (this.#running !== job) {
      const place = this.#waiting.indexOf(job);
      if (place >= 0) this.#waiting.splice(place, 1);
      return;
    }
    this.#end();
    this.#running = undefined;
    void this.#next();
  }

  #end() {
    this.#port?.terminate();
    this.#port = undefined;
    // What came after they were kept is lost, and so are they.
    if (!this.#areAgentsKept) this.#agents = [];
    this.#areAgentsKept = true;
  }
}

const disposed = () => new HeatwalkError('the mesh was disposed of; make another', 'disposed');
