/** What a mesh is made of. */
export type Opening = (
  | { positions: Float64Array; indices: Uint32Array }
  | { name: string; bytes: Uint8Array; resources: Readonly<Record<string, Uint8Array>> }
) & { options: object; isSingle: boolean };

/** The wasm modules: what answers questions, and what reads files where there is one. */
export interface Modules {
  solver: WebAssembly.Module;
  reader?: WebAssembly.Module;
}

/** A question to a worker: a method of the module's mesh with its arguments. */
export interface Question {
  id: number;
  method: string;
  args: unknown[];
  /** The group of agents that it is about. */
  agents?: number | undefined;
  /** With the first question: what mesh to make before it is answered. */
  opening?: { modules: Modules; mesh: Opening };
}

/** What a worker tells of a question. */
export type Told =
  | { id: number; value: unknown }
  | { id: number; fraction: number; stage: string }
  | { id: number; code: string; message: string; isFatal: boolean };
