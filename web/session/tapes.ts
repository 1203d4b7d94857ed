/** Measures the tapes of the scene, beside the field: a locally shortest path first where the exact one takes long. */
import type { Enclosure, Leg, MeshPoint } from '../protocol';
import type { Engine } from '../solver/engine';
import { MOST_SECONDS } from '../solver/refiner';
import { Cancelled, WorkerLost } from '../solver/remote';
import { isOutOfMemory } from '../solver/trap';
import { isWeighted } from '../state/ground';
import { distance } from '../state/vector';
import { type ModelLength, ofModel } from '../length';
import { Signal, until } from '../state/signal';
import { legsOf, type Tape } from '../state/tapes';
import type { Shown } from './prepare';
import type { Session } from './session';
import { entry } from '../state/entry';

/**
 * What is known of a leg. `measuring`: nothing yet; `estimated`: a locally shortest path, while the exact one is searched;
 * `exact`; `approximate`: locally shortest, since memory or time did not suffice for the exact one, or since it bends inside of
 * tetrahedra; `cost`: of locally least cost; `none`: no path leads there.
 */
export type LegState = 'measuring' | 'estimated' | 'exact' | 'approximate' | 'cost' | 'none';

export interface MeasuredLeg {
  state: LegState;
  /** The path; null where there is none, or none yet. */
  leg: Leg | null;
  /** Length of the straight line. */
  straight: ModelLength;
}

export interface MeasuredTape {
  tape: Tape;
  legs: readonly MeasuredLeg[];
  /** What a closed tape encloses; null while its legs are not known, and for others. */
  enclosure: Enclosure | null;
}

/** What a tape tells, in the unit of the file; what is not known, or is none, is null. */
export interface TapeFigures {
  closed: boolean;
  legs: readonly { state: LegState; length: number | null; straight: number }[];
  length: number | null;
  area: number | null;
}

/** By which share a straight path may be longer than the straight line, for rounding. */
const STRAIGHT = 1e-9;

/** What lengths depend on, beside the places. */
type Basis = Pick<Shown['answer']['question'], 'bridge' | 'links' | 'ground' | 'moment'> & { engine: Engine };

const isKnown = ({ state }: MeasuredLeg) => state !== 'measuring' && state !== 'estimated';

/** Sum of the lengths of the paths; NaN while one is not known, or is none. */
export function lengthOf({ legs }: Pick<MeasuredTape, 'legs'>): ModelLength {
  return ofModel(legs.reduce((sum, { leg }) => sum + (leg?.length ?? NaN), 0));
}

/** Sum of the straight lines. */
export function straightOf({ legs }: Pick<MeasuredTape, 'legs'>): ModelLength {
  return ofModel(legs.reduce((sum, { straight }) => sum + straight, 0));
}

/** What is known of all legs together: the least of it. */
export function stateOf({ legs }: Pick<MeasuredTape, 'legs'>): LegState {
  const order: LegState[] = ['none', 'measuring', 'estimated', 'approximate', 'cost', 'exact'];
  return order.find((state) => legs.some((leg) => leg.state === state)) ?? 'exact';
}

export function figuresOf(measured: MeasuredTape): TapeFigures {
  const length = lengthOf(measured);
  return {
    closed: measured.tape.closed,
    legs: measured.legs.map(({ state, leg, straight }) => ({ state, length: leg?.length ?? null, straight })),
    length: Number.isFinite(length) ? length : null,
    area: measured.enclosure?.kind === 'sides' ? measured.enclosure.area : null,
  };
}

export class Tapes {
  readonly measured = new Signal<readonly MeasuredTape[]>([]);
  readonly #session: Session;
  #basis: Basis | null = null;
  readonly #legs = new Map<string, MeasuredLeg>();
  readonly #enclosures = new Map<string, Enclosure>();
  #isBusy = false;

  constructor(session: Session) {
    this.#session = session;
    session.shown.watch(() => this.#follow());
    session.scene.subscribe((state, previous) => {
      if (state.tapes !== previous.tapes) this.#follow();
    });
  }

  /** Resolves when everything is measured that can be. */
  async settled(): Promise<void> {
    await until(() => !this.#isBusy, this.measured);
  }

  #follow(): void {
    const basis = this.#basisNow();
    const before = this.#basis;
    if (!basis || !before || Object.entries(basis).some(([key, value]) => value !== before[key as keyof Basis])) {
      this.#basis = basis;
      this.#legs.clear();
      this.#enclosures.clear();
    }
    this.#show();
    if (!this.#isBusy) void this.#work();
  }

  #basisNow(): Basis | null {
    const { shown, engine } = this.#session;
    if (!shown.value || !engine) return null;
    const { bridge, links, ground, moment } = shown.value.answer.question;
    return { bridge, links, ground, moment, engine };
  }

  #show(): void {
    this.measured.value = this.#session.scene.state.tapes.map((tape) => {
      const legs = legsOf(tape).map((ends) => this.#legs.get(keyOf(ends)) ?? this.#unmeasured(ends));
      return { tape, legs, enclosure: this.#enclosures.get(keyOf(tape)) ?? null };
    });
  }

