import { expect, test } from '@playwright/test';
import { OUT_OF_MEMORY, TOO_LARGE } from '../../web/wasm/contract';
import { isOutOfMemory } from '../../web/solver/trap';

const named = (name: string, message: string) => Object.assign(new Error(message), { name });

test('a refusal and a trap without a message count as out of memory', () => {
  expect(isOutOfMemory(named(OUT_OF_MEMORY, 'out of memory while ordering'))).toBe(true);
  expect(isOutOfMemory(named(TOO_LARGE, 'factoring takes 5.00 GiB of memory'))).toBe(true);
  for (const message of ['unreachable', 'unreachable executed', 'Unreachable code should not be executed']) {
    expect(isOutOfMemory(new WebAssembly.RuntimeError(message)), message).toBe(true);
  }
  expect(isOutOfMemory(new RangeError('Array buffer allocation failed'))).toBe(true);
});

test('a panic, a deep recursion and a solver error do not count as out of memory', () => {
  expect(isOutOfMemory(named('RuntimeError', 'panicked at crate/solver/src/csr.rs:9:5: index out of bounds'))).toBe(
    false,
  );
  expect(isOutOfMemory(new RangeError('Maximum call stack size exceeded'))).toBe(false);
  expect(isOutOfMemory(new WebAssembly.RuntimeError('integer divide by zero'))).toBe(false);
  expect(isOutOfMemory(new Error('vertex 3 has no memory of it'))).toBe(false);
});
