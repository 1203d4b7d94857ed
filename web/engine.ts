/** Questions to an open mesh and their answers. */
import type {
  DistanceField,
  Factoring,
  OpenedMesh,
  Parameters,
  PathKind,
  Source,
  SurfacePath,
  SurfacePoint,
} from './protocol';
import { Cancelled, type SolverWorker, WorkerLost } from './solver-worker';

export interface Question {
  sources: readonly Source[];
  parameters: Parameters;
  /** Where to start the way home; null: no way is wanted. */
  from: SurfacePoint | null;
  /** The way that is wanted in the end. The exact one takes long, so a straightened one stands in for it at first. */
  way: PathKind;
}

export interface Answer {
  question: Question;
  /** Null when there are no sources. */
  field: DistanceField | null;
  path: SurfacePath | null;
  /** What `path` is. */
  pathKind: PathKind;
  pathMs: number;
  factoring: Factoring;
}

interface Waiting {
  question: Question;
  resolve: (answer: Answer | null) => void;
  reject: (error: unknown) => void;
}

/** One open mesh and the worker that holds its factors. */
export class Engine {
  readonly #worker: SolverWorker;
  #parameters: Parameters;
  #factoring: Factoring;
  /** The field that the worker holds, and of which sources. */
  #held: { sources: readonly Source[]; field: DistanceField } | null = null;
  #busy = false;
  /** Ends with the slice or exact way that was asked for last. */
  #bettering: Promise<void> = Promise.resolve();
  #waiting: Waiting | null = null;

  constructor(
    worker: SolverWorker,
    readonly opened: OpenedMesh,
    parameters: Parameters,
  ) {
    this.#worker = worker;
    this.#parameters = parameters;
    this.#factoring = opened;
  }

  /** Latest wins: one question runs, one waits, and a waiting one that is overtaken answers null. */
  ask(question: Question): Promise<Answer | null> {
    this.#waiting?.resolve(null);
    return new Promise((resolve, reject) => {
      this.#waiting = { question, resolve, reject };
      if (!this.#busy) void this.#work();
    });
  }

  /** An answer made better by one slice of refining. Null when a question is asked: that comes first. */
  refine(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const field = await this.#worker.call(this.#worker.api.refine());
      this.#held = { sources: answer.question.sources, field };
      // The exact way does not depend on the field.
      if (answer.pathKind === 'exact' || this.#waiting) return { ...answer, field };
      return { ...answer, field, ...(await this.#path(answer.question)) };
    });
  }

  /** An answer with the exact way home. Null when a question is asked: that comes first. */
  traceExactly(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const { path, pathKind } = await this.#path(answer.question, 'exact');
      // The time of a way home is that of one traced while the hand moves.
      return { ...answer, path, pathKind };
    });
  }

  gradients(kind: 'heat' | 'distance'): Promise<Float32Array> {
    return this.#worker.call(this.#worker.api.gradients(kind));
  }

  heat(): Promise<Float32Array> {
    return this.#worker.call(this.#worker.api.heat());
  }

  dispose(): void {
    this.#waiting?.resolve(null);
    this.#waiting = null;
    this.#worker.end(new Cancelled());
  }

  async #work(): Promise<void> {
    this.#busy = true;
    while (this.#waiting) {
      const { question, resolve, reject } = this.#waiting;
      this.#waiting = null;
      try {
        resolve(await this.#answer(question));
      } catch (error) {
        reject(error);
      }
    }
    this.#busy = false;
  }

  /** One at a time: a slice that nobody waits for any more may still be under way. */
  #better(answer: Answer, work: () => Promise<Answer>): Promise<Answer | null> {
    const better = this.#bettering.then(() => this.#betterNow(answer, work));
    this.#bettering = better.then(
      () => undefined,
      () => undefined,
    );
    return better;
  }

  async #betterNow(answer: Answer, work: () => Promise<Answer>): Promise<Answer | null> {
    if (this.#busy || this.#held?.sources !== answer.question.sources) return null;
    this.#busy = true;
    try {
      const better = await work();
      return this.#waiting ? null : better;
    } finally {
      void this.#work();
    }
  }

  async #answer(question: Question): Promise<Answer> {
    const { api } = this.#worker;
    const { parameters, sources } = question;
    if (parameters !== this.#parameters) {
      this.#factoring = await this.#worker.call(api.configure(parameters));
      this.#parameters = parameters;
      this.#held = null;
    }
    const factoring = this.#factoring;
    if (sources.length === 0)
      return { question, field: null, path: null, pathKind: question.way, pathMs: 0, factoring };
    // Another way home does not undo what refining has reached.
    if (this.#held?.sources !== sources) {
      this.#held = null;
      this.#held = { sources, field: await this.#worker.call(api.solve([...sources])) };
    }
    const { field } = this.#held;
    return { question, field, ...(await this.#path(question)), factoring };
  }

  /** No way home (the start is on a part that no source reaches) is not a failure of the question. */
  async #path(
    { from, way }: Question,
    kind: PathKind = way === 'exact' ? 'straight' : way,
  ): Promise<Pick<Answer, 'path' | 'pathKind' | 'pathMs'>> {
    if (!from) return { path: null, pathKind: kind, pathMs: 0 };
    const before = performance.now();
    let path: SurfacePath | null = null;
    try {
      path = await this.#worker.call(this.#worker.api.path(from, kind));
    } catch (error) {
      if (error instanceof WorkerLost || error instanceof Cancelled) throw error;
    }
    return { path, pathKind: kind, pathMs: performance.now() - before };
  }
}
