/** The ways in which a wasm module can end. */
import { OUT_OF_MEMORY, TOO_LARGE, TRAP } from '../wasm/contract';

/** Whether a wasm module trapped, out of memory or by a defect: it must not be called again. */
export function isTrap(error: Error): boolean {
  return error.name === TRAP || error instanceof RangeError;
}

/** Whether a call failed for want of memory, by a refusal or by a trap. */
export function isOutOfMemory(error: Error): boolean {
  if (error.name === OUT_OF_MEMORY || error.name === TOO_LARGE) return true;
  // The solver's panics say what broke; an allocation that fails traps without a message.
  return isTrap(error) && /memory|allocation|unreachable|invalid (typed )?array length/i.test(error.message);
}
