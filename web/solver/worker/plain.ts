import type { Plain } from '../../protocol';

/** What a wasm module gave, as a message; its memory is given back. */
export function plain<T extends { toJSON(): object; free(): void }>(given: T): Plain<T> {
  const message = given.toJSON() as Plain<T>;
  given.free();
  return message;
}
