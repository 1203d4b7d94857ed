import { expect, test } from '@playwright/test';
import type { DistanceField, Factoring, Moment, OpenedMesh, Solved, Source, PathRequest } from '../../web/protocol';
import { Engine, type Question } from '../../web/solver/engine';
import type { SolverWorker } from '../../web/solver/remote';
import { LEVEL } from '../../web/state/ground';
import { WHOLE } from '../../web/state/inside';
import { DEFAULT_PARAMETERS } from '../../web/wasm/contract';

const solved = (refineMs: number) => ({ field: { refineMs } as DistanceField, inside: null, path: null, pathMs: 0 });
const QUESTION: Question = {
  sources: [{ vertex: 0 }],
  method: 'heat',
  windows: 2,
  parameters: DEFAULT_PARAMETERS,
  bridge: 'auto',
  moment: null,
  links: 0,
  ground: LEVEL,
  inside: WHOLE,
  from: { vertex: 1 },
  pathKind: 'descent',
  quick: false,
  refines: true,
};

/** An engine whose worker notes its calls; a slice lasts until it is let go. */
function engine(components = 1, others: object = {}): { engine: Engine; calls: string[]; letGo: () => void } {
  const calls: string[] = [];
  const slices: (() => void)[] = [];
  const api = {
    configure: async () => calls.push('configure'),
    solve: async (_: Source[], quick: boolean, request: PathRequest | null) => {
      calls.push(['solve', ...(quick ? ['quick'] : []), ...kinds(request)].join(' '));
      return solved(0);
    },
    propagate: async (_: Source[], windows: number, quick: boolean, request: PathRequest | null) => {
      calls.push(['propagate', windows, ...(quick ? ['quick'] : []), ...kinds(request)].join(' '));
      return solved(0);
    },
    bridge: async (rule: string, links: number, posed: boolean) => {
      calls.push(`bridge ${rule} ${links}${posed ? ' posed' : ''}`);
      return {};
    },
    pose: async (moment: Moment | null) => {
      calls.push(moment ? `pose ${moment.seconds}` : 'pose of the file');
      return null;
    },
    refine: (request: PathRequest | null) => {
      calls.push(['refine', ...kinds(request)].join(' '));
      return new Promise<Solved>((resolve) => slices.push(() => resolve(solved(1))));
    },
    searchPath: async () => {
      calls.push('search');
      return calls.filter((call) => call === 'search').length < 3 ? null : { path: null, pathMs: 0 };
    },
    measure: async () => {
      calls.push('measure');
      return null;
    },
    path: async (request: PathRequest) => {
      calls.push(`path ${request.kind}`);
      return { path: null, pathMs: 0 };
    },
    ...others,
  };
  const worker = { api, call: <T>(answer: Promise<T>) => answer } as unknown as SolverWorker;
  const made = new Engine(
    worker,
    { interior: null, report: { components } } as OpenedMesh,
    {} as Factoring,
    DEFAULT_PARAMETERS,
  );
  return { engine: made, calls, letGo: () => slices.shift()?.() };
}

