/** Buffers of messages, which are handed over instead of being copied. */
import { transfer } from 'comlink';

/** A message that takes every buffer and image that is in it along. */
export function handedOver<T>(message: T): T {
  const found = new Set<Transferable>();
  collect(message, found);
  return found.size > 0 ? transfer(message, [...found]) : message;
}

function collect(value: unknown, found: Set<Transferable>): void {
  if (typeof value !== 'object' || value === null) return;
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (Array.isArray(value)) for (const part of value) collect(part, found);
  else if (Object.getPrototypeOf(value) === Object.prototype) collect(Object.values(value), found);
  else if (value instanceof ImageBitmap) found.add(value);
}
