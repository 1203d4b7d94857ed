/**
 * The language of the page. Texts are written in English where they are shown, inside `t`, and other languages have a file with
 * each of them in `fr/`. Workers speak English (`english.ts`).
 */

import { filled, keyOf, type Texts, type Value } from './template';

export const LANGUAGES = { en: 'English', fr: 'Français' } as const;
export type Language = keyof typeof LANGUAGES;

const KEY = 'heatwalk.language';

/** That of the address (`?lang=fr`), else the one chosen before, else that of the browser. Tests have English. */
export const language: Language = typeof document === 'undefined' ? 'en' : preferred();

const texts: Texts | null = language === 'fr' ? (await import('./fr')).FRENCH : null;

if (typeof document !== 'undefined') document.documentElement.lang = language;

/** A text in the language of the page: a string, or a template, whose values stay as they are. */
export function t(text: string | TemplateStringsArray, ...values: readonly Value[]): string {
  const key = keyOf(text);
  return filled(texts?.[key] ?? key, values);
}

/** The page has this language from its next start on. Where storage is disabled, the address holds the choice. */
export function choose(chosen: Language): void {
  const address = new URL(location.href);
  try {
    localStorage.setItem(KEY, chosen);
    address.searchParams.delete('lang');
  } catch {
    address.searchParams.set('lang', chosen);
  }
  history.replaceState(history.state, '', address);
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
