/** Sentences of workers, which are in English, in another language. Imports no code: that of the page waits for this one. */
import type { Retell, Texts } from './translate';

const PLACE = /\{\d\}/;
const PLACES = /\{(\d)\}/g;

/** One sentence, or a part of one, with places for values. */
interface Pattern {
  other: string;
  /** Its longest words without a value, which a sentence must have. */
  longest: string;
  /** Letters and signs besides the values. */
  size: number;
  /** What stands before the first value, and behind each. */
  parts: string[];
  /** Whether a value is in quotes or parentheses: words of a file or of a driver, which stay as they are. */
  isForeign: boolean[];
}

interface Reading {
  text: string;
  /** Letters and decimal points that stay as they are in English. */
  left: number;
}

/** Most ways to part a sentence that are tried: refusals take some hundreds, and what a graphics driver says may have thousands. */
const MOST_WAYS = 4000;

/**
 * What a sentence of a worker is in another language, and what is put into it. Several patterns fit many a sentence ("{0} does not
 * exist" also fits "GLB, accessor 3: it does not exist"): the one counts that leaves the least in English, of equal ones the shortest,
 * which is what stands around the others.
 */
export function retelling(reports: Texts): Retell {
  const patterns = Object.entries(reports)
    .filter(([english]) => PLACE.test(english))
    .map(([english, other]) => compiled(english, other))
    .toSorted((a, b) => b.size - a.size);
  const known = new Map(
    Object.entries(reports).map(([english, text]): [string, Reading] => [english, { text, left: 0 }]),
  );
  let ways = 0;
  const read = (sentence: string): Reading => {
    const before = known.get(sentence);
    if (before) return before;
    const english = unread(sentence);
    let best = english;
    for (const pattern of patterns) {
      for (const values of valuesIn(sentence, pattern)) {
        if (++ways > MOST_WAYS) break;
        const readings = values.map((value, index) => (pattern.isForeign[index] ? unread(value) : read(value)));
        const left = readings.reduce((sum, reading) => sum + reading.left, 0);
        if (left < english.left && left <= best.left) {
          const text = pattern.other.replaceAll(PLACES, (_, index) => readings[Number(index)]?.text ?? '');
          best = { text, left };
        }
      }
    }
    // What was not tried to the end may be more elsewhere.
    if (ways <= MOST_WAYS) known.set(sentence, best);
    return best;
  };
  return (sentence) => {
    ways = 0;
    return read(sentence).text;
  };
}

function unread(text: string): Reading {
  return { text, left: text.match(/[\p{L}.]/gu)?.length ?? 0 };
}

/** What a sentence may have in the places of a pattern: all ways to part it. */
function valuesIn(sentence: string, { longest, parts: [start = '', ...behind] }: Pattern): Iterable<string[]> {
  if (!sentence.includes(longest) || !sentence.startsWith(start)) return [];
  return parted(sentence.slice(start.length), behind);
}

function* parted(text: string, [literal = '', ...others]: string[]): Generator<string[]> {
  if (others.length === 0) {
    if (text.length > literal.length && text.endsWith(literal)) yield [text.slice(0, text.length - literal.length)];
    return;
  }
  for (let at = text.indexOf(literal, 1); at > 0; at = text.indexOf(literal, at + 1))
    for (const rest of parted(text.slice(at + literal.length), others)) yield [text.slice(0, at), ...rest];
}

function compiled(english: string, other: string): Pattern {
  const parts = english.split(PLACE);
  return {
    other,
    longest: parts.reduce((longest, part) => (part.length > longest.length ? part : longest)),
    size: parts.reduce((sum, part) => sum + part.length, 0),
    parts,
    isForeign: parts.slice(1).map((part, index) => /^["'`)]/.test(part) && /["'`(]$/.test(parts[index] ?? '')),
  };
}
