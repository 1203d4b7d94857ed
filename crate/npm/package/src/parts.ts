import { HeatwalkError } from './errors.ts';
import type { Modules } from './messages.ts';
import { type Packed, unpack } from './packed.ts';

/** Where the parts of the package are. */
export interface Parts {
  solver(): Promise<Packed>;
  reader(): Promise<Packed>;
  /** Of the worker: those after the first are taken where the ones before cannot be loaded. */
  scripts: (() => Promise<URL>)[];
}

let parts: Parts | undefined;

/** Says where the parts are, once. */
export function provide(given: Parts) {
  parts = given;
}

export const scripts = () => parts?.scripts ?? [];

const solver = onDemand(() => parts?.solver());
const reader = onDemand(() => parts?.reader());

/** Both modules, or the one that answers questions alone. */
export async function modules(withReader: boolean): Promise<Modules> {
  if (!withReader) return { solver: await solver() };
  const both = await Promise.all([solver(), reader()]);
  return { solver: both[0], reader: both[1] };
}

/** A module that is compiled once; after a failure the next one to ask tries again. */
function onDemand(load: () => Promise<Packed> | undefined): () => Promise<WebAssembly.Module> {
  let loading: Promise<WebAssembly.Module> | undefined;
  const compiled = async () => {
    try {
      return await unpack((await load()) ?? '');
    } catch (error) {
      loading = undefined;
      const reason = error instanceof Error ? error.message : String(error);
      throw new HeatwalkError(`the solver cannot be loaded: ${reason}`, 'no-module');
    }
  };
  return () => (loading ??= compiled());
}
