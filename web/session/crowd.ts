/** The crowd: asks the solver for its next step whenever the last one has come, and shows it. */
import { LARGEST_CROWD } from '../state/scene';
import { reducedMotion, type Session } from './session';

/** A walker of the crowd crosses the model in this time. */
const CROSSING_SECONDS = 12;

export class CrowdWalk {
  readonly #session: Session;
  /** How many the solver has, and of which mesh. */
  #out: { count: number; mesh: unknown } = { count: 0, mesh: null };
  #waiting: Promise<void> | null = null;
  /** Seconds since the last step was asked for. */
  #seconds = 0;

  constructor(session: Session) {
    this.#session = session;
  }

  /** To be called once a frame. */
  advance(seconds: number): void {
    const { shown, scene, paused } = this.#session;
    const mesh = shown.value?.opened ?? null;
    const count = mesh && shown.value?.answer.field ? Math.min(scene.state.crowd, LARGEST_CROWD) : 0;
    const asked = count !== this.#out.count || (count > 0 && mesh !== this.#out.mesh);
    this.#seconds += seconds;
    if (this.#waiting || !(asked || (count > 0 && !paused.value && !reducedMotion()))) return;
    this.#waiting = this.#step(count, mesh, asked, shown.value?.places.diameter ?? 1).finally(() => {
      this.#waiting = null;
    });
  }

  /** Resolves when the step under way is shown. */
  async settled(): Promise<void> {
    await this.#waiting;
  }

  async #step(count: number, mesh: unknown, asked: boolean, diameter: number): Promise<void> {
    const session = this.#session;
    const step = asked ? 0 : (this.#seconds * diameter) / CROSSING_SECONDS;
    this.#seconds = 0;
    try {
      if (asked) await session.crowd(count);
      const poses = count > 0 ? await session.stepCrowd(step) : new Float32Array();
      this.#out = { count, mesh };
      if (session.shown.value?.opened === mesh) session.view.setCrowd(poses);
    } catch (error) {
      // A mesh that was closed meanwhile has no crowd.
      if (session.shown.value?.opened === mesh) throw error;
    }
  }
}
