/** Texts by those in English, in which `{0}` is the first value that is put in. */
export type Texts = Readonly<Record<string, string>>;

/** Those of the language; without them, all is English. */
let texts: Texts = {};

export function speak(others: Texts): void {
  texts = others;
}

/** A text in the language of the page: a string, or a template, whose values stay as they are. */
export function t(text: string | TemplateStringsArray, ...values: readonly (string | number)[]): string {
  const key = typeof text === 'string' ? text : text.reduce((before, part, index) => `${before}{${index - 1}}${part}`);
  const found = texts[key] ?? key;
  return values.length === 0 ? found : found.replaceAll(/\{(\d)\}/g, (_, index) => String(values[Number(index)]));
}
