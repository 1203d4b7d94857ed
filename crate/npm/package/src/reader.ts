import type { Packed } from './packed.ts';

declare const PACKED_MODULE: Packed;

/** The wasm module of the reader. */
export default PACKED_MODULE;
