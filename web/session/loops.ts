/** Loops around the handles of the surface: asks for them, and shows them. Loaded when they are first wanted. */
import type { FoundLoops } from '../protocol';
import { Cancelled, WorkerLost } from '../solver/remote';
import { rimmed } from '../view/layers';
import { type Asked, isSameSurface, surfaceOf } from './exact';
import type { Shown } from './prepare';
import type { Session } from './session';

const LOOP = { colour: '#ff8a00', width: 3 } as const;

export class Loops {
  readonly #session: Session;
  #asked: Asked | null = null;
  #finding: Promise<void> = Promise.resolve();

  constructor(session: Session) {
    this.#session = session;
  }

  /** Shows what the scene wants by now. Resolves when it is shown, or something else is wanted. */
  follow(): Promise<void> {
    const { engine, shown, scene } = this.#session;
    const { value } = shown;
    if (!scene.state.overlays.includes('loops') || !engine || !value || value.opened.interior) {
      this.#show(null, null);
      return Promise.resolve();
    }
    const asked = { engine, question: value.answer.question };
    if (this.#asked && isSameSurface(this.#asked, asked)) return this.#finding;
    this.#show(asked, null);
    this.#finding = this.#find(asked, value);
    return this.#finding;
  }

  async #find(asked: Asked, { opened }: Shown): Promise<void> {
    try {
      const found = await asked.engine.inTurn.handleLoops(surfaceOf(opened, asked));
      if (this.#asked === asked) this.#show(asked, found);
    } catch (error) {
      if (this.#asked === asked && !(error instanceof Cancelled || error instanceof WorkerLost))
        this.#session.fail(error);
    }
  }

  #show(asked: Asked | null, found: FoundLoops | null): void {
    if (!asked && !this.#asked) return;
    this.#asked = asked;
    const { view, loops } = this.#session;
    view.setEdges('loops', found ? rimmed({ ...LOOP, ends: found.ends }, 0.5) : []);
    loops.value = found;
  }
}
