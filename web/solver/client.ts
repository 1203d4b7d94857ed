/**
 * The client of the solver's workers. Every mesh gets a worker of its own: wasm memory never shrinks, so a fresh one is the
 * only way to give it back, and while a mesh is being opened the one before stays whole and in use. Cancelling an opening
 * terminates its worker and touches nothing else.
 */
import { proxy } from 'comlink';
import type { DrawMesh, MeshInput, OpenedMesh, Parameters, ProgressListener, MemoryBudget } from '../protocol';
import type { AUTOMATIC, Up } from '../wasm/contract';
import wasmAddress from '../wasm/solver/heatwalk_worker_bg.wasm?url';
import { Engine } from './engine';
import { Cancelled, SolverWorker } from './remote';
import { handedOver } from './transfer';

/** What is to be done with a mesh. */
export interface Wanted {
  /** Indices of the parts to walk on, empty for all. */
  parts: readonly number[];
  /** Of the heat method; with null, nothing is factored. */
  parameters: Parameters | null;
  budget: MemoryBudget;
  up: Up | typeof AUTOMATIC;
  /** What a mesh of more triangles is simplified to; null: nothing is. */
  triangles: number | null;
  /** What the surface encloses is filled with about this number of tetrahedra; null: with none. */
  fill: number | null;
}

/** Coarse surfaces have an edge that is drawn longer, where a model reaches from −1 to 1. */
const COARSE = 0.5;
/** The most triangles that are divided. */
const MOST_DIVIDED = 20_000;
/** More points are so dense that the surface that joins them is drawn. */
const MOST_DISCS = 100_000;

export class SolverClient {
  #spare: SolverWorker | null = null;
  #opening: SolverWorker | null = null;

  constructor() {
    // The module is on its way while the page is still being built.
    void compiled().catch(() => undefined);
  }

  /**
   * `load` gives the input anew for each opening, because its buffers are handed over to the worker. `built` gets the
   * mesh while the worker goes on; where it throws, the opening ends.
   */
  async open(
    load: () => Promise<MeshInput>,
    { parts, parameters, budget, up, triangles, fill }: Wanted,
    progress: ProgressListener,
    built: (opened: OpenedMesh) => void = () => undefined,
  ): Promise<Engine> {
    this.cancel();
    const worker = this.#spare ?? new SolverWorker(compiled());
    this.#spare = null;
    this.#opening = worker;
    try {
      const input = handedOver(await worker.during(load()));
      const opened = await worker.api.open(input, [...parts], budget, proxy(progress), up, triangles, fill);
      const { isCloud, clips, report, inputVertices } = opened;
      if (isCloud && clips.length === 0 && report.vertices <= MOST_DISCS) {
        opened.surface.discs = (await import('./discs')).discsOf(opened.surface, inputVertices);
      } else if (!opened.interior && isCoarse(opened.surface)) {
        const { finer, places } = (await import('./finer')).divided(opened.surface);
        opened.surface.finer = finer;
        await worker.api.drawBetween(handedOver(places));
      }
      const preparing = worker.api.prepare(parameters, proxy(progress));
      const telling = (async () => built(opened))();
      const [factoring] = await Promise.all([preparing, telling]);
      return new Engine(worker, opened, factoring, parameters);
    } catch (error) {
      worker.end(new Cancelled());
      throw error;
    } finally {
      if (this.#opening === worker) this.#opening = null;
    }
  }

  /** Ends the opening that is under way, if any; it rejects with `Cancelled`. */
  cancel(): void {
    this.#opening?.end(new Cancelled());
    this.#opening = null;
  }

  /** Starts the worker of the next mesh ahead of time; to be called when the page is idle. */
  warmUp(): void {
    if (this.#spare) return;
    const spare = new SolverWorker(compiled());
    this.#spare = spare;
    // The worker that opens the next mesh says what is wrong, should it be wrong again.
    const forget = () => {
      spare.end(new Cancelled());
      if (this.#spare === spare) this.#spare = null;
    };
    void spare.lost.then(forget);
    spare.api.warmUp().catch(forget);
  }
}

/** Whether some of not so many triangles have an edge so long that stripes on it would be seen to be chords. */
function isCoarse({ positions, triangles }: DrawMesh): boolean {
  if (triangles.length > 3 * MOST_DIVIDED) return false;
  const at = (corner: number, axis: number) => positions[3 * (triangles[corner] ?? 0) + axis] ?? 0;
  return triangles.some((_, i) => {
    const next = i % 3 < 2 ? i + 1 : i - 2;
    return Math.hypot(...[0, 1, 2].map((axis) => at(next, axis) - at(i, axis))) > COARSE;
  });
}

/** All workers share one, and with it the code that the browser has optimised so far. */
let module: Promise<WebAssembly.Module> | null = null;

function compiled(): Promise<WebAssembly.Module> {
  module ??= compile().catch((error: unknown) => {
    // The next opening tries again.
    module = null;
    throw error;
  });
  return module;
}

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(wasmAddress);
  // Compiling while it arrives needs the right type, which not every static host gives.
  return response.headers.get('Content-Type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}
