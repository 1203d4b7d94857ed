/** Texts and numbers in the language of the page, each written when it is read: a switch of the language writes it again. */

/** Texts by those in English, in which `{0}` is the first value that is put in. */
export type Texts = Readonly<Record<string, string>>;

/** A text that depends on the language. */
export class Phrase {
  readonly #write: () => string;

  constructor(write: () => string) {
    this.#write = write;
  }

  toString(): string {
    return this.#write();
  }
}

export type Words = string | Phrase;

/** A number that is no length of a model: those are told in a unit, by `web/length.ts`. */
export type Plain = number & { readonly ofModel?: never };

/** What sentences of workers are in a language. */
export type Retell = (sentence: string) => string;

const ENGLISH: Retell = (sentence) => sentence;

/** Texts of the page, and sentences of workers. Without any, all is English. */
let spoken: { language: string; texts: Texts; retell: Retell } = { language: 'en', texts: {}, retell: ENGLISH };

export function speak(language: string, texts: Texts = {}, retell = ENGLISH): void {
  spoken = { language, texts, retell };
}

/** A text in the language of the page: a string, or a template, whose values stay as they are. */
export function t(text: string | TemplateStringsArray, ...values: readonly (Words | Plain)[]): Phrase {
  const key = typeof text === 'string' ? text : text.reduce((before, part, index) => `${before}{${index - 1}}${part}`);
  return new Phrase(() => filled(spoken.texts[key] ?? key, values));
}

function filled(text: string, values: readonly unknown[]): string {
  return values.length === 0 ? text : text.replaceAll(/\{(\d)\}/g, (_, index) => String(values[Number(index)]));
}

/** A format of the language, made once for each. */
function formatOf<F>(make: (language: string) => F): () => F {
  const made = new Map<string, F>();
  return () => {
    const { language } = spoken;
    const format = made.get(language) ?? make(language);
    made.set(language, format);
    return format;
  };
}

/** Writes numbers as the language does, with a minus sign. */
export function numbers(options: Intl.NumberFormatOptions): (value: Plain) => Phrase {
  const format = formatOf((language) => new Intl.NumberFormat(language, options));
  return (value) => new Phrase(() => format().format(value).replace('-', '−'));
}

/** A whole number, with its thousands apart. */
export const count = numbers({ maximumFractionDigits: 0 });

const decimals = formatOf((language) => new Intl.NumberFormat(language).format(0.5));

/** Numbers as a person types them, with decimal points: where the language has decimal commas, a comma between digits is one. */
export function plainNumbers(text: string): string {
  return decimals().includes(',') ? text.replaceAll(/(?<=\d),(?=\d)/g, '.') : text;
}

const plurals = formatOf((language) => new Intl.PluralRules(language));

/** A text about a number, which is `{0}` in it; `more` are the values after it. */
export function counted(value: Plain, one: string, other: string, ...more: readonly (Words | Plain)[]): Phrase {
  const values = [count(value), ...more];
  const [single, several] = [t(one, ...values), t(other, ...values)];
  return new Phrase(() => String(plurals().select(value) === 'one' ? single : several));
}

/** The same; null of none, which lists and sentences leave out. */
export function some(...[value, ...texts]: Parameters<typeof counted>): Phrase | null {
  return value > 0 ? counted(value, ...texts) : null;
}

const names = formatOf((language) => new Intl.ListFormat(language));

/** Figures and properties one after the other: "a, b, c". */
export function listed(...words: readonly (Words | null)[]): Phrase {
  const all = words.filter((each) => each !== null);
  return new Phrase(() => all.map(String).reduce((before, next) => String(t`${before}, ${next}`)));
}

/** Things that a sentence names: "a, b, and c". */
export function enumerated(words: readonly Words[]): Phrase {
  return new Phrase(() => names().format(words.map(String)));
}

/** Sentences one after the other. */
export function sentences(...all: readonly (Words | null)[]): Phrase {
  return new Phrase(() => all.filter((each) => each !== null).join(' '));
}

/** A sentence of a worker, which is in English, and what is put into it, in the language of the page. */
export function retold(sentence: string): Phrase {
  return new Phrase(() => spoken.retell(sentence));
}
