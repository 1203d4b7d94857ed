/** Table 1 of the report on this device: each model in a worker of its own, beside the scene on screen. */
import { Failure } from '../error';
import type { MeshInput, OpenedMesh, Parameters, MemoryBudget, Source } from '../protocol';
import { findPreset } from '../state/presets';
import { type ModelOfReport, REPORT, type Times } from '../state/report';
import { median, parametersOfReport, type Row } from '../state/table1';
import { AUTOMATIC } from '../wasm/contract';
import { inBackground, PLAIN_QUESTION } from './background';
import type { Wanted } from './client';
import type { Engine } from './engine';
import { entry } from '../state/entry';
import { t } from '../texts';

const BUDGET: MemoryBudget = { windows: 0, memory: AUTOMATIC };

/** Sources whose solves are timed; conjugate gradients take longer. */
const SOURCES = { cg: 3, cholesky: 9 } as const;

export interface TableProgress {
  /** How many models are done. */
  done: number;
  /** The model that is being measured. */
  title: string;
}

/**
 * Measures all models of the report, one after another; `begun` is called before each, `measured` after it. Ends with a rejection where
 * `signal` is aborted, or where a model cannot be measured.
 */
export async function measureTable(
  signal: AbortSignal,
  begun: (progress: TableProgress) => void,
  measured: (row: Row) => void,
): Promise<void> {
  // Browsers optimise code while it runs: the first factors of a page take several times as long as later ones.
  begun({ done: 0, title: REPORT[0].title });
  await measureModel(REPORT[0], signal);
  for (const [done, model] of REPORT.entries()) {
    begun({ done, title: model.title });
    measured(await measureModel(model, signal));
  }
}

function measureModel({ title, model, triangles }: ModelOfReport, signal: AbortSignal): Promise<Row> {
  const parameters = parametersOfReport('cg');
  const { load, parts } = modelOf(model);
  const wanted: Wanted = { parts, parameters, budget: BUDGET, up: AUTOMATIC, triangles, fill: null };
  return inBackground(load, wanted, signal, async (engine) => {
    const { opened } = engine;
    const iterated = await timesOf(engine, parameters, SOURCES.cg);
    const factored = await timesOf(engine, parametersOfReport('cholesky'), SOURCES.cholesky);
    return { title, triangles: opened.surface.triangles.length / 3, iterated, factored };
  });
}

async function timesOf(engine: Engine, parameters: Parameters, count: number): Promise<Times> {
  let precompute = 0;
  const solves: number[] = [];
  for (const source of sample(engine.opened, count)) {
    const answer = await engine.ask({ ...PLAIN_QUESTION, parameters, sources: [source] });
    if (!answer?.field) throw new Failure(t('The solver gave no distances.'));
    const { buildMs, precomputeMs } = answer.factoring.timings;
    precompute = buildMs + precomputeMs;
    solves.push(answer.field.solveMs);
  }
  return { precompute, solve: median(solves) };
}

function modelOf(model: ModelOfReport['model']): { load: () => Promise<MeshInput>; parts: readonly number[] } {
  if ('shape' in model) return { load: () => Promise.resolve({ kind: 'shape', shape: model.shape }), parts: [] };
  const preset = findPreset(model.preset);
  if (!preset) throw new Failure(t`There is no preset ${model.preset}.`);
  return { load: preset.load, parts: preset.start.parts };
}

/** So many vertices, evenly spread over the numbers of those that are drawn. */
function sample({ inputVertices }: OpenedMesh, count: number): Source[] {
  return Array.from({ length: count }, (_, index) => ({
    vertex: entry(inputVertices, Math.floor((index * inputVertices.length) / count)),
  }));
}
