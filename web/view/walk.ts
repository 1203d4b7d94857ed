/** The walker's clock: how far along the path it is. */

const CROSSING_SECONDS = 7;
const REST_SECONDS = 1;

function even(): number {
  return 1;
}

export class Walk {
  #length = 0;
  /** What a unit of length costs at an arc length. */
  #costAt: (arc: number) => number = even;
  #arc = 0;
  #rested = 0;
  /** Called when a performance is over. */
  #applaud: (() => void) | null = null;
  paused = false;

  /** Where the walker stands, as arc length from the start. */
  get arc(): number {
    return this.#arc;
  }

  get length(): number {
    return this.#length;
  }

  get arrived(): boolean {
    return this.#length > 0 && this.#arc >= this.#length;
  }

  /** Whether a performance is running; pausing does not stop it. */
  get performs(): boolean {
    return this.#applaud !== null;
  }

  /** Walks once from the start; resolves when it has arrived and rested, or when its path ends or another walk begins. */
  perform(): Promise<void> {
    this.end();
    this.#arc = 0;
    this.#rested = 0;
    return new Promise((resolve) => {
      this.#applaud = resolve;
    });
  }

  /** Ends a performance, if there is one. */
  end(): void {
    this.#applaud?.();
    this.#applaud = null;
  }

  /** Another path, and what it costs at an arc length: from its start if `fromStart`, else at the same share of the length, so that edits do not jolt the walker. */
  follow(length: number, fromStart: boolean, costAt: (arc: number) => number = even): void {
    const share = fromStart || this.#length === 0 ? 0 : this.#arc / this.#length;
    this.#length = length;
    this.#costAt = costAt;
    this.#arc = share * length;
    if (fromStart) this.#rested = 0;
    if (length === 0) this.end();
  }

  /** `diameter` of the model sets the speed: where a unit costs 1, one crossing takes seven seconds. True if the walker moved. */
  advance(seconds: number, diameter: number): boolean {
    if ((this.paused && !this.performs) || this.#length === 0) return false;
    if (!this.arrived) {
      this.#arc = Math.min(this.#length, this.#arc + (seconds * diameter) / CROSSING_SECONDS / this.#costAt(this.#arc));
      this.#rested = 0;
      return true;
    }
    this.#rested += seconds;
    if (this.#rested < REST_SECONDS) return false;
    this.end();
    this.#arc = 0;
    this.#rested = 0;
    return true;
  }
}
