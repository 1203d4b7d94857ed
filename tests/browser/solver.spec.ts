import { grid, off } from '../fixtures';
import { expect, type HeatwalkPage, openSection, test } from '../page';

const N = 24;
const GRID = off(grid(N));
const at = (i: number, j: number) => i + (N + 1) * j;

/**
 * Sheared, so that most diagonals of the file are not those of a Delaunay triangulation, and with one vertex pushed against
 * an edge, so that there is a triangle to repair.
 */
const SHEARED = off({
  ...grid(N),
  positions: grid(N).positions.map(([x, y, z], vertex) => [x + 1.5 * y, vertex === at(12, 12) ? y + 0.97 / N : y, z]),
});

interface Figures {
  distances: number[];
  timeFactor: number | undefined;
  exactBelow: number;
  nonzeros: number;
}

async function figures({ page }: HeatwalkPage): Promise<Figures> {
  return page.evaluate(
    (count) => {
      const { field, distanceAt, factorNonzeros: nonzeros } = window.heatwalk;
      if (!field) throw new Error('no field');
      const { timeFactor, exactBelow } = field;
      const distances = Array.from({ length: count }, (_, vertex) => distanceAt({ vertex }));
      return { distances, timeFactor, exactBelow, nonzeros };
    },
    (N + 1) ** 2,
  );
}

/** Largest difference of two fields on the same vertices. */
function change(a: Figures, b: Figures): number {
  return Math.max(...a.distances.map((distance, i) => Math.abs(distance - b.distances[i])));
}

/** Options in the order in which links write them; `memory` is that of memory.spec.ts. */
const OPTIONS = [
  't=1&near=0',
  't=4&near=0',
  't=1&b=dirichlet&near=0',
  't=1&b=average&near=0',
  't=1&multi=summed&near=0',
  't=1&near=8',
  't=1&near=0&op=plain',
  't=1&near=0&op=relocate',
] as const;
const ITERATED = 't=1&near=0&solver=cg';
/** Of values up to 3 in 32-bit floats, and of what conjugate gradients leave. */
const ROUNDING = 1e-5;

test('every option of a link reaches the solver, changes its answer and comes back in the link', async ({
  heatwalk,
  page,
}) => {
  const sources = `s=${at(3, 4)},${at(20, 20)}`;
  const open = async (options: string): Promise<Figures> => {
    await page.evaluate((fragment) => {
      location.hash = fragment;
    }, `v=1&m=file&name=grid.off&${sources}&refine=0&${options}`);
    const asked = page.getByText('This link needs your file grid.off');
    await expect(asked).toBeVisible();
    await heatwalk.drop([['grid.off', SHEARED]]);
    await expect(asked).toBeHidden();
    await expect(page).toHaveURL(new RegExp(`&hash=[\\da-f]{64}&.*${options}(&|$)`));
    await expect(page.getByRole('alert')).toBeEmpty();
    return figures(heatwalk);
  };
  await heatwalk.open();
  const answers: (readonly [string, Figures])[] = [];
  for (const option of OPTIONS) {
    const answer = await open(option);
    for (const [other, before] of answers) {
      expect(change(before, answer), `${other} against ${option}`).toBeGreaterThan(ROUNDING);
    }
    expect(answer.timeFactor).toBe(option.startsWith('t=4') ? 4 : 1);
    expect(answer.exactBelow > 0).toBe(option.includes('near=8'));
    expect(answer.nonzeros).toBeGreaterThan(0);
    answers.push([option, answer]);
  }
  // Another way to the same numbers, without factors.
  const iterated = await open(ITERATED);
  expect(iterated.nonzeros).toBe(0);
  expect(change(answers[0][1], iterated)).toBeLessThan(ROUNDING);
});

