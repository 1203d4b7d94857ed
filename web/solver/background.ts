/** Meshes in workers of their own, beside the scene on screen. */
import type { MeshInput } from '../protocol';
import { LEVEL } from '../state/ground';
import { WHOLE } from '../state/inside';
import { DEFAULT_WINDOWS } from '../wasm/contract';
import { SolverClient, type Wanted } from './client';
import type { Engine, Question } from './engine';

/** Of a mesh as it lies in its file, on level ground. */
export const PLAIN_QUESTION: Omit<Question, 'parameters' | 'sources'> = {
  method: 'heat',
  windows: DEFAULT_WINDOWS,
  bridge: 'off',
  links: 0,
  ground: LEVEL,
  moment: null,
  inside: WHOLE,
  from: null,
  pathKind: 'descent',
  quick: false,
  refines: true,
};

/** Opens a mesh for as long as it is asked; its worker ends with that, and when `signal` is aborted, with a rejection. */
export async function inBackground<T>(
  load: () => Promise<MeshInput>,
  wanted: Wanted,
  signal: AbortSignal,
  ask: (engine: Engine) => Promise<T>,
): Promise<T> {
  signal.throwIfAborted();
  const client = new SolverClient();
  let engine: Engine | null = null;
  const end = () => {
    client.cancel();
    engine?.dispose();
  };
  signal.addEventListener('abort', end);
  try {
    engine = await client.open(load, wanted, () => undefined);
    signal.throwIfAborted();
    return await ask(engine);
  } finally {
    signal.removeEventListener('abort', end);
    end();
  }
}
