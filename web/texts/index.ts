/**
 * The language of the page. Texts are written in English where they are shown, inside `t`, and other languages have a file with
 * each of them: `fr/`.
 */

import { speak } from './translate';

export { t } from './translate';

export const LANGUAGES = { en: 'English', fr: 'Français' } as const;
export type Language = keyof typeof LANGUAGES;

const KEY = 'heatwalk.language';

/** That of the address (`?lang=fr`), else the one chosen before, else that of the browser. Tests have English. */
export const language: Language = typeof document === 'undefined' ? 'en' : preferred();

// Whatever imports this waits for it.
if (language === 'fr') speak((await import('./fr')).FRENCH);

if (typeof document !== 'undefined') document.documentElement.lang = language;

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
