/** Messages of which only the last that has come by now matters. */
export class Latest {
  #count = 0;

  /** Whether no other message of the kind waits behind this one. */
  async isLast(): Promise<boolean> {
    this.#count += 1;
    const number = this.#count;
    // Messages that have come are heard before this goes on.
    await new Promise((resolve) => setTimeout(resolve));
    return number === this.#count;
  }
}
