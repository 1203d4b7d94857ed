/** What two settings take on one mesh, each in a worker of its own, after both have run once. */
import type { MeshInput } from '../protocol';
import type { Times } from '../state/report';
import { median } from '../state/table1';
import { Cancelled } from './remote';
import { inBackground } from './background';
import type { Wanted } from './client';
import type { Question } from './engine';

export interface Side {
  wanted: Wanted;
  question: Question;
}

/** Solves of which the median counts. */
const SOLVES = 5;
/** How often a worker is begun: each side twice. */
export const RUNS = 4;

/** Measures both sides; `begun` is called before each run. Ends with a rejection where `signal` is aborted. */
export async function measureSides(
  load: () => Promise<MeshInput>,
  [left, right]: readonly [Side, Side],
  signal: AbortSignal,
  begun: (done: number) => void,
): Promise<readonly [Times, Times]> {
  let done = 0;
  const run = (side: Side, solves: number) => {
    begun(done++);
    return timesOf(load, side, solves, signal);
  };
  // Browsers optimise code while it runs: the first run of either takes several times as long as later ones.
  await run(left, 1);
  await run(right, 1);
  return [await run(left, SOLVES), await run(right, SOLVES)];
}

function timesOf(
  load: () => Promise<MeshInput>,
  { wanted, question }: Side,
  count: number,
  signal: AbortSignal,
): Promise<Times> {
  return inBackground(load, wanted, signal, async (engine) => {
    let precompute = 0;
    const solves: number[] = [];
    while (solves.length < count) {
      // Sources of another identity are another question.
      const answer = await engine.ask({ ...question, sources: [...question.sources], from: null, quick: false });
      if (!answer?.field) throw new Cancelled();
      precompute = answer.factoring.timings.precomputeMs;
      solves.push(answer.field.solveMs);
    }
    return { precompute, solve: median(solves) };
  });
}
