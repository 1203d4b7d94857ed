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
  TracedWay,
  Way,
} from '../protocol';
import { CROWD_HEIGHT } from '../state/scene';
import { Cancelled, type SolverWorker, type WorkerLost } from './remote';

export interface Question {
  sources: readonly Source[];
  parameters: Parameters;
  /** Where to start the way home; null: no way is wanted. */
  from: SurfacePoint | null;
  /** The way that is wanted in the end. The exact one takes long, so a straightened one stands in for it at first. */
  way: PathKind;
  /** A field with a small near field will do. */
  quick: boolean;
}

export interface Answer extends TracedWay {
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

  /** An answer made better by one slice of refining. Null when a question is asked: that comes first. */
  refine(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const { question, pathKind } = answer;
      // The exact way does not depend on the field.
      const way = pathKind === 'exact' ? null : wayOf(question, pathKind);
      const { field, path, pathMs } = await this.#worker.call(this.#worker.api.refine(way));
      this.#held = { sources: question.sources, quick: false, field };
      return way ? { ...answer, field, path, pathMs } : { ...answer, field };
    });
  }

  /** An answer with the exact way home. Null when a question is asked: that comes first. */
  traceExactly(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const { path } = await this.#path(wayOf(answer.question, 'exact'));
      // The time of a way home is that of one traced while the hand moves.
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
    const pathKind = question.way === 'exact' ? 'straight' : question.way;
    const about = { question, pathKind, factoring: this.#factoring };
    if (sources.length === 0) return { ...about, field: null, path: null, pathMs: 0 };
    const way = wayOf(question, pathKind);
    const held = this.#held;
    // Another way home does not undo what refining has reached.
    if (held && held.sources === sources && (question.quick || !held.quick)) {
      return { ...about, field: held.field, ...(await this.#path(way)) };
    }
    this.#held = null;
    const solved: Solved = await this.#worker.call(api.solve([...sources], question.quick, way));
    this.#held = { sources, quick: question.quick, field: solved.field };
    return { ...about, ...solved };
  }

  async #path(way: Way | null): Promise<TracedWay> {
    return way ? this.#worker.call(this.#worker.api.path(way)) : { path: null, pathMs: 0 };
  }
}

function wayOf({ from }: Question, kind: PathKind): Way | null {
  return from && { from, kind };
}
