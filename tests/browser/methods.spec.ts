/** The methods by which distance is found: what each shows, when anything is factored, and the way from one to another. */
import type { Page } from '@playwright/test';
import { DEFAULT_WINDOWS } from '../../web/wasm/contract';
import { grid, off, sphere } from '../fixtures';
import { crossings, expect, type HeatwalkPage, openSection, SEEN, test } from '../page';
import { runInWorkers, workerThatPrints } from '../worker';

test.use(SEEN);

/** With more triangles than propagation searches exactly at first. */
const BALL = off(sphere(24));
/** Between the equator and one pole, and near to the other. */
const SOURCE = { vertex: 500 };
const FAR = { vertex: 1040 };
const PLACES = `s=${SOURCE.vertex}&w=${FAR.vertex}&near=0`;

const factors = ({ page }: HeatwalkPage) => page.evaluate(() => window.heatwalk.factorNonzeros);
const choose = (page: Page, name: string) => page.getByRole('combobox', { name: 'Method' }).selectOption(name);
const status = (page: Page) => page.locator('#section-solver').getByRole('status');

/** A memory limit by which the gate knows the file from the preset. */
const MEBIBYTES = 4096;

/** Keeps the worker that is to factor the file from it until the gate is opened, and tells the console of each opening. */
async function gate(page: Page): Promise<() => Promise<void>> {
  const held = workerThatPrints(page, 'held');
  await runInWorkers(
    page,
    `addEventListener('message', (event) => {
      const { path, argumentList } = event.data;
      if (path?.[0] === 'open') console.info('opening');
      if (path?.[0] !== 'prepare' || event.isLetThrough) return;
      if (argumentList[0].value?.memory !== ${MEBIBYTES}) return;
      event.stopImmediatePropagation();
      addEventListener('gate', () => {
        dispatchEvent(Object.assign(new MessageEvent('message', { data: event.data }), { isLetThrough: true }));
      });
      console.info('held');
    });`,
  );
  return async () => {
    await (await held).evaluate(() => void dispatchEvent(new Event('gate')));
  };
}

/** A file that is dropped with nothing factored, and the panel open at its methods. */
async function dropped(heatwalk: HeatwalkPage): Promise<void> {
  await heatwalk.openFile('ball.off', BALL, `${PLACES}&method=auto&refine=0&memory=${MEBIBYTES}`);
  await openSection(heatwalk.page, 'solver');
}

test('a dropped file shows stripes with nothing factored, and is exact at rest', async ({ heatwalk, page }) => {
  await heatwalk.open();
  expect(await factors(heatwalk)).toBeGreaterThan(0);
  await heatwalk.dropAndOpen([['ball.off', BALL]]);
  expect((await heatwalk.scene()).method).toBe('auto');
  await expect(page).toHaveURL(/[&]method=auto/);
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('exact');
  const { windows, timeFactor, error, refineMs } = await heatwalk.field();
  expect([windows, timeFactor]).toEqual([DEFAULT_WINDOWS, undefined]);
  expect(refineMs).toBeGreaterThan(0);
  // Far below that of the heat method, which is about 1 % here.
  expect(error?.mean).toBeLessThan(0.002);
  expect(await factors(heatwalk)).toBe(0);
  // What a screen reader is told at rest.
  const told = page.locator('.unseen', { hasText: 'Maximum distance' });
  await expect(told).toHaveText(/^Exact\. .*Maximum distance [\d.]+.* Path [\d.]+/);
  await openSection(page, 'solver');
  await expect(status(page)).toHaveText(/^Exact\. Error of propagation with 1 window: mean [\d.]+ %/);
  await expect(page.locator('#section-numbers dt', { hasText: 'Factor nonzeros' }).locator('+ dd')).toHaveText('–');
  const [x, y] = await heatwalk.pixelOnModel();
  expect(crossings(await heatwalk.picture(), x, y - 150, y + 150)).toBeGreaterThanOrEqual(4);
});

test('an old link is by the heat method, and says nothing of it', async ({ heatwalk, page }) => {
  await heatwalk.openFile('ball.off', BALL, `${PLACES}&refine=0`);
  expect((await heatwalk.scene()).method).toBe('heat');
  expect((await heatwalk.field()).timeFactor).toBeGreaterThan(0);
  expect(await factors(heatwalk)).toBeGreaterThan(0);
  await expect(page).toHaveURL(/hash=/);
  expect(page.url()).not.toMatch(/method=|windows=/);
});

test('method and windows come from the link and return to it', async ({ heatwalk, page }) => {
  await heatwalk.openFile('ball.off', BALL, `${PLACES}&method=propagation&windows=4`);
  await heatwalk.settled();
  expect(await heatwalk.refining()).toBe('off');
  expect(await heatwalk.field()).toMatchObject({ windows: 4, refineMs: 0 });
  await expect(page).toHaveURL(/&method=propagation&windows=4/);

  await openSection(page, 'solver');
  await expect(page.getByRole('switch', { name: 'Refine to exact' })).toBeHidden();
  for (const ofHeat of ['Boundary', 'Operator', 'Linear solver'])
    await expect(page.getByLabel(ofHeat, { exact: true })).toBeHidden();
  await page.getByText('More solver settings').click();
  await expect(page.getByLabel('Operator', { exact: true })).toBeHidden();
  await page.getByRole('combobox', { name: 'Windows' }).selectOption('8');
  await expect.poll(async () => (await heatwalk.field()).windows).toBe(8);
  await expect(page).toHaveURL(/&method=propagation&windows=8/);
  await choose(page, 'exact');
  await heatwalk.settled();
  expect((await heatwalk.field()).exactBelow).toBe(Infinity);
  await expect(page).toHaveURL(/&method=exact&windows=8/);
});

