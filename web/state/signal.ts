/** A value that tells when it changes. */
export class Signal<T> {
  #value: T;
  readonly #listeners = new Set<(value: T, previous: T | undefined) => void>();

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
    tellEach(this.#listeners, next, previous);
  }

  /** Calls at once with the present value, before which there was none, then on every change. Returns the function that ends this. */
  watch(listener: (value: T, previous: T | undefined) => void): () => void {
    this.#listeners.add(listener);
    listener(this.#value, undefined);
    return () => this.#listeners.delete(listener);
  }
}

/** One listener that fails keeps none of the others from hearing; its error is one that nobody has caught. */
export function tellEach<A extends unknown[]>(listeners: Iterable<(...news: A) => void>, ...news: A): void {
  for (const listener of listeners) {
    try {
      listener(...news);
    } catch (error) {
      queueMicrotask(() => {
        throw error;
      });
    }
  }
}

interface Watched {
  watch(listener: () => void): () => void;
}

/** Resolves once the condition holds, which only a change of one of the signals can bring about. */
export function until(condition: () => boolean, ...signals: readonly Watched[]): Promise<void> {
  return new Promise((resolve) => {
    const look = () => {
      if (!condition()) return;
      resolve();
      for (const end of ends.splice(0)) end();
    };
    const ends: (() => void)[] = [];
    for (const signal of signals) ends.push(signal.watch(look));
    look();
  });
}
