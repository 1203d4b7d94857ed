/** Whether a wasm module trapped, out of memory or by a defect: it must not be called again. */
export function isTrap(error: Error): boolean {
  return error.name === 'RuntimeError' || error instanceof RangeError;
}
