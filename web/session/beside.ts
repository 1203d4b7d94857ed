/** What the worker finds beside the field, by exact distances on the same surface, and is shown while the scene wants it. */
import { Cancelled, WorkerLost } from '../solver/remote';
import { type Asked, isSameSurface } from './exact';
import type { Session } from './session';

export abstract class Beside<A extends Asked, Found> {
  protected readonly session: Session;
  #asked: A | null = null;
  #finding: Promise<void> = Promise.resolve();

  constructor(session: Session) {
    this.session = session;
  }

  /** What the scene wants; null: nothing; undefined: that is not known before another answer, or the end of a drag. */
  protected abstract get wanted(): A | null | undefined;
  protected abstract isSame(one: A, other: A): boolean;
  /** Null where it is no longer wanted. */
  protected abstract find(asked: A, isWanted: () => boolean): Promise<Found | null>;
  /** Null: nothing. */
  protected abstract show(found: Found | null): void;
  /** Others are being found, and what is shown is of before. */
  protected outdate(): void {}

  /** Shows what the scene wants by now. Resolves when it is shown, or something else is wanted. */
  follow(): Promise<void> {
    const { wanted } = this;
    if (wanted === undefined) return this.#finding;
    if (wanted === null) {
      this.#clear();
      return Promise.resolve();
    }
    if (this.#asked && this.isSame(this.#asked, wanted)) return this.#finding;
    if (this.#asked && !isSameSurface(this.#asked, wanted)) this.#clear();
    else this.outdate();
    this.#asked = wanted;
    this.#finding = this.#find(wanted);
    return this.#finding;
  }

  async #find(asked: A): Promise<void> {
    const isWanted = () => this.#asked === asked;
    try {
      const found = await this.find(asked, isWanted);
      if (found && isWanted()) this.show(found);
    } catch (error) {
      if (!isWanted()) return;
      this.show(null);
      // What has failed is not asked for again until something changes.
      if (error instanceof Cancelled || error instanceof WorkerLost) this.#asked = null;
      else this.session.fail(error);
    }
  }

  #clear(): void {
    if (!this.#asked) return;
    this.#asked = null;
    this.show(null);
  }
}
