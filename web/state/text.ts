/** How numbers and bytes are written in a link. */
import { deflateSync, Inflate } from 'fflate';
import { AUTOMATIC, type Choice } from '../wasm/contract';

/** What may be unpacked. */
const MOST_BYTES = 2 ** 23;
/** Text that is unpacked at once: bytes are at most a thousand times as many. */
const SLICE = 1024;

/** Six digits, whatever the file's unit is; a plus sign would read as a space. */
export function amount(value: number): string {
  return String(Number(value.toPrecision(6))).replace('+', '');
}

/** A number as `amount` writes it, not negative; null for other text. */
export function parseAmount(text: string): number | null {
  return /^\d[\d.]*(e-?\d+)?$/.test(text) && Number.isFinite(Number(text)) ? Number(text) : null;
}

export function number(value: number): string {
  return String(Number(value.toFixed(4)));
}

export function option(value: number | typeof AUTOMATIC): string {
  return value === AUTOMATIC ? value : number(value);
}

export function flag(value: boolean): string {
  return value ? '1' : '0';
}

export function oneOf<T extends string>(words: readonly T[]): (text: string) => T | null {
  return (text) => words.find((word) => word === text) ?? null;
}

/** Links of before hold former names. */
export function choiceOf<T extends string>({ names, former }: Choice<T>): (text: string) => T | null {
  const named = oneOf(names);
  return (text) => named(text) ?? (Object.hasOwn(former, text) ? former[text] : null);
}

export function automaticOr<T>(parse: (text: string) => T | null): (text: string) => T | typeof AUTOMATIC | null {
  return (text) => (text === AUTOMATIC ? text : parse(text));
}

export function within(low: number, high: number): (text: string) => number | null {
  return (text) => {
    const value = Number(text);
    return text.trim() !== '' && value >= low && value <= high ? value : null;
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
