/** How numbers and bytes are written in a link. */
import { deflateSync, Inflate } from 'fflate';
import { AUTOMATIC, type Choice } from '../wasm/contract';

/** What may be unpacked. */
const MOST_BYTES = 2 ** 23;
/** Text that is unpacked at once: bytes are at most a thousand times as many. */
const SLICE = 1024;

/** A value as text; undefined where text is no such value. */
export interface Codec<T> {
  encode(value: T): string;
  parse(text: string): T | undefined;
}

/** Six digits, whatever the file's unit is; a plus sign would read as a space. */
export function amount(value: number): string {
  return String(Number(value.toPrecision(6))).replace('+', '');
}

/** Twelve digits: what was measured or converted comes back as it was. */
export function precise(value: number): string {
  return String(Number(value.toPrecision(12))).replace('+', '');
}

/** A number as `amount` writes it, not negative; undefined for other text. */
export function parseAmount(text: string): number | undefined {
  return /^\d[\d.]*(e-?\d+)?$/.test(text) && Number.isFinite(Number(text)) ? Number(text) : undefined;
}

export const AMOUNT: Codec<number> = { encode: amount, parse: parseAmount };

export function number(value: number): string {
  return String(Number(value.toFixed(4)));
}

type Range = readonly [least: number, most: number];

export function within([least, most]: Range, encode = number): Codec<number> {
  const parse = (text: string) => {
    const value = Number(text);
    return text.trim() !== '' && value >= least && value <= most ? value : undefined;
  };
  return { encode, parse };
}

export function rounded(range: Range): Codec<number> {
  const { encode, parse } = within(range, String);
  return {
    encode,
    parse: (text) => {
      const value = parse(text);
      return value === undefined ? undefined : Math.round(value);
    },
  };
}

/** How many, or the index of something. */
export const COUNT: Codec<number> = {
  encode: String,
  parse: (text) => (/^\d{1,9}$/.test(text) ? Number(text) : undefined),
};

export const FLAG: Codec<boolean> = {
  encode: (value) => (value ? '1' : '0'),
  parse: (text) => [false, true].find((value) => FLAG.encode(value) === text),
};

export function oneOf<T extends string | number>(values: readonly T[]): Codec<T> {
  return { encode: String, parse: (text) => values.find((value) => String(value) === text) };
}

/** Links of before hold former names. */
export function choiceOf<T extends string>({ names, former }: Choice<T>): Codec<T> {
  const { encode, parse } = oneOf(names);
  return { encode, parse: (text) => parse(text) ?? (Object.hasOwn(former, text) ? former[text] : undefined) };
}

/** A value that has a word of its own, or what another codec takes. */
export function or<W, T>(word: string, value: W, { encode, parse }: Codec<T>): Codec<W | T> {
  return {
    encode: (wanted) => (wanted === value ? word : encode(wanted as T)),
    parse: (text) => (text === word ? value : parse(text)),
  };
}

export function automaticOr<T>(codec: Codec<T>): Codec<typeof AUTOMATIC | T> {
  return or(AUTOMATIC, AUTOMATIC, codec);
}

/** Items with commas between them; `none` where there are none. */
export function listOf<T>({ encode, parse }: Codec<T>, most: number, none = 'none'): Codec<readonly T[]> {
  return {
    encode: (items) => (items.length === 0 ? none : items.map(encode).join(',')),
    parse: (text) => {
      if (text === none) return [];
      const items = text.split(',', most + 1).map(parse);
      return items.length <= most && items.every((item) => item !== undefined) ? items : undefined;
    },
  };
}

/** Bytes by deflate in base64url. */
export function pack(bytes: Uint8Array): string {
  const packed = deflateSync(bytes, { level: 9 });
  const letters = Array.from(packed, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * The bytes that were packed.
 *
 * @throws for text that is none, and for more than 8 MiB.
 */
export function unpack(text: string): Uint8Array {
  const letters = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  const packed = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const bytes = new Uint8Array(MOST_BYTES);
  let size = 0;
  let ended = false;
  const inflate = new Inflate((chunk, final) => {
    // Throws where it is too large.
    bytes.set(chunk, size);
    size += chunk.length;
    ended ||= final;
  });
  for (let first = 0; first < packed.length; first += SLICE) {
    inflate.push(packed.subarray(first, first + SLICE), first + SLICE >= packed.length);
  }
  if (!ended) throw new RangeError('cut off');
  return bytes.slice(0, size);
}
