/** Texts with values in them. */

/** Texts by those in English, in which `{0}` is the first value that is put in. */
export type Texts = Readonly<Record<string, string>>;

export type Value = string | number;

/** What stands for a text, or for a template: its words, and `{0}` in the place of the first value. */
export function keyOf(text: string | TemplateStringsArray): string {
  return typeof text === 'string' ? text : text.reduce((before, part, index) => `${before}{${index - 1}}${part}`);
}

export function filled(text: string, values: readonly Value[]): string {
  return values.length === 0 ? text : text.replaceAll(/\{(\d)\}/g, (_, index) => String(values[Number(index)]));
}
