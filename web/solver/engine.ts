/** Questions to an open mesh and their answers. */
import type { Remote } from 'comlink';
import type {
  DistanceField,
  Factoring,
  InnerView,
  Moment,
  OpenedMesh,
  Parameters,
  PathKind,
  Posed,
  Solved,
  Source,
  MeshPoint,
  TracedPath,
  PathRequest,
} from '../protocol';
import { type Bridge, mayBeJoined } from '../state/scene';
import { changeOf, type Ground, isWeighted, LEVEL } from '../state/ground';
import { innerCutOf, type Inside, WHOLE } from '../state/inside';
import { type Box, boxAround } from '../state/places';
import type { Windows } from '../state/settings';
import type { Method } from '../wasm/contract';
import { calling, Cancelled, type SolverWorker, type WorkerLost } from './remote';
import type { Queries, SolverApi } from './worker/entry';

export interface Question {
  sources: readonly Source[];
  method: Method;
  /** Of methods other than heat. */
  windows: Windows;
  /** Of the heat method. */
  parameters: Parameters;
  /** Which components are joined. */
  bridge: Bridge;
  /** How many links there are between groups that stay apart. */
  links: number;
  /** What it costs to walk where. */
  ground: Ground;
  /** In which pose distances are measured; null: in that of the file. */
  moment: Moment | null;
  /** How the inside of tetrahedra is looked into. */
  inside: Inside;
  /** Start of the path; null: no path is wanted. */
  from: MeshPoint | null;
  /** The kind of path that is wanted. The exact one takes long, so the straightened one is shown first. */
  pathKind: PathKind;
  /** A small exact region, or the values of vertices, is enough. */
  quick: boolean;
  /** Whether the field may be refined; else it is to be the method's own. */
  refines: boolean;
}

/** What a field depends on. */
type FieldQuestion = Pick<
  Question,
  'sources' | 'method' | 'windows' | 'parameters' | 'bridge' | 'links' | 'ground' | 'moment' | 'quick'
>;

/** What is traced first. Where costs differ, straightened paths bend, which takes longer than a frame of a drag has. */
function pathKindOf({ pathKind, quick }: Question, weighted: boolean): PathKind {
  if (weighted && quick) return 'descent';
  return pathKind === 'exact' ? 'straight' : pathKind;
}

/** A straightened path is the shortest one where all distances are exact. */
function named(answer: Answer): Answer {
  const { field, pathKind, question } = answer;
  const isExact = pathKind === 'straight' && field?.exactBelow === Infinity && !isWeighted(question.ground);
  return isExact && !field.inner ? { ...answer, pathKind: 'exact' } : answer;
}

/** Whether a question only moves the sources of another while the pointer drags: the worker is ready for it. */
function isMove(from: Question, to: Question): boolean {
  return (
    from.quick &&
    to.sources.length > 0 &&
    to.sources !== from.sources &&
    to.method === from.method &&
    to.pathKind === from.pathKind &&
    to.inside === from.inside &&
    isSameField({ ...from, sources: to.sources }, to)
  );
}

/** Windows that suffice while the pointer drags. */
const QUICK_WINDOWS: Windows = 1;
/** Windows that it takes where they are refracted, see `propagation::REFRACTED`. */
const REFRACTED_WINDOWS = 4;

/** Whether a field that answers one question does for another as well. */
export function isSameField(answered: FieldQuestion, asked: FieldQuestion): boolean {
  const isByHeat = asked.method === 'heat';
  return (
    answered.sources === asked.sources &&
    answered.bridge === asked.bridge &&
    isSameMoment(answered.moment, asked.moment) &&
    answered.links === asked.links &&
    answered.ground === asked.ground &&
    isByHeat === (answered.method === 'heat') &&
    (isByHeat ? answered.parameters === asked.parameters : answered.windows === asked.windows) &&
    (asked.quick || !answered.quick)
  );
}

/** Whether a field that answers one question, by now refined or not, does for another as well. */
export function isFieldOf(field: DistanceField | null, answered: FieldQuestion, asked: Question): boolean {
  const isRefined = (field?.refineMs ?? 0) > 0;
  return isSameField(answered, asked) && (asked.refines || !isRefined);
}

export function isSameMoment(one: Moment | null, other: Moment | null): boolean {
  return one?.clip === other?.clip && one?.seconds === other?.seconds;
}

export interface Answer extends TracedPath {
  question: Question;
  /** The mesh in the pose in which the field was measured, where the one before was measured in another one. */
  posed: Posed | null;
  /** Null when there are no sources. */
  field: DistanceField | null;
  /** What is seen of the inside; null for surfaces, and where nothing is. */
  inside: InnerView | null;
  /** What `path` is. */
  pathKind: PathKind;
  factoring: Factoring;
}

/** What is known of an answer before its field. */
type Known = Pick<Answer, 'question' | 'pathKind' | 'factoring' | 'inside'>;

