/** A value that tells when it changes. */
export class Signal<T> {
  #value: T;
  readonly #listeners = new Set<(value: T, previous: T) => void>();

  constructor(value: T) {
    this.#value = value;
  }

  get value(): T {
    return this.#value;
  }

  set value(next: T) {
    const previous = this.#value;
    if (Object.is(next, previous)) return;
    this.#value = next;
    for (const listener of this.#listeners) listener(next, previous);
  }

  /** Calls at once with the present value, then on every change. */
  watch(listener: (value: T, previous: T) => void): void {
    this.#listeners.add(listener);
    listener(this.#value, this.#value);
  }
}
