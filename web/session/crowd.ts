/** The crowd: asks the solver for its next step whenever the last one has come, and shows it. */
import type { Engine } from '../solver/engine';
import { CROWD_HEIGHT, LARGEST_CROWD } from '../state/scene';
import { reducedMotion } from '../view/motion';
import type { Session } from './session';

/** A walker of the crowd crosses the model in this time. */
const CROSSING_SECONDS = 12;

/** How many are shown, who moves them, and on which mesh. */
interface Out {
  count: number;
  engine: Engine;
  mesh: unknown;
}

export class CrowdWalk {
  readonly #session: Session;
  #out: Out | null = null;
  #waiting: Promise<void> | null = null;
  /** Seconds since the last step was asked for. */
  #seconds = 0;

  constructor(session: Session) {
    this.#session = session;
  }

  /** To be called once a frame. */
  advance(seconds: number): void {
    const { shown, scene, paused, engine } = this.#session;
    const count = shown.value?.answer.field ? Math.min(scene.state.crowd, LARGEST_CROWD) : 0;
    const mesh = shown.value?.opened;
    const anew = engine !== this.#out?.engine || mesh !== this.#out.mesh;
    const asked = count !== (this.#out?.count ?? 0) || (count > 0 && anew);
    this.#seconds += seconds;
    if (!engine || this.#waiting || !(asked || (count > 0 && !paused.value && !reducedMotion()))) return;
    this.#waiting = this.#step({ count, engine, mesh }, asked, shown.value?.places.diameter ?? 1).finally(() => {
      this.#waiting = null;
    });
  }

  /** Resolves when the step under way is shown, and who is wanted since: the next frame, which asks for them, may be long in coming. */
  async settled(): Promise<void> {
    await this.#waiting;
    this.advance(0);
    await this.#waiting;
  }

  async #step(out: Out, asked: boolean, diameter: number): Promise<void> {
    const { count, engine } = out;
    const session = this.#session;
    const step = asked ? 0 : (this.#seconds * diameter) / CROSSING_SECONDS;
    this.#seconds = 0;
    this.#out = out;
    try {
      if (asked) await engine.queries.crowd(count, CROWD_HEIGHT);
      const poses = count > 0 ? await engine.queries.stepCrowd(step) : new Float32Array();
      if (session.engine === engine) session.view.setCrowd(poses);
    } catch (error) {
      session.fail(error);
    }
  }
}
