/** The clock of an animation: which moment of it is to be shown. */
import type { Clip, Moment } from '../protocol';
import type { Scene } from '../state/history';
import { Signal } from '../state/signal';
import { momentOf } from './prepare';

export class Animator {
  /** Null: the mesh as its file has it. */
  readonly moment = new Signal<Moment | null>(null);
  readonly #scene: Scene;
  #clips: readonly Clip[] = [];

  constructor(scene: Scene) {
    this.#scene = scene;
    scene.subscribe(({ animation }, { animation: before }) => {
      const { clip, seconds } = animation;
      if (clip !== before.clip || seconds !== before.seconds) this.moment.value = momentOf(animation);
    });
  }

  /** The animations of another mesh. */
  set clips(clips: readonly Clip[]) {
    this.#clips = clips;
  }

  /** Goes to where the scene says. */
  restart(): void {
    this.moment.value = momentOf(this.#scene.state.animation);
  }

  /** Seconds that the present clip lasts; 0 without one. */
  get duration(): number {
    return this.#clips[this.#scene.state.animation.clip ?? -1]?.seconds ?? 0;
  }

  get plays(): boolean {
    return this.#scene.state.animation.plays && this.duration > 0;
  }

  advance(passed: number): void {
    const { clip, speed, loops } = this.#scene.state.animation;
    if (!this.plays || clip === null) return;
    const { duration } = this;
    const seconds = (this.moment.value?.seconds ?? 0) + passed * speed;
    this.moment.value = { clip, seconds: loops ? seconds % duration : Math.min(seconds, duration) };
    if (!loops && seconds >= duration) this.toggle();
  }

  /** Plays, from the beginning where it was played to its end; or stops at the moment that is shown. */
  toggle(): void {
    const { animation } = this.#scene.state;
    if (animation.clip === null || this.duration === 0) return;
    const shown = this.moment.value?.seconds ?? 0;
    const isOver = !animation.loops && shown >= this.duration;
    const seconds = isOver && !animation.plays ? 0 : shown;
    this.#scene.set({ animation: { ...animation, seconds, plays: !animation.plays } });
  }
}
