/** How many pixels are drawn while something moves: as many as a weak graphics device draws fluently. */

import { entry } from '../state/entry';
/** Shares of the pixels along an edge, from all of them on. */
const SHARES = [1, 0.75, 0.5, 0.35] as const;
/** Frames that take longer, less than 25 a second, are drawn with fewer pixels; milliseconds. */
const SLOW_MS = 40;
/** Frames that would not take longer with the next larger share are drawn with that one. */
const FAST_MS = 22;
/** Frames that are looked at before fewer pixels are drawn: a single slow one has another cause. */
const SLOW_FRAMES = 4;
const FAST_FRAMES = 30;
/** Frames with fewer pixels have to take at most this share of the time; else it is not the pixels that take it. */
const WORTH = 0.85;
/** Frames after which fewer pixels are tried again where they gained nothing, then twice as many, and so on. */
const RETRY_FRAMES = 60;
/** After so long without a frame, the picture at rest is drawn with all pixels; milliseconds. */
const REST_MS = 200;

/** Frames in a row from which on something moves: one by itself is the picture at rest. */
const MOVING_FRAMES = 2;

export class Resolution {
  /** Index into `SHARES` while something moves. */
  #level = 0;
  /** Fewer pixels than at this one gain nothing. */
  #last = SHARES.length - 1;
  /** Frames until that is tried again. */
  #retry = RETRY_FRAMES;
  #sinceGain = 0;
  /** How long a frame took at the level before. */
  #before = Number.POSITIVE_INFINITY;
  /** How long each frame took since the level was last looked at. */
  #frames: number[] = [];
  #drawnInARow = 0;
  #drawn = 0;
  #rests = true;

  /** Of the pixels along an edge, for the frame to come. */
  get share(): number {
    return this.#rests ? 1 : entry(SHARES, this.#level);
  }

  /** A frame is to follow at `now`; `drew`: whether one was drawn the time before, `passed` milliseconds ago. */
  follow(now: number, drew: boolean, passed: number): void {
    if (!drew) {
      this.#drawnInARow = 0;
      if (now - this.#drawn > REST_MS) this.#rests = true;
      return;
    }
    this.#drawn = now;
    this.#drawnInARow += 1;
    if (this.#rests && this.#drawnInARow < MOVING_FRAMES) return;
    this.#rests = false;
    this.#frames.push(passed);
    this.#sinceGain += 1;
    if (this.#frames.length >= SLOW_FRAMES) this.#judge();
  }

  #judge(): void {
    const recent = middle(this.#frames.slice(-SLOW_FRAMES));
    if (recent > SLOW_MS) this.#lower(recent);
    else if (this.#frames.length >= FAST_FRAMES) this.#raise(middle(this.#frames));
  }

  #lower(took: number): void {
    if (this.#level > 0 && took > WORTH * this.#before) {
      this.#last = this.#level - 1;
      this.#sinceGain = 0;
    } else if (this.#last < SHARES.length - 1 && this.#sinceGain > this.#retry) {
      this.#last = SHARES.length - 1;
      this.#retry *= 2;
    }
    if (this.#level < this.#last) this.#before = took;
    this.#turn(Math.min(this.#last, this.#level + 1));
  }

  #raise(took: number): void {
    const next = Math.max(0, this.#level - 1);
    const expected = took * (entry(SHARES, next) / entry(SHARES, this.#level)) ** 2;
    this.#turn(expected < FAST_MS ? next : this.#level);
  }

  #turn(level: number): void {
    if (level < this.#level) this.#before = Number.POSITIVE_INFINITY;
    this.#level = level;
    this.#frames = [];
  }
}

function middle(values: readonly number[]): number {
  return entry(
    values.toSorted((a, b) => a - b),
    values.length >> 1,
  );
}
