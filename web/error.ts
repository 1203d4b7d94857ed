/** What was thrown, which may be anything, as an error. */
import { retold, type Words } from './texts/translate';

export function toError(thrown: unknown): Error {
  return thrown instanceof Error ? thrown : new Error(String(thrown));
}

/** An error whose message is in the language of the page. */
export class Failure extends Error {
  readonly words: Words;

  constructor(words: Words, options?: ErrorOptions) {
    super(String(words), options);
    this.words = words;
  }
}

/** What an error says, whatever was thrown. */
export function messageOf(thrown: unknown): Words {
  return thrown instanceof Failure ? thrown.words : retold(toError(thrown).message);
}

/** Where it was thrown, for whoever looks into it. */
export function detailsOf(thrown: unknown): string {
  const { message, stack } = toError(thrown);
  return stack ?? message;
}