  #unmeasured([from, to]: readonly [MeshPoint, MeshPoint]): MeasuredLeg {
    const { shown } = this.#session;
    const [a, b] = [from, to].map((end) => shown.value?.places.at(end)?.position);
    if (!shown.value || !a || !b) return { state: 'none', leg: null, straight: ofModel(NaN) };
    const { scale } = shown.value.opened.drawTransform;
    return { state: 'measuring', leg: null, straight: ofModel(distance(a, b) / scale) };
  }

  /** Measures what is not measured, one leg after the other, the newest tape first. */
  async #work(): Promise<void> {
    this.#isBusy = true;
    for (let isOpen = true; isOpen;) {
      const [basis, asked] = [this.#basis, this.measured.value];
      try {
        // During a step other tapes may have come, or another mesh.
        isOpen = (await this.#step()) || asked !== this.measured.value;
      } catch (error) {
        isOpen = basis !== this.#basis;
        if (!(error instanceof Cancelled || error instanceof WorkerLost)) this.#session.fail(error);
      }
    }
    this.#isBusy = false;
    this.#show();
  }

  /** False: nothing is left. */
  async #step(): Promise<boolean> {
    const basis = this.#basis;
    if (!basis) return false;
    for (const { tape, legs, enclosure } of this.measured.value.toReversed()) {
      const open = legs.findIndex((leg) => !isKnown(leg));
      if (open >= 0) {
        await this.#measure(basis, entry(legsOf(tape), open));
        return true;
      }
      const paths = legs.flatMap(({ leg }) => (leg && 'triangles' in leg ? leg : []));
      if (tape.closed && !enclosure && paths.length === legs.length) {
        const found = await basis.engine.inTurn.enclosed(paths);
        this.#keep(basis, () => this.#enclosures.set(keyOf(tape), found));
        return true;
      }
    }
    return false;
  }

  /** Until the leg is known, or nobody wants it any more. */
  async #measure(basis: Basis, ends: readonly [MeshPoint, MeshPoint]): Promise<void> {
    const { engine, ground } = basis;
    const began = performance.now();
    const put = (state: LegState, leg: Leg | null) => {
      const straight = leg?.straight ?? this.#unmeasured(ends).straight;
      this.#keep(basis, () => this.#legs.set(keyOf(ends), { state: leg ? state : 'none', leg, straight }));
    };
    if (isWeighted(ground)) {
      put('cost', await engine.inTurn.estimate(...ends));
      return;
    }
    let estimate: Leg | null = null;
    try {
      for (;;) {
        const found = await engine.inTurn.measure(...ends);
        if (found) {
          put(isExact(found.leg) ? 'exact' : 'approximate', found.leg);
          return;
        }
        if (!this.#isWanted(basis, ends)) return;
        if (performance.now() - began > 1000 * MOST_SECONDS) break;
        if (estimate) continue;
        estimate = await engine.inTurn.estimate(...ends);
        put('estimated', estimate);
        if (!estimate) return;
      }
    } catch (error) {
      if (!(error instanceof Error && isOutOfMemory(error)) || error instanceof WorkerLost) throw error;
    }
    put('approximate', estimate ?? (await engine.inTurn.estimate(...ends)));
  }

  #isWanted(basis: Basis, ends: readonly [MeshPoint, MeshPoint]): boolean {
    const { tapes } = this.#session.scene.state;
    return basis === this.#basis && tapes.some((tape) => legsOf(tape).some((leg) => keyOf(leg) === keyOf(ends)));
  }

  /** What was found on another ground is dropped. */
  #keep(basis: Basis, put: () => void): void {
    if (basis !== this.#basis) return;
    put();
    this.#show();
  }
}

/** What is found on a surface is; inside, where a straight line leads there. */
function isExact(leg: Leg | null): boolean {
  return !leg || 'triangles' in leg || leg.length <= (1 + STRAIGHT) * leg.straight;
}

function keyOf(places: unknown): string {
  return JSON.stringify(places);
}
