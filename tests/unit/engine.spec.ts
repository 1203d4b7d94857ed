import { expect, test } from '@playwright/test';
import { Engine, type Question } from '../../web/engine';
import type { DistanceField, OpenedMesh } from '../../web/protocol';
import { DEFAULT_PARAMETERS } from '../../web/scene';
import type { SolverWorker } from '../../web/solver-worker';

const field = (refineMs: number) => ({ refineMs }) as DistanceField;
const QUESTION: Question = {
  sources: [{ vertex: 0 }],
  parameters: DEFAULT_PARAMETERS,
  from: { vertex: 1 },
  way: 'descent',
};

/** An engine whose worker notes its calls; a slice lasts until it is let go. */
function engine(): { engine: Engine; calls: string[]; letGo: () => void } {
  const calls: string[] = [];
  const slices: (() => void)[] = [];
  const api = {
    configure: async () => calls.push('configure'),
    solve: async () => {
      calls.push('solve');
      return field(0);
    },
    refine: () => {
      calls.push('refine');
      return new Promise<DistanceField>((resolve) => slices.push(() => resolve(field(1))));
    },
    path: async (_: unknown, kind: string) => {
      calls.push(`path ${kind}`);
      return { length: 1 };
    },
  };
  const worker = { api, call: <T>(answer: Promise<T>) => answer } as unknown as SolverWorker;
  const made = new Engine(worker, {} as OpenedMesh, DEFAULT_PARAMETERS);
  return { engine: made, calls, letGo: () => slices.shift()?.() };
}

const soon = () => new Promise((resolve) => setTimeout(resolve, 5));

test('another way home over the same field is not solved again', async () => {
  const { engine: it, calls } = engine();
  const first = await it.ask(QUESTION);
  const second = await it.ask({ ...QUESTION, from: { vertex: 2 }, way: 'straight' });
  expect(calls).toEqual(['solve', 'path descent', 'path straight']);
  expect(second?.field).toBe(first?.field);
  await it.ask({ ...QUESTION, parameters: { ...DEFAULT_PARAMETERS, timeFactor: 2 } });
  expect(calls.slice(3)).toEqual(['configure', 'solve', 'path descent']);
});

test('a straightened way stands in for the exact one until that is asked for', async () => {
  const { engine: it, calls } = engine();
  const answer = await it.ask({ ...QUESTION, way: 'exact' });
  expect(answer?.pathKind).toBe('straight');
  const traced = answer && (await it.traceExactly(answer));
  expect(traced?.pathKind).toBe('exact');
  expect(calls).toEqual(['solve', 'path straight', 'path exact']);
});

test('a question during a slice makes its result worthless and comes next', async () => {
  const { engine: it, calls, letGo } = engine();
  const answer = await it.ask(QUESTION);
  if (!answer) throw new Error('no answer');
  const refined = it.refine(answer);
  await soon();
  const next = it.ask({ ...QUESTION, sources: [{ vertex: 5 }] });
  letGo();
  expect(await refined).toBeNull();
  expect((await next)?.field?.refineMs).toBe(0);
  expect(calls).toEqual(['solve', 'path descent', 'refine', 'solve', 'path descent']);
  // What was refined before is no more.
  expect(await it.refine(answer)).toBeNull();
});

test('a slice waits for one that is still under way', async () => {
  const { engine: it, calls, letGo } = engine();
  const answer = await it.ask(QUESTION);
  if (!answer) throw new Error('no answer');
  const first = it.refine(answer);
  const second = it.refine(answer);
  await soon();
  expect(calls.filter((call) => call === 'refine')).toHaveLength(1);
  letGo();
  expect((await first)?.field?.refineMs).toBe(1);
  await soon();
  letGo();
  expect((await second)?.field?.refineMs).toBe(1);
});