interface Waiting {
  question: Question;
  resolve: (answer: Answer | null) => void;
  reject: (error: unknown) => void;
}

/** One open mesh and the worker that holds it. */
export class Engine {
  readonly #worker: SolverWorker;
  readonly #api: Remote<SolverApi>;
  /** What the mesh can be asked beside the field, at once. */
  readonly queries: Remote<Queries>;
  /** The same, asked when no question and no step of refinement is under way; these take turns with it. */
  readonly inTurn: Remote<Queries>;
  /** Whether it can be asked by the heat method. */
  readonly isFactored: boolean;
  #parameters: Parameters | null;
  /** The rule by which the worker has joined components; null: by none yet, and it knows no groups to link. */
  #bridge: Bridge | null = null;
  #links = 0;
  /** The pose in which they meet there; null: that of the file. */
  #joinedAt: Moment | null = null;
  #ground = LEVEL;
  #inside = WHOLE;
  #view: InnerView | null = null;
  #box: Box | null = null;
  /** The pose that the worker shows, and that in which it measures. */
  #shown: Moment | null = null;
  #measured: Moment | null = null;
  #factoring: Factoring;
  /** The field that the worker holds, and what it was asked for. */
  #held: { question: Question; field: DistanceField } | null = null;
  #busy = false;
  /** The field that the worker was asked for last, while it is under way. */
  #solving: Question | null = null;
  /** Ends with the last question that was asked while the one before was under way. */
  #moving: Promise<void> = Promise.resolve();
  /** Ends with the refinement step or exact path that was asked for last. */
  #bettering: Promise<void> = Promise.resolve();
  #waiting: Waiting | null = null;
  /** Ends when no question is left. */
  #working: Promise<void> = Promise.resolve();

  /** `parameters`: what is factored; null where nothing is. */
  constructor(
    worker: SolverWorker,
    readonly opened: OpenedMesh,
    factoring: Factoring,
    parameters: Parameters | null,
  ) {
    this.#worker = worker;
    this.#api = worker.api;
    this.queries = worker.api;
    this.inTurn = calling(this.queries, (call) => this.#between(call));
    this.isFactored = parameters !== null;
    this.#parameters = parameters;
    this.#factoring = factoring;
  }

  /** The box around the mesh as it is drawn. */
  get box(): Box {
    this.#box ??= boxAround(this.opened.surface.positions);
    return this.#box;
  }

  /** Resolves when the worker is lost. */
  get lost(): Promise<WorkerLost> {
    return this.#worker.lost;
  }

  /**
   * Latest wins: one question runs, one waits, and a waiting one that is overtaken answers null. Moves of a drag wait at the
   * worker, which begins the last of them as soon as it is free.
   */
  ask(question: Question): Promise<Answer | null> {
    this.#waiting?.resolve(null);
    this.#waiting = null;
    if (this.#solving && isMove(this.#solving, question)) {
      const answered = this.#solve(question).then((found) => found && { ...found, posed: null });
      this.#moving = settled(answered);
      return answered;
    }
    return new Promise((resolve, reject) => {
      this.#waiting = { question, resolve, reject };
      if (!this.#busy) this.#working = this.#work();
    });
  }

  /** An answer improved by one step of refinement. Null when a query is waiting: that comes first. */
  refine(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const { question, pathKind } = answer;
      // The exact path does not depend on the field.
      const request = pathKind === 'exact' ? null : requestOf(question, pathKind);
      const { field, path, pathMs } = await this.#api.refine(request);
      this.#held = { question, field };
      return request ? named({ ...answer, field, path, pathMs }) : { ...answer, field };
    });
  }

