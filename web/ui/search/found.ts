/** Which entries of the search have what is typed. */

export interface Entry {
  /** What it does or sets. */
  name: string;
  /** Where it is, or which key it has. */
  place: string;
  /** What is said of it, which is searched too. */
  line: string;
}

/** Letters without case and accents. */
function plain(text: string): string {
  return text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
}

/** How well an entry answers: the less, the better; null if a word is missing. */
function rank({ name, place, line }: Entry, words: readonly string[]): number | null {
  const [own, whole] = [plain(name), plain(`${name} ${place} ${line}`)];
  if (!words.every((word) => whole.includes(word))) return null;
  if (words.every((word) => own.startsWith(word))) return 0;
  if (words.every((word) => own.split(/\s+/).some((each) => each.startsWith(word)))) return 1;
  return words.every((word) => own.includes(word)) ? 2 : 3;
}

/** Those that have each word of the text, the best answers first; all for no words. */
export function found<E extends Entry>(entries: readonly E[], text: string): E[] {
  const words = plain(text).split(/\s+/).filter(Boolean);
  return entries
    .map((entry) => ({ entry, rank: rank(entry, words) }))
    .filter((one): one is { entry: E; rank: number } => one.rank !== null)
    .toSorted((a, b) => a.rank - b.rank)
    .map(({ entry }) => entry);
}
