/** The loop of frames, and the moment at which a moved camera has come to rest. */
import type { CrowdWalk } from './crowd';
import type { Session } from './session';

/** After a pause (a hidden tab) nothing leaps. */
const LONGEST_STEP = 0.25;

export class Frames {
  readonly #session: Session;
  readonly #crowd: CrowdWalk;
  #last = performance.now();
  /** Where the camera was a frame ago, while a hand's move is still settling. */
  #settling: string | null = null;

  constructor(session: Session, crowd: CrowdWalk) {
    this.#session = session;
    this.#crowd = crowd;
  }

  start(): void {
    requestAnimationFrame((now) => this.#frame(now));
  }

  /** A hand moved the camera: once at rest it belongs to the scene. */
  cameraMoved(): void {
    this.#settling = '';
  }

  #frame(now: number): void {
    const seconds = Math.min(LONGEST_STEP, Math.max(0, (now - this.#last) / 1000));
    this.#crowd.advance(seconds);
    this.#session.frame(seconds);
    this.#last = now;
    if (this.#settling !== null) this.#settle();
    this.start();
  }

  #settle(): void {
    const { camera } = this.#session.view;
    const place = camera?.join() ?? '';
    if (camera && place === this.#settling) {
      this.#settling = null;
      this.#session.scene.set({ camera });
    } else {
      this.#settling = place;
    }
  }
}
