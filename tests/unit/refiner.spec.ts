import { expect, test } from '@playwright/test';
import { ofModel } from '../../web/length';
import type { DistanceField, PathKind, DrawPath } from '../../web/protocol';
import type { Answer, Engine } from '../../web/solver/engine';
import { type Phase, Refiner } from '../../web/solver/refiner';
import { WorkerLost } from '../../web/solver/remote';
import { emptyScene } from '../../web/state/scene';
import { Signal, until } from '../../web/state/signal';
import { OUT_OF_MEMORY } from '../../web/wasm/contract';

const STATE = emptyScene({ kind: 'preset', id: 'bunny' });
const PATH: DrawPath = {
  points: new Float32Array(),
  places: new Float64Array(),
  normals: new Float32Array(),
  drawnLength: 1,
  length: ofModel(2),
  straight: ofModel(2),
  cost: ofModel(2),
  segmentCosts: new Float32Array(),
};

function answer(exactBelow: number, pathKind: PathKind = 'descent'): Answer {
  const field: DistanceField = {
    distance: new Float32Array(),
    tangents: new Int8Array(),
    maxDistance: ofModel(1),
    byCorner: false,
    unreachableVertices: 0,
    exactBelow: ofModel(exactBelow),
    exactShare: 0,
    timeFactor: 1,
    windows: undefined,
    error: null,
    solveMs: 1,
    refineMs: 0,
    inner: null,
  };
  const question = {
    sources: [{ vertex: 0 }],
    method: 'heat' as const,
    windows: STATE.windows,
    parameters: STATE.parameters,
    bridge: STATE.bridge,
    moment: null,
    links: STATE.links,
    ground: STATE.ground,
    inside: STATE.inside,
    from: { vertex: 1 },
    pathKind,
    quick: false,
    refines: true,
  };
  const timings = { readMs: 0, buildMs: 0, drawMs: 0, joinMs: 0, precomputeMs: 0 };
  const joined = {
    groups: 0,
    contacts: 0,
    contactsComplete: true,
    crackPortals: 0,
    crackGap: ofModel(0),
    links: 0,
    linkedGap: ofModel(0),
  };
  const factoring = { timings, ...joined, factorNonzeros: 0, memoryBytes: 0 };
  return {
    question,
    posed: null,
    inside: null,
    field,
    path: PATH,
    pathKind: pathKind === 'exact' ? 'straight' : pathKind,
    pathMs: 0,
    factoring,
  };
}

/** An engine whose slices reach as far as told, the last one again and again; after `failing` of them each fails. */
function engine(
  reach: readonly number[],
  failing = Infinity,
  failure = new Error(),
): { engine: Engine; slices: () => number } {
  let slices = 0;
  const fake = {
    refine: async (before: Answer) => {
      if (slices === failing) throw failure;
      const exactBelow = reach[Math.min(slices, reach.length - 1)];
      slices += 1;
      return { ...before, ...answer(exactBelow, before.question.pathKind), pathKind: before.pathKind };
    },
    traceExactly: async (before: Answer) => ({ ...before, pathKind: 'exact' as const }),
  };
  return { engine: fake as unknown as Engine, slices: () => slices };
}

function refiner(isHidden = new Signal(false)): {
  refiner: Refiner;
  shown: Answer[];
  phases: Phase[];
  settled: () => Promise<void>;
} {
  const shown: Answer[] = [];
  const phases: Phase[] = [];
  const made = new Refiner(
    (better) => shown.push(better),
    (error) => {
      if (!(error instanceof WorkerLost)) throw error;
    },
    isHidden,
  );
  made.phase.watch((phase) => phases.push(phase));
  return { refiner: made, shown, phases, settled: () => until(() => made.settled, made.phase) };
}

const reached = (shown: readonly Answer[]) => shown.map(({ field }) => field?.exactBelow);

test('waits, refines step by step and ends when everything is exact', async () => {
  const { refiner: it, shown, phases, settled } = refiner();
  const fake = engine([0.2, 0.6, Infinity]);
  it.rest(fake.engine, answer(0), STATE);
  await settled();
  expect(phases).toEqual(['solving', 'resting', 'refining', 'exact']);
  expect(reached(shown)).toEqual([0.2, 0.6, Infinity]);
});

test('a field by windows waits less than one by heat', async () => {
  const [byHeat, byWindows] = [refiner(), refiner()];
  const ended: string[] = [];
  const begin = async (name: string, { refiner: it, settled }: typeof byHeat, asked: Answer) => {
    it.rest(engine([Infinity]).engine, asked, STATE);
    await settled();
    ended.push(name);
  };
  const solved = answer(0);
  const propagated = { ...solved, field: solved.field && { ...solved.field, windows: 1 } };
  await Promise.all([begin('heat', byHeat, solved), begin('windows', byWindows, propagated)]);
  expect(ended).toEqual(['windows', 'heat']);
});

test('steps that reach less far than the first exact region are not shown', async () => {
  const { refiner: it, shown, settled } = refiner();
  it.rest(engine([0.1, 0.2, 0.4, Infinity]).engine, answer(0.3), STATE);
  await settled();
  expect(reached(shown)).toEqual([0.4, Infinity]);
});

test('stops after a few steps without progress', async () => {
  const { refiner: it, settled } = refiner();
  const fake = engine([0.2]);
  it.rest(fake.engine, answer(0), STATE);
  await settled();
  expect(it.phase.value).toBe('stuck');
  expect(fake.slices()).toBeLessThan(10);
});

