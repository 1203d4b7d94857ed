/**
 * The language of the page. Texts are written in English where they are shown, inside `t`, and other languages have a file with
 * each of them: `fr/`.
 */

import { speak } from './translate';

export {
  count,
  counted,
  enumerated,
  listed,
  numbers,
  Phrase,
  type Plain,
  plainNumbers,
  retold,
  sentences,
  some,
  t,
  type Words,
} from './translate';

export const LANGUAGES = { en: 'English', fr: 'Français' } as const;
export type Language = keyof typeof LANGUAGES;

const KEY = 'heatwalk.language';

/** That of the address (`?lang=fr`), else the one chosen before, else that of the browser. Tests have English. */
export let language: Language = 'en';

// Whatever imports this waits for it.
if (typeof document !== 'undefined') await use(preferred());

async function use(chosen: Language): Promise<void> {
  if (chosen === 'fr') {
    const [{ FRENCH, REPORTS }, { retelling }] = await Promise.all([import('./fr'), import('./retelling')]);
    speak(chosen, FRENCH, retelling(REPORTS));
  } else speak(chosen);
  language = chosen;
  document.documentElement.lang = chosen;
}

/** Phrases are in this language from then on. Where storage is disabled, the address holds the choice. */
export async function choose(chosen: Language): Promise<void> {
  await use(chosen);
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
