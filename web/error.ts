/** What was thrown, which may be anything, as an error. */
import { Phrase, retold, type Words } from './texts/translate';

export function toError(thrown: unknown): Error {
  return thrown instanceof Error ? thrown : new Error(String(thrown));
}

/** Whether a worker was asked about a field while it held none: the next is on its way, or could not be solved. */
export function isUnsolved(thrown: unknown): boolean {
  return toError(thrown).name === 'no-source';
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

/** The same as a sentence that stands alone: those of workers are made to follow a colon. */
export function sentenceOf(thrown: unknown): Words {
  const words = messageOf(thrown);
  return thrown instanceof Failure ? words : asSentence(words);
}

/** Words with a capital, and with a full stop where nothing ends them. */
export function asSentence(words: Words): Words {
  return new Phrase(() =>
    String(words)
      .replace(/^\p{Ll}+(?= )/u, (word) => word.charAt(0).toUpperCase() + word.slice(1))
      .replace(/(?<=[\p{L}\p{N}])$/u, '.'),
  );
}

/** Where it was thrown, for whoever looks into it. */
export function detailsOf(thrown: unknown): string {
  const { message, stack } = toError(thrown);
  return stack ?? message;
}
