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

/** Agents of a worker, for the one after it. */
export interface KeptAgents {
  /** Of the group. */
  number: number;
  /** As `Agents.state` of the module has it. */
  state: Float64Array;
  /** With which arguments methods were called last that say what agents do from then on. */
  told: { lead_agents?: unknown[]; set_obstacles?: unknown[] };
}

/** The question that is answered with all agents, as `KeptAgents[]`. */
export const KEEP_AGENTS = 'keep_agents';

/** A question to a worker: a method of the module's mesh with its arguments. */
export interface Question {
  id: number;
  method: string;
  args: unknown[];
  /** The group of agents that it is about. */
  agents?: number | undefined;
  /** With the first question: what mesh to make before it is answered, and the agents on it. */
  opening?: { modules: Modules; mesh: Opening; agents: readonly KeptAgents[] };
}

/** What a worker tells of a question. */
export type Told =
  | { id: number; value: unknown }
  | { id: number; fraction: number; stage: string }
  | { id: number; code: string; message: string; isFatal: boolean };
