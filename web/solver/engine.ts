/** Questions to an open mesh and their answers. */
import type {
  DistanceField,
  EdgeKind,
  FaceField,
  Factoring,
  OpenedMesh,
  Parameters,
  PathKind,
  Solved,
  Source,
  SurfacePoint,
  TracedPath,
  PathRequest,
} from '../protocol';
import { CROWD_HEIGHT } from '../state/scene';
import { Cancelled, type SolverWorker, type WorkerLost } from './remote';

export interface Question {
  sources: readonly Source[];
  parameters: Parameters;
  /** Start of the path; null: no path is wanted. */
  from: SurfacePoint | null;
  /** The kind of path that is wanted. The exact one takes long, so the straightened one is shown first. */
  pathKind: PathKind;
  /** A small exact region is enough. */
  quick: boolean;
}

export interface Answer extends TracedPath {
  question: Question;
  /** Null when there are no sources. */
  field: DistanceField | null;
  /** What `path` is. */
  pathKind: PathKind;
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
  #held: { sources: readonly Source[]; quick: boolean; field: DistanceField } | null = null;
  #busy = false;
  /** Ends with the refinement step or exact path that was asked for last. */
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

  /** Resolves when the worker is lost. */
  get lost(): Promise<WorkerLost> {
    return this.#worker.lost;
  }

  /** Latest wins: one question runs, one waits, and a waiting one that is overtaken answers null. */
  ask(question: Question): Promise<Answer | null> {
    this.#waiting?.resolve(null);
    return new Promise((resolve, reject) => {
      this.#waiting = { question, resolve, reject };
      if (!this.#busy) void this.#work();
    });
  }

  /** An answer improved by one step of refinement. Null when a query is waiting: that comes first. */
  refine(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const { question, pathKind } = answer;
      // The exact path does not depend on the field.
      const request = pathKind === 'exact' ? null : requestOf(question, pathKind);
      const { field, path, pathMs } = await this.#worker.call(this.#worker.api.refine(request));
      this.#held = { sources: question.sources, quick: false, field };
      return request ? { ...answer, field, path, pathMs } : { ...answer, field };
    });
  }

  /** An answer with the exact path. Null when a query is waiting: that comes first. */
  traceExactly(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const { path } = await this.#path(requestOf(answer.question, 'exact'));
      // The time of a path is that of one traced during a drag.
      return { ...answer, path, pathKind: 'exact' };
    });
  }

  gradients(kind: FaceField): Promise<Float32Array> {
    return this.#worker.call(this.#worker.api.gradients(kind));
  }

  heat(): Promise<Float32Array> {
    return this.#worker.call(this.#worker.api.heat());
  }

  crowd(count: number): Promise<void> {
    return this.#worker.call(this.#worker.api.crowd(count, CROWD_HEIGHT));
  }

  stepCrowd(step: number): Promise<Float32Array> {
    return this.#worker.call(this.#worker.api.stepCrowd(step));
  }

  edges(kind: EdgeKind): Promise<Float32Array> {
    return this.#worker.call(this.#worker.api.edges(kind));
  }

  errors(): Promise<Float32Array | null> {
    return this.#worker.call(this.#worker.api.errors());
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
    const pathKind = question.pathKind === 'exact' ? 'straight' : question.pathKind;
    const about = { question, pathKind, factoring: this.#factoring };
    if (sources.length === 0) return { ...about, field: null, path: null, pathMs: 0 };
    const request = requestOf(question, pathKind);
    const held = this.#held;
    // Another path does not undo what refinement has reached.
    if (held && held.sources === sources && (question.quick || !held.quick)) {
      return { ...about, field: held.field, ...(await this.#path(request)) };
    }
    this.#held = null;
    const solved: Solved = await this.#worker.call(api.solve([...sources], question.quick, request));
    this.#held = { sources, quick: question.quick, field: solved.field };
    return { ...about, ...solved };
  }

  async #path(request: PathRequest | null): Promise<TracedPath> {
    return request ? this.#worker.call(this.#worker.api.path(request)) : { path: null, pathMs: 0 };
  }
}

function requestOf({ from }: Question, kind: PathKind): PathRequest | null {
  return from && { from, kind };
}
