/** Traps of the renderer between the steps of an asynchronous call. They settle no promise and reach the window alone. */
import { isTrap } from '../solver/trap';

export class Traps {
  #pending: ((trap: Error) => void) | null = null;

  /** To be made before anybody else listens to errors: the window calls its listeners in the order in which they came. */
  constructor() {
    addEventListener('error', (event: ErrorEvent) => {
      if (!this.#pending || !(event.error instanceof Error && isTrap(event.error))) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      this.#pending(event.error);
    });
  }

  /** What the call answers, or the trap that ends it. One call at a time. */
  async during<T>(answer: Promise<T>): Promise<T> {
    const { promise, reject } = Promise.withResolvers<never>();
    this.#pending = reject;
    try {
      return await Promise.race([answer, promise]);
    } finally {
      this.#pending = null;
    }
  }
}