test('every choice of the panel is solved and written to the link', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${at(3, 4)},${at(20, 20)}&w=${at(20, 2)}&refine=0`);
  await openSection(page, 'solver');
  await page.getByText('More solver settings').click();
  for (const [label, values, key] of [
    ['Boundary', ['dirichlet', 'average'], 'b'],
    ['Multi-source', ['summed'], 'multi'],
    ['Operator', ['plain', 'relocate'], 'op'],
    ['Linear solver', ['cg'], 'solver'],
  ] as const) {
    for (const value of values) {
      const solves = await heatwalk.solves();
      await page.getByRole('combobox', { name: label }).selectOption(value);
      await expect.poll(() => heatwalk.solves(), `${label} ${value}`).toBeGreaterThan(solves);
      await expect(page).toHaveURL(new RegExp(`[&]${key}=${value}`));
    }
  }
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('the solver can choose the time factor and the exact region', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${at(3, 4)}&refine=0`);
  await openSection(page, 'solver');
  await page.getByText('More solver settings').click();
  const chosen = (await heatwalk.field()).timeFactor;
  const auto = page.getByRole('button', { name: 'Auto: Time factor m' });
  await expect(auto).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('.field', { hasText: 'Time factor m' }).locator('.value')).toHaveText(
    `${Number(chosen?.toPrecision(2))}`,
  );
  await page.getByRole('slider', { name: 'Time factor m' }).fill('1');
  await expect(auto).toHaveAttribute('aria-pressed', 'false');
  await expect.poll(async () => (await heatwalk.field()).timeFactor).toBe(10);
  await auto.click();
  await expect.poll(async () => (await heatwalk.field()).timeFactor).toBe(chosen);
  await expect(page).not.toHaveURL(/[&]t=/);

  await page.getByRole('slider', { name: 'Exact region' }).fill('0');
  await expect(page).toHaveURL(/near=0/);
  await expect.poll(async () => (await heatwalk.field()).exactBelow).toBe(0);
  await page.getByRole('button', { name: 'Auto: Exact region' }).click();
  expect((await heatwalk.scene()).parameters.exactRadius).toBe('auto');
});

test('the path is the steepest descent, straightened or exact', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${at(3, 4)}&w=${at(21, 17)}&refine=0&near=0`);
  await openSection(page, 'solver');
  const solves = await heatwalk.solves();
  const lengths: Record<string, number> = {};
  for (const kind of ['straight', 'exact', 'descent']) {
    await page.getByRole('combobox', { name: 'Path' }).selectOption(kind);
    await heatwalk.settled();
    const walker = await page.evaluate(() => window.heatwalk.walker);
    expect(walker?.kind).toBe(kind);
    lengths[kind] = walker?.length ?? 0;
    if (kind === 'exact') await expect(page).toHaveURL(/way=exact/);
  }
  // Another path needs no other field.
  expect(await heatwalk.solves()).toBe(solves);
  const straight = Math.hypot(18, 13) / N;
  expect(lengths['exact']).toBeCloseTo(straight, 5);
  expect(lengths['straight']).toBeCloseTo(straight, 3);
  expect(lengths['descent']).toBeGreaterThanOrEqual(straight - 1e-5);
  expect(lengths['descent']).toBeLessThan(1.1 * straight);
});

test('the scripting API gives gradients and heat', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', GRID, `s=${at(3, 4)}&refine=0&near=0`);
  const seen = await page.evaluate(async () => {
    const { heatwalk: face } = window;
    const [heat, distance, logarithm] = [
      await face.gradients('heat'),
      await face.gradients('distance'),
      await face.heat(),
    ];
    let [along, worst] = [0, 0];
    for (let i = 0; i < heat.length; i += 3) {
      const dot = heat[i] * distance[i] + heat[i + 1] * distance[i + 1] + heat[i + 2] * distance[i + 2];
      along += dot / (heat.length / 3);
      worst = Math.max(worst, Math.abs(Math.hypot(heat[i], heat[i + 1], heat[i + 2]) - 1));
    }
    return { faces: heat.length / 3, same: heat.length === distance.length, along, worst, logarithm: [...logarithm] };
  });
  expect(seen.faces).toBe(2 * N * N);
  expect(seen.same).toBe(true);
  expect(seen.worst).toBeLessThan(1e-6);
  // Heat points to the source, distance away from it.
  expect(seen.along).toBeLessThan(-0.9);
  expect(seen.along).toBeGreaterThan(-1.1);
  expect(seen.logarithm).toHaveLength((N + 1) ** 2);
  expect(seen.logarithm[at(3, 4)]).toBe(0);
  expect(Math.max(...seen.logarithm)).toBe(0);
  expect(seen.logarithm[at(N, N)]).toBeLessThan(-2);
});

test('where all triangles are Delaunay, the choice of the operator says that it changes nothing', async ({
  heatwalk,
  page,
}) => {
  const solver = page.locator('#section-solver');
  const reason = 'All triangles are Delaunay, and none is thin: all of these are the same.';
  await heatwalk.openFile('sheared.off', SHEARED, 's=0&method=heat&t=1');
  await expect(solver).toContainText('Heat flows');
  await expect(solver).not.toContainText(reason);
  await page.evaluate(() => (location.hash = '#v=1&m=icosphere&method=heat&t=1'));
  await expect(solver).toContainText(reason);
  // The distance of the automatic time step is made otherwise with the Delaunay triangulation.
  await page.evaluate(() => (location.hash = '#v=1&m=icosphere&method=heat'));
  await expect(solver).not.toContainText(reason);
});