test('a new question ends refinement: nothing more is shown or asked', async () => {
  const { refiner: it, shown } = refiner();
  const fake = engine(Array.from({ length: 1000 }, (_, i) => i + 1));
  it.rest(fake.engine, answer(0), STATE);
  await until(() => it.phase.value === 'refining', it.phase);
  it.interrupt();
  const [before, slices] = [shown.length, fake.slices()];
  await new Promise((resolve) => setTimeout(resolve, 50));
  expect(shown).toHaveLength(before);
  expect(fake.slices()).toBe(slices);
  expect(it.settled).toBe(false);
});

test('while the page is hidden nothing is refined; once it is seen, refinement goes on', async () => {
  const isHidden = new Signal(true);
  const { refiner: it, shown, phases, settled } = refiner(isHidden);
  const fake = engine([0.2, 0.6, Infinity]);
  it.rest(fake.engine, answer(0, 'exact'), { ...STATE, pathKind: 'exact' });
  await until(() => it.phase.value === 'hidden', it.phase);
  expect(it.settled).toBe(true);
  await new Promise((resolve) => setTimeout(resolve, 50));
  expect(shown).toHaveLength(0);
  expect(fake.slices()).toBe(0);
  isHidden.value = false;
  await until(() => it.phase.value === 'exact', it.phase);
  expect(reached(shown)).toEqual([0, 0.2, 0.6, Infinity]);
  expect(phases).toEqual(['solving', 'resting', 'refining', 'hidden', 'refining', 'exact']);

  // What is asked meanwhile takes the place of what waits.
  isHidden.value = true;
  it.rest(fake.engine, answer(0), STATE);
  await until(() => it.phase.value === 'hidden', it.phase);
  it.rest(fake.engine, answer(0), { ...STATE, refine: false });
  expect(it.phase.value).toBe('off');
  isHidden.value = false;
  await settled();
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect(it.phase.value).toBe('off');
  expect(fake.slices()).toBe(3);
});

test('a question during the wait prevents the first step', async () => {
  const { refiner: it } = refiner();
  const fake = engine([Infinity]);
  it.rest(fake.engine, answer(0), STATE);
  it.interrupt();
  await new Promise((resolve) => setTimeout(resolve, 500));
  expect(fake.slices()).toBe(0);
});

for (const state of [
  { ...STATE, refine: false },
  { ...STATE, method: 'auto', refine: false },
  { ...STATE, method: 'propagation' },
] as const) {
  test(`${state.method} that is not to be refined: the phase says so at once`, () => {
    const { refiner: it } = refiner();
    const fake = engine([Infinity]);
    it.rest(fake.engine, answer(0), state);
    expect(it.phase.value).toBe('off');
    expect(fake.slices()).toBe(0);
  });
}

test('the exact method is refined even if refinement is off', async () => {
  const { refiner: it, settled } = refiner();
  it.rest(engine([Infinity]).engine, answer(0), { ...STATE, method: 'exact', refine: false });
  await settled();
  expect(it.phase.value).toBe('exact');
});

test('where memory ends the refinement the field stays, and is not refined again', async () => {
  const refused = Object.assign(new Error('no memory'), { name: OUT_OF_MEMORY });
  const { refiner: it, shown, settled } = refiner();
  const fake = engine([0.2], 1, refused);
  it.rest(fake.engine, answer(0), STATE);
  await settled();
  expect(it.phase.value).toBe('memory');
  expect(reached(shown)).toEqual([0.2]);
  // The walker is placed elsewhere.
  it.rest(fake.engine, { ...shown[0], path: null }, STATE);
  expect(it.phase.value).toBe('memory');
  // A source is.
  it.rest(engine([Infinity]).engine, answer(0), STATE);
  await settled();
  expect(it.phase.value).toBe('exact');
});

test('where refinement costs a worker, the mesh is not refined again until another is shown', async () => {
  const lost = Object.assign(new WorkerLost('no memory'), { name: OUT_OF_MEMORY });
  const { refiner: it, settled } = refiner();
  it.rest(engine([0.2], 1, lost).engine, answer(0), STATE);
  await settled();
  expect(it.hasLostWorker).toBe(true);
  const fake = engine([Infinity]);
  it.rest(fake.engine, answer(0, 'exact'), { ...STATE, pathKind: 'exact' });
  expect(it.phase.value).toBe('memory');
  expect(fake.slices()).toBe(0);
  it.reset();
  it.rest(fake.engine, answer(0), STATE);
  await settled();
  expect(it.phase.value).toBe('exact');
});

test('the exact path is traced at rest, even if the field is not refined', async () => {
  const { refiner: it, shown, settled } = refiner();
  it.rest(engine([]).engine, answer(0, 'exact'), { ...STATE, refine: false, pathKind: 'exact' });
  await settled();
  expect(it.phase.value).toBe('off');
  expect(shown.map(({ pathKind }) => pathKind)).toEqual(['exact']);
});

test('a drag ends the search for the exact path', async () => {
  const { refiner: it, shown } = refiner();
  let steps = 0;
  const search = {
    traceExactly: (before: Answer) =>
      new Promise<Answer>((resolve) => {
        steps += 1;
        setTimeout(() => resolve(before));
      }),
  };
  it.rest(search as unknown as Engine, answer(0, 'exact'), { ...STATE, pathKind: 'exact' });
  await until(() => it.phase.value === 'refining', it.phase);
  await expect.poll(() => steps).toBeGreaterThan(2);
  it.interrupt();
  const before = steps;
  await new Promise((resolve) => setTimeout(resolve, 50));
  expect(steps).toBe(before);
  expect(shown).toHaveLength(0);
});
