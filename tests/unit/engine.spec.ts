import { expect, test } from '@playwright/test';
import type { DistanceField, OpenedMesh, Solved, Source, PathRequest } from '../../web/protocol';
import { Engine, type Question } from '../../web/solver/engine';
import type { SolverWorker } from '../../web/solver/remote';
import { DEFAULT_PARAMETERS } from '../../web/wasm/contract';

const solved = (refineMs: number) => ({ field: { refineMs } as DistanceField, path: null, pathMs: 0 });
const QUESTION: Question = {
  sources: [{ vertex: 0 }],
  parameters: DEFAULT_PARAMETERS,
  from: { vertex: 1 },
  pathKind: 'descent',
  quick: false,
};

/** An engine whose worker notes its calls; a slice lasts until it is let go. */
function engine(): { engine: Engine; calls: string[]; letGo: () => void } {
  const calls: string[] = [];
  const slices: (() => void)[] = [];
  const api = {
    configure: async () => calls.push('configure'),
    solve: async (_: Source[], quick: boolean, request: PathRequest | null) => {
      calls.push(['solve', ...(quick ? ['quick'] : []), ...kinds(request)].join(' '));
      return solved(0);
    },
    refine: (request: PathRequest | null) => {
      calls.push(['refine', ...kinds(request)].join(' '));
      return new Promise<Solved>((resolve) => slices.push(() => resolve(solved(1))));
    },
    path: async (request: PathRequest) => {
      calls.push(`path ${request.kind}`);
      return { path: null, pathMs: 0 };
    },
  };
  const worker = { api, call: <T>(answer: Promise<T>) => answer } as unknown as SolverWorker;
  const made = new Engine(worker, {} as OpenedMesh, DEFAULT_PARAMETERS);
  return { engine: made, calls, letGo: () => slices.shift()?.() };
}

const kinds = (request: PathRequest | null) => (request ? [request.kind] : []);
const soon = () => new Promise((resolve) => setTimeout(resolve, 5));

test('another path over the same field does not solve again', async () => {
  const { engine: it, calls } = engine();
  const first = await it.ask(QUESTION);
  const second = await it.ask({ ...QUESTION, from: { vertex: 2 }, pathKind: 'straight' });
  expect(calls).toEqual(['solve descent', 'path straight']);
  expect(second?.field).toBe(first?.field);
  await it.ask({ ...QUESTION, parameters: { ...DEFAULT_PARAMETERS, timeStep: 2 } });
  expect(calls.slice(2)).toEqual(['configure', 'solve descent']);
});

test('a quick field is solved again in full, a full one is kept', async () => {
  const { engine: it, calls } = engine();
  const quick = await it.ask({ ...QUESTION, from: null, quick: true });
  expect(quick?.path).toBeNull();
  const full = await it.ask(QUESTION);
  expect(full?.field).not.toBe(quick?.field);
  expect((await it.ask({ ...QUESTION, from: null, quick: true }))?.field).toBe(full?.field);
  expect(calls).toEqual(['solve quick', 'solve descent']);
});

test('a straightened path replaces the exact one until that is traced', async () => {
  const { engine: it, calls } = engine();
  const answer = await it.ask({ ...QUESTION, pathKind: 'exact' });
  expect(answer?.pathKind).toBe('straight');
  const traced = answer && (await it.traceExactly(answer));
  expect(traced?.pathKind).toBe('exact');
  expect(calls).toEqual(['solve straight', 'path exact']);
});

test('a question during a refinement step discards its result and comes next', async () => {
  const { engine: it, calls, letGo } = engine();
  const answer = await it.ask(QUESTION);
  if (!answer) throw new Error('no answer');
  const refined = it.refine(answer);
  await soon();
  const next = it.ask({ ...QUESTION, sources: [{ vertex: 5 }] });
  letGo();
  expect(await refined).toBeNull();
  expect((await next)?.field?.refineMs).toBe(0);
  expect(calls).toEqual(['solve descent', 'refine descent', 'solve descent']);
  // What was refined before is no more.
  expect(await it.refine(answer)).toBeNull();
});

test('a refinement step waits for one that is still running', async () => {
  const { engine: it, calls, letGo } = engine();
  const answer = await it.ask(QUESTION);
  if (!answer) throw new Error('no answer');
  const first = it.refine(answer);
  const second = it.refine(answer);
  await soon();
  expect(calls.filter((call) => call.startsWith('refine'))).toHaveLength(1);
  letGo();
  expect((await first)?.field?.refineMs).toBe(1);
  await soon();
  letGo();
  expect((await second)?.field?.refineMs).toBe(1);
});
