/**
 * The language of the page. Texts are written in English where they are shown, inside `t`, and other languages have a file with
 * each of them: `fr.ts`.
 */

export const LANGUAGES = { en: 'English', fr: 'Français' } as const;
export type Language = keyof typeof LANGUAGES;

/** Texts by those in English, in which `{0}` is the first value that is put in. */
export type Texts = Readonly<Record<string, string>>;

const KEY = 'heatwalk.language';

/** That of the address (`?lang=fr`), else the one chosen before, else that of the browser. Workers and tests have English. */
export const language: Language = typeof document === 'undefined' ? 'en' : preferred();

const texts: Texts | null = language === 'en' ? null : (await import('./fr')).FRENCH;

if (typeof document !== 'undefined') document.documentElement.lang = language;

/** A text in the language of the page: a string, or a template, whose values stay as they are. */
export function t(text: string | TemplateStringsArray, ...values: readonly (string | number)[]): string {
  const key = typeof text === 'string' ? text : text.reduce((before, part, index) => `${before}{${index - 1}}${part}`);
  const found = texts?.[key] ?? key;
  return values.length === 0 ? found : found.replaceAll(/\{(\d)\}/g, (_, index) => String(values[Number(index)]));
}

/** Shows the page in another language, the scene as it is, from now on. */
export function choose(chosen: Language): void {
  try {
    localStorage.setItem(KEY, chosen);
  } catch {
    // Storage may be disabled; then the address holds the choice.
  }
  const address = new URL(location.href);
  address.searchParams.set('lang', chosen);
  history.replaceState(null, '', address);
  location.reload();
}

function preferred(): Language {
  const wishes = [new URLSearchParams(location.search).get('lang'), stored(), ...navigator.languages];
  for (const wish of wishes) {
    const found = Object.keys(LANGUAGES).find((known) => wish?.toLowerCase().split('-')[0] === known);
    if (found) return found as Language;
  }
  return 'en';
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