test('while the mesh is factored, questions are answered by windows; then heat is shown', async ({
  heatwalk,
  page,
}) => {
  const openGate = await gate(page);
  await dropped(heatwalk);
  await choose(page, 'heat');
  const cancel = page.getByRole('button', { name: 'Cancel' });
  await expect(cancel).toBeVisible();
  const solves = await heatwalk.solves();
  await page.locator('.stage').press('Enter');
  await expect.poll(() => heatwalk.solves()).toBe(solves + 1);
  const { sources } = await heatwalk.scene();
  expect(sources).not.toEqual([SOURCE]);
  expect((await heatwalk.field()).windows).toBe(DEFAULT_WINDOWS);
  expect(await heatwalk.distanceAt(sources[0])).toBeLessThan(0.2);
  expect(await factors(heatwalk)).toBe(0);

  await openGate();
  await heatwalk.settled();
  await expect(cancel).toBeHidden();
  expect(await heatwalk.field()).toMatchObject({ timeFactor: expect.any(Number) });
  expect((await heatwalk.field()).windows).toBeUndefined();
  expect(await factors(heatwalk)).toBeGreaterThan(0);
  expect(await heatwalk.scene()).toMatchObject({ method: 'heat', sources });
  await expect(page).not.toHaveURL(/method=/);
});

test('Cancel, or another method, ends the factoring and leaves what is shown', async ({ heatwalk, page }) => {
  await gate(page);
  await dropped(heatwalk);
  const [solves, field] = [await heatwalk.solves(), await heatwalk.field()];
  const cancel = page.getByRole('button', { name: 'Cancel' });
  for (const end of [() => cancel.click(), () => choose(page, 'auto')]) {
    await choose(page, 'heat');
    await expect(cancel).toBeVisible();
    await end();
    await expect(cancel).toBeHidden();
    await expect(page.getByRole('combobox', { name: 'Method' })).toHaveValue('auto');
    expect(await heatwalk.scene()).toMatchObject({ method: 'auto' });
    await heatwalk.settled();
    expect(await heatwalk.field()).toEqual(field);
    expect(await heatwalk.solves()).toBe(solves);
  }
  // What was cancelled is no step of undo, nor is what undo cannot go back to.
  const undo = page.getByRole('button', { name: 'Undo' });
  await undo.click();
  await expect(cancel).toBeVisible();
  await cancel.click();
  await expect(cancel).toBeHidden();
  expect(await heatwalk.scene()).toMatchObject({ method: 'auto' });
  await expect(undo).toBeDisabled();
  await expect(page.getByRole('alert')).toBeEmpty();
  await page.locator('.stage').press('Enter');
  await expect.poll(() => heatwalk.solves()).toBe(solves + 1);
});

test('what is factored answers every method, without opening the mesh again', async ({ heatwalk, page }) => {
  let openings = 0;
  page.on('console', (message) => {
    if (message.text().startsWith('opening')) openings += 1;
  });
  const openGate = await gate(page);
  await dropped(heatwalk);
  await choose(page, 'heat');
  await openGate();
  await heatwalk.settled();
  const before = openings;
  expect(before).toBeGreaterThan(0);
  const nonzeros = await factors(heatwalk);
  const distance = await heatwalk.distanceAt(FAR);
  for (const method of ['auto', 'exact', 'propagation']) {
    await choose(page, method);
    await heatwalk.settled();
    expect((await heatwalk.field()).windows, method).toBe(DEFAULT_WINDOWS);
    expect(await heatwalk.distanceAt(FAR)).not.toBe(distance);
  }
  await choose(page, 'heat');
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(FAR)).toBe(distance);
  expect(await factors(heatwalk)).toBe(nonzeros);
  expect(openings).toBe(before);
});

test('factors that do not fit leave the method as it was, and conjugate gradients are offered', async ({
  heatwalk,
  page,
}) => {
  await heatwalk.openFile('grid.off', off(grid(100)), 's=3&method=auto&refine=0&b=average&memory=7.2');
  expect(await factors(heatwalk)).toBe(0);
  const { maxDistance } = await heatwalk.field();
  await openSection(page, 'solver');
  await choose(page, 'heat');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText(/Factoring takes [\d.]+ MiB of memory/);
  expect((await heatwalk.scene()).method).toBe('auto');
  expect((await heatwalk.field()).maxDistance).toBe(maxDistance);
  await alert.getByRole('button', { name: 'Use conjugate gradients' }).click();
  await expect.poll(async () => (await heatwalk.scene()).method).toBe('heat');
  expect((await heatwalk.scene()).parameters.solver).toBe('cg');
  expect((await heatwalk.field()).timeFactor).toBeGreaterThan(0);
});

test('what only the heat method has is not asked of windows', async ({ heatwalk, page }) => {
  await heatwalk.openFile('ball.off', BALL, `${PLACES}&method=auto&refine=0&paint=heat&show=operator,heat,edges`);
  await heatwalk.settled();
  await page.evaluate(() => window.heatwalk.picture(0.5));
  await expect(page.getByRole('alert')).toBeEmpty();
  await openSection(page, 'display');
  await expect(page.getByText('Only the heat method has heat; distance is shown.')).toBeVisible();
  await expect(page.getByLabel('Operator edges')).toBeHidden();
  await expect(page.getByLabel('Mesh edges')).toBeVisible();
  await openSection(page, 'solver');
  await choose(page, 'heat');
  await heatwalk.settled();
  await page.evaluate(() => window.heatwalk.picture(0.5));
  await openSection(page, 'display');
  await expect(page.getByText('Log scale, from the hottest vertex')).toBeVisible();
  await expect(page.getByLabel('Operator edges')).toBeChecked();
  await expect(page.getByRole('alert')).toBeEmpty();
});