/** One that has answered, and refines that. */
async function refining(question: Parameters<Engine['ask']>[0]) {
  const made = engine();
  const answer = await made.engine.ask(question);
  if (!answer) throw new Error('no answer');
  const refined = made.engine.refine(answer);
  await soon();
  return { ...made, answer, refined };
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

test('components are joined before the first question, and again only by another rule or number of links', async () => {
  const { engine: it, calls } = engine(2);
  // What does not join components still counts them.
  await it.ask({ ...QUESTION, bridge: 'off' });
  await it.ask(QUESTION);
  await it.ask({ ...QUESTION, sources: [{ vertex: 3 }] });
  await it.ask({ ...QUESTION, bridge: 0.5 });
  await it.ask({ ...QUESTION, bridge: 'off' });
  await it.ask({ ...QUESTION, bridge: 'off', links: 2 });
  expect(calls).toEqual([
    'bridge off 0',
    'solve descent',
    'bridge auto 0',
    'solve descent',
    'solve descent',
    'bridge 0.5 0',
    'solve descent',
    'bridge off 0',
    'solve descent',
    'bridge off 2',
    'solve descent',
  ]);
});

test('parts are joined anew in the pose in which the mesh stands still, and in none that it passes', async () => {
  const { engine: it, calls } = engine(2);
  const at = (seconds: number) => ({ ...QUESTION, from: null, moment: { clip: 0, seconds } });
  await it.ask({ ...QUESTION, from: null });
  await it.ask({ ...at(1), quick: true });
  await it.ask({ ...at(2), quick: true });
  await it.ask(at(2));
  await it.ask({ ...at(2), sources: [{ vertex: 3 }] });
  await it.ask({ ...QUESTION, from: null, quick: true });
  expect(calls).toEqual([
    'bridge auto 0',
    'solve',
    'pose 1',
    'solve quick',
    'pose 2',
    'solve quick',
    'bridge auto 0 posed',
    'solve',
    'solve',
    // The pose that is shown stays.
    'pose 2',
    'bridge auto 0',
    'solve quick',
  ]);
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

test('methods other than heat propagate windows, one while the pointer drags, and need no factors', async () => {
  const { engine: it, calls } = engine();
  const auto: Question = { ...QUESTION, method: 'auto', windows: 4 };
  await it.ask({ ...auto, from: null, quick: true });
  const full = await it.ask(auto);
  // The others are refined differently, but begin with the same field.
  expect((await it.ask({ ...auto, method: 'exact' }))?.field).toBe(full?.field);
  await it.ask({ ...auto, parameters: { ...DEFAULT_PARAMETERS, timeStep: 2 } });
  await it.ask({ ...auto, windows: 8 });
  await it.ask({ ...auto, method: 'heat' });
  expect(calls).toEqual([
    'propagate 1 quick',
    'propagate 4 descent',
    'path descent',
    'path descent',
    'propagate 8 descent',
    'solve descent',
  ]);
});

test('a field that was refined is solved anew where refinement is not wanted any more', async () => {
  const { engine: it, calls, letGo, refined } = await refining(QUESTION);
  letGo();
  expect((await refined)?.field?.refineMs).toBe(1);
  expect((await it.ask({ ...QUESTION, refines: false }))?.field?.refineMs).toBe(0);
  // It is the method's own, which refinement may go on from.
  await it.ask({ ...QUESTION, refines: true });
  expect(calls).toEqual(['solve descent', 'refine descent', 'solve descent', 'path descent']);
});

test('propagation shows windows where another method has refined them', async () => {
  const { engine: it, calls, letGo, refined } = await refining({ ...QUESTION, method: 'auto' });
  letGo();
  expect((await refined)?.field?.refineMs).toBe(1);
  expect((await it.ask({ ...QUESTION, method: 'exact' }))?.field?.refineMs).toBe(1);
  expect((await it.ask({ ...QUESTION, method: 'propagation', refines: false }))?.field?.refineMs).toBe(0);
  expect(calls.filter((call) => call.startsWith('propagate'))).toHaveLength(2);
});

test('a straightened path replaces the exact one until that is traced', async () => {
  const { engine: it, calls } = engine();
  const answer = await it.ask({ ...QUESTION, pathKind: 'exact' });
  expect(answer?.pathKind).toBe('straight');
  if (!answer) throw new Error('no answer');
  // Twice it is not found yet.
  for (let step = 0; step < 2; step++) expect(await it.traceExactly(answer)).toBe(answer);
  expect((await it.traceExactly(answer))?.pathKind).toBe('exact');
  expect(calls).toEqual(['solve straight', 'search', 'search', 'search']);
});

test('a question during a refinement step discards its result and comes next', async () => {
  const { engine: it, calls, letGo, answer, refined } = await refining(QUESTION);
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

test('measuring waits for questions and for the step of refinement under way, and neither is lost', async () => {
  const { engine: it, calls, letGo } = engine();
  const asked = it.ask(QUESTION);
  const measured = it.inTurn.measure({ vertex: 1 }, { vertex: 2 });
  const answer = await asked;
  await measured;
  expect(calls).toEqual(['solve descent', 'measure']);
  if (!answer) throw new Error('no answer');
  const refined = it.refine(answer);
  const again = it.inTurn.measure({ vertex: 1 }, { vertex: 2 });
  const next = it.refine(answer);
  await soon();
  expect(calls.slice(2)).toEqual(['refine descent']);
  letGo();
  await again;
  await soon();
  letGo();
  expect(await refined).not.toBeNull();
  expect(await next).not.toBeNull();
  expect(calls.slice(2)).toEqual(['refine descent', 'measure', 'refine descent']);
});

/** A worker whose fields last until they are let go, each with what the worker answers. */
function slowly(): { engine: Engine; calls: string[]; fields: ((answer: Solved | null) => void)[] } {
  const fields: ((answer: Solved | null) => void)[] = [];
  const { engine: it, calls } = engine(1, {
    propagate: ([source]: Source[], _: number, quick: boolean) => {
      calls.push(`${quick ? 'quick' : 'full'} from ${source && 'vertex' in source ? source.vertex : '?'}`);
      return new Promise<Solved | null>((resolve) => fields.push(resolve));
    },
    ground: async () => calls.push('ground'),
  });
  return { engine: it, calls, fields };
}

const dragged = (vertex: number): Question => ({
  ...QUESTION,
  method: 'auto',
  from: null,
  quick: true,
  sources: [{ vertex }],
});

test('moves of a drag wait at the worker, and one that it passes over answers nothing', async () => {
  const { engine: it, calls, fields } = slowly();
  const answers = [1, 2, 3].map((vertex) => it.ask(dragged(vertex)));
  await soon();
  expect(calls).toEqual(['quick from 1', 'quick from 2', 'quick from 3']);
  const [first, last] = [solved(0), solved(0)];
  fields[0]?.(first);
  fields[1]?.(null);
  fields[2]?.(last);
  expect((await answers[0])?.field).toBe(first.field);
  expect(await answers[1]).toBeNull();
  expect((await answers[2])?.question.sources).toEqual([{ vertex: 3 }]);
  // The worker holds the last one.
  const again = await it.ask({ ...dragged(3), sources: (await answers[2])?.question.sources ?? [] });
  expect(again?.field).toBe(last.field);
});

test('what is no move waits until the moves of a drag have ended', async () => {
  const { engine: it, calls, fields } = slowly();
  const moves = [1, 2].map((vertex) => it.ask(dragged(vertex)));
  const still = it.ask({ ...dragged(3), quick: false });
  fields[0]?.(solved(0));
  await soon();
  expect(calls).toEqual(['quick from 1', 'quick from 2']);
  // Nor is it lost where another move comes; but that comes later.
  const painted = { ...LEVEL, slope: true };
  const other = it.ask({ ...dragged(4), ground: painted });
  expect(await still).toBeNull();
  fields[1]?.(solved(0));
  await Promise.all(moves);
  await soon();
  expect(calls.slice(2)).toEqual(['ground', 'quick from 4']);
  fields[2]?.(solved(0));
  expect((await other)?.question.ground).toBe(painted);
});

const TAKEN = dragged(1);
for (const [what, before, after] of [
  ['a drag that begins while the field of a click is under way', { ...TAKEN, quick: false }, dragged(2)],
  ['a click while the pointer drags', TAKEN, { ...dragged(2), quick: false }],
  ['the last source taken away', TAKEN, { ...TAKEN, sources: [] }],
  ['a path of another kind', TAKEN, { ...dragged(2), pathKind: 'straight' }],
  ['another cut through the inside', TAKEN, { ...dragged(2), inside: { ...WHOLE } }],
  ['another method, which refines the same field otherwise', TAKEN, { ...dragged(2), method: 'exact' }],
] as const) {
  test(`no move of a drag is ${what}`, async () => {
    const { engine: it, calls, fields } = slowly();
    const first = it.ask(before);
    const next = it.ask(after);
    await soon();
    expect(calls).toHaveLength(1);
    fields[0]?.(solved(0));
    await first;
    await soon();
    fields[1]?.(solved(0));
    expect(await next).not.toBeNull();
  });
}

test('a move that fails rejects, and the next question is asked', async () => {
  const { engine: it, calls, fields } = slowly();
  const first = it.ask(dragged(1));
  const broken = it.ask(dragged(2));
  fields[0]?.(solved(0));
  fields[1]?.(Promise.reject(new Error('no field')) as unknown as Solved);
  await first;
  await expect(broken).rejects.toThrow('no field');
  const next = it.ask(dragged(3));
  await soon();
  fields[2]?.(solved(0));
  expect(await next).not.toBeNull();
  expect(calls).toHaveLength(3);
});