  /**
   * One step of the search for the exact path: an answer with it, or the same answer while it is not found. Null when a
   * query is waiting: that comes first.
   */
  traceExactly(answer: Answer): Promise<Answer | null> {
    return this.#better(answer, async () => {
      const { from } = answer.question;
      const found = from && (await this.#api.searchPath(from));
      // The time of a path is that of one traced during a drag.
      return found ? { ...answer, path: found.path, pathKind: 'exact' } : answer;
    });
  }

  /** Shows the mesh in a pose without measuring there. Null where it does not move, and where distances are measured in poses. */
  async pose(moment: Moment | null): Promise<Posed | null> {
    if (this.#measured) return null;
    this.#shown = moment;
    return this.#api.pose(moment, false);
  }

  dispose(): void {
    this.#waiting?.resolve(null);
    this.#waiting = null;
    this.#worker.end(new Cancelled());
  }

  #between<T>(ask: () => Promise<T>): Promise<T> {
    const answered = this.#bettering.then(async () => {
      while (this.#busy) await this.#working;
      this.#busy = true;
      try {
        return await ask();
      } finally {
        this.#working = this.#work();
      }
    });
    this.#bettering = settled(answered);
    return answered;
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
      while (this.#solving) await this.#moving;
    }
    this.#busy = false;
  }

  /** One at a time: a slice that nobody waits for any more may still be under way. */
  #better(answer: Answer, work: () => Promise<Answer>): Promise<Answer | null> {
    const better = this.#bettering.then(() => this.#betterNow(answer, work));
    this.#bettering = settled(better);
    return better;
  }

  async #betterNow(answer: Answer, work: () => Promise<Answer>): Promise<Answer | null> {
    if (this.#busy || !this.#held || !isSameField(this.#held.question, answer.question)) return null;
    this.#busy = true;
    try {
      const better = await work();
      return this.#waiting ? null : better;
    } finally {
      this.#working = this.#work();
    }
  }

  async #answer(question: Question): Promise<Answer | null> {
    const api = this.#api;
    const { parameters, sources } = question;
    if (question.method === 'heat' && parameters !== this.#parameters) {
      this.#factoring = await api.configure(parameters);
      this.#parameters = parameters;
      this.#held = null;
    }
    // The question follows without waiting for it: each turn of the page may take as long as a frame.
    const posing = isSameMoment(question.moment, this.#measured) ? null : this.#measureAt(question.moment);
    if (mayBeJoined(this.opened) && !this.#isJoinedFor(question)) {
      await Promise.all([posing, this.#join(question)]);
    }
    const isLaid = this.opened.interior || question.ground === this.#ground;
    const laying = isLaid ? null : this.#lay(question.ground);
    if (this.opened.interior && question.inside !== this.#inside) {
      this.#inside = question.inside;
      this.#view = await api.look(innerCutOf(question.inside, this.box));
    }
    const about = this.#about(question);
    if (sources.length === 0) {
      const [posed] = await Promise.all([posing, laying]);
      return { ...about, posed, field: null, path: null, pathMs: 0 };
    }
    const held = this.#held;
    // Another path does not undo what refinement has reached, unless that is not wanted.
    if (held && isFieldOf(held.field, held.question, question)) {
      const path = await this.#path(requestOf(question, about.pathKind));
      return named({ ...about, posed: null, field: held.field, ...path });
    }
    const [posed, , answer] = await Promise.all([posing, laying, this.#solve(question)]);
    return answer && named({ ...answer, posed });
  }

  #about(question: Question): Known {
    const pathKind = pathKindOf(question, isWeighted(question.ground));
    return { question, pathKind, factoring: this.#factoring, inside: this.#view };
  }

  /** Solves for a field. Null where the worker was asked for another one before it began. */
  async #solve(question: Question): Promise<(Known & Solved) | null> {
    this.#held = null;
    this.#solving = question;
    const api = this.#api;
    const { quick } = question;
    const sources = [...question.sources];
    const about = this.#about(question);
    const request = requestOf(question, about.pathKind);
    try {
      const solved = await (question.method === 'heat'
        ? api.solve(sources, quick, request)
        : api.propagate(sources, windowsOf(question, isWeighted(question.ground)), quick, request));
      if (!solved) return null;
      if (this.#solving === question) this.#held = { question, field: solved.field };
      this.#view = solved.inside;
      return { ...about, ...solved };
    } finally {
      if (this.#solving === question) this.#solving = null;
    }
  }

  /** While the mesh moves, its parts stay joined where they met when it stood still: that takes too long for each frame. */
  #isJoinedFor({ bridge, links, moment, quick }: Question): boolean {
    const isAsItStands = isSameMoment(moment, this.#joinedAt) || (quick && moment !== null);
    return bridge === this.#bridge && links === this.#links && isAsItStands;
  }

  async #join({ bridge, links, moment }: Question): Promise<void> {
    this.#factoring = await this.#api.bridge(String(bridge), links, moment !== null);
    this.#bridge = bridge;
    this.#links = links;
    this.#joinedAt = moment;
    this.#held = null;
  }

  #measureAt(moment: Moment | null): Promise<Posed | null> {
    this.#held = null;
    this.#measured = moment;
    // Where distances are those of the file again, what is shown stays.
    if (moment) this.#shown = moment;
    return this.#api.pose(this.#shown, moment !== null);
  }

  #lay(ground: Ground): Promise<void> {
    const change = changeOf(this.#ground, ground);
    this.#held = null;
    this.#ground = ground;
    return this.#api.ground(change);
  }

  async #path(request: PathRequest | null): Promise<TracedPath> {
    return request ? this.#api.path(request) : { path: null, pathMs: 0 };
  }
}

function windowsOf({ quick, windows }: Question, weighted: boolean): number {
  if (quick) return QUICK_WINDOWS;
  return weighted ? Math.max(windows, REFRACTED_WINDOWS) : windows;
}

function requestOf({ from }: Question, kind: PathKind): PathRequest | null {
  return from && { from, kind };
}

/** Ends when a promise does, however it does. */
function settled(promise: Promise<unknown>): Promise<void> {
  return promise.then(
    () => undefined,
    () => undefined,
  );
}
