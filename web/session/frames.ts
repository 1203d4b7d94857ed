/** The loop of frames, and the moment at which a moved camera has come to rest. */
import { toError } from '../error';
import { isSameMoment } from '../solver/engine';
import { until } from '../state/signal';
import { Resolution } from '../view/resolution';
import type { CrowdWalk } from './crowd';
import type { Session } from './session';

/** After a pause (a hidden tab) nothing leaps; seconds. */
const LONGEST_STEP = 0.25;
/**
 * Where drawing takes longer than this, the processor draws, and the solver needs it too: what moves by itself then waits
 * as long again.
 */
const SLOW_MS = 80;

interface Listener {
  /** After each frame that was drawn. */
  drawn(): void;
  /** The camera has come to rest, whoever moved it. */
  rested(): void;
}

export class Frames {
  readonly #session: Session;
  readonly #crowd: CrowdWalk;
  readonly #listener: Listener;
  readonly #resolution = new Resolution();
  #last = performance.now();
  /** Whether the last frame was drawn. */
  #drew = false;
  /** Whether what moves by itself waited in the last frame. */
  #waited = false;
  /** Until when what moves by itself waits, and since when it has. */
  #rests = 0;
  #moved = performance.now();
  /** What went wrong in a frame last. */
  #reported = '';
  /** Whether a video is drawn, which has a clock of its own. */
  #isHeld = false;
  /** Where the camera was a frame ago, while a camera move still settles. */
  #settling: string | null = null;
  /** The same of any move, by whom ever. */
  #place = '';
  #isMoving = false;

  constructor(session: Session, crowd: CrowdWalk, listener: Listener) {
    this.#session = session;
    this.#crowd = crowd;
    this.#listener = listener;
    session.preview.watch((preview, before) => {
      // What was moved in front of a mesh that was not opened belongs to no scene.
      if (!preview && before && session.shown.value?.opened !== before.opened) this.#settling = null;
    });
  }

  /** Frames follow one another whatever happens in one of them. */
  start(): void {
    requestAnimationFrame((now) => {
      this.start();
      try {
        this.#frame(now);
      } catch (error) {
        this.#tell(toError(error));
      }
    });
  }

  /** Leaves all that moves by itself to `advance` until a work is done. */
  async hold<T>(work: () => Promise<T>): Promise<T> {
    this.#isHeld = true;
    try {
      return await work();
    } finally {
      this.#isHeld = false;
      // What was moved for the work alone is not at rest.
      this.#settling = null;
    }
  }

  /** Takes what moves by itself further, and resolves when it is drawn. */
  async advance(seconds: number): Promise<void> {
    const { pose, animator, failure, view } = this.#session;
    this.#crowd.advance(seconds);
    this.#session.animate(seconds);
    await this.#crowd.settled();
    await until(() => isSameMoment(pose.value, animator.moment.value) || failure.value !== null, pose, failure);
    if (view.render(0)) this.#listener.drawn();
  }

  /** The user moved the camera: once at rest it belongs to the scene. */
  cameraMoved(): void {
    this.#settling = '';
    this.#isMoving = true;
  }

  #frame(now: number): void {
    const passed = now - this.#last;
    if (this.#isHeld) {
      // A pose that was overtaken is asked for again.
      this.#session.animate(0);
      this.#last = this.#moved = now;
      return;
    }
    // A frame that was slow to draw delays the next one.
    if (this.#drew && passed > SLOW_MS) this.#rests = now + passed;
    if (now >= this.#rests) {
      const seconds = step(now - this.#moved);
      this.#crowd.advance(seconds);
      this.#session.animate(seconds);
      this.#moved = now;
    }
    this.#last = now;
    // What waited is not at rest.
    if (this.#drew || !this.#waited) this.#resolution.follow(now, this.#drew, passed);
    this.#waited = now < this.#rests;
    // So do frames of fields that a drag asks for faster than they can be drawn.
    const waits = this.#waited && this.#session.dragging;
    this.#session.view.adapt(this.#resolution.share);
    this.#drew = !waits && this.#session.view.render(step(passed));
    if (this.#drew) this.#listener.drawn();
    if (this.#settling !== null && !this.#session.preview.value) this.#settle();
    this.#followCamera();
  }

  #followCamera(): void {
    const place = String(this.#session.view.camera);
    if (place !== this.#place) this.#isMoving = true;
    else if (this.#isMoving) {
      this.#isMoving = false;
      this.#listener.rested();
    }
    this.#place = place;
  }

  /** Once, though it may go wrong in every frame. */
  #tell(error: Error): void {
    if (error.message === this.#reported) return;
    this.#reported = error.message;
    this.#session.view.failure.value = error;
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

/** Seconds to go on by after `passed` milliseconds. */
function step(passed: number): number {
  return Math.min(LONGEST_STEP, Math.max(0, passed / 1000));
}
