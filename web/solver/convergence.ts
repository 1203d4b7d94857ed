/** Errors of both methods on a surface and on those that its triangles are split into, each in a worker of its own. */
import type { FieldError } from '../protocol';
import { type Level, levelsOf, split, type Studied } from '../state/convergence';
import type { Settings } from '../state/settings';
import { AUTOMATIC, type Method } from '../wasm/contract';
import { inBackground, PLAIN_QUESTION } from './background';
import type { Wanted } from './client';
import type { Engine } from './engine';
import { Cancelled } from './remote';

/** By which methods, and by which settings of these. */
type By = Pick<Settings, 'windows' | 'parameters'>;

/**
 * Measures one surface after the other; `begun` is called before each, `measured` after it. Ends with a rejection where `signal` is aborted, or
 * where one cannot be measured.
 */
export async function measureConvergence(
  surface: Studied,
  by: By,
  signal: AbortSignal,
  begun: (done: number, triangles: number) => void,
  measured: (level: Level) => void,
): Promise<void> {
  let each = surface;
  const levels = levelsOf(surface.triangles.length / 3);
  for (let done = 0; done < levels; done++) {
    if (done > 0) each = split(each);
    begun(done, each.triangles.length / 3);
    measured(await measure(each, by, signal));
  }
}

function measure({ positions, triangles, sources }: Studied, by: By, signal: AbortSignal): Promise<Level> {
  const { windows } = by;
  // The exact region reaches a number of edges far, so that it would be another share of each surface.
  const parameters = { ...by.parameters, exactRadius: 0 };
  const load = () =>
    Promise.resolve({ kind: 'arrays', name: '', positions: positions.slice(), triangles: triangles.slice() } as const);
  const budget = { windows, memory: AUTOMATIC } as const;
  const wanted: Wanted = { parts: [], parameters, budget, up: 'y', triangles: null, fill: null };
  return inBackground(load, wanted, signal, async (engine) => {
    const errorBy = (method: Method) => errorOf(engine, { ...PLAIN_QUESTION, windows, parameters, method, sources });
    const [heat, propagation] = [await errorBy('heat'), await errorBy('propagation')];
    return { triangles: triangles.length / 3, edge: engine.opened.meanEdge, heat, propagation };
  });
}

/** Of a field, against the exact one that it is refined to. */
async function errorOf(engine: Engine, question: Parameters<Engine['ask']>[0]): Promise<FieldError> {
  let answer = await engine.ask(question);
  while (answer?.field && answer.field.exactBelow < Infinity) answer = await engine.refine(answer);
  if (!answer?.field) throw new Cancelled();
  // What was exact from the beginning has nothing to compare with.
  return answer.field.error ?? { mean: 0, max: 0 };
}
