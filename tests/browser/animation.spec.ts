/** Files that move: poses, what rides along, and distance measured in them. */
import { ARM, ARM_LENGTH, armGlb } from '../animated';
import { glb, sphere } from '../fixtures';
import { difference, expect, type HeatwalkPage, openSection, SEEN, test } from '../page';
import { runInWorkers, workerThatPrints } from '../worker';

test.use(SEEN);

const LINK = 'p=0&s=0&method=auto';

/** The arm with the state that a link gives it, with or without a walker. */
async function openArm(heatwalk: HeatwalkPage, options: string, walker: '1' | 'none' = '1'): Promise<void> {
  await heatwalk.open(`#v=1&m=file&name=arm.glb&${LINK}&w=${walker}&${options}`);
  await heatwalk.dropAndOpen([['arm.glb', armGlb()]]);
  await heatwalk.settled();
}

const animation = (heatwalk: HeatwalkPage) => heatwalk.page.evaluate(() => window.heatwalk.animation);

/** How far apart two places are seen. */
async function apart(heatwalk: HeatwalkPage, a: number, b: number): Promise<number> {
  const [[ax, ay], [bx, by]] = [await heatwalk.pixelOf({ vertex: a }), await heatwalk.pixelOf({ vertex: b })];
  return Math.hypot(ax - bx, ay - by);
}

test('a dropped file that moves plays, unless motion is unwelcome', async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await heatwalk.open();
  const section = page.locator('#section-animation');
  await expect(section).toBeHidden();
  await heatwalk.dropAndOpen([['arm.glb', armGlb()]]);
  await expect(section).toBeVisible();
  expect((await heatwalk.scene()).animation).toMatchObject({ clip: 0, plays: true, loops: true });
  await expect(page).toHaveURL(/&clip=0&play=1/);
  const moments = new Set<number>();
  await expect.poll(async () => moments.add((await animation(heatwalk)).moment?.seconds ?? -1).size).toBeGreaterThan(3);
  expect(Math.max(...moments)).toBeLessThanOrEqual(1);

  await page.keyboard.press('a');
  await heatwalk.settled();
  const { moment } = await animation(heatwalk);
  expect((await heatwalk.scene()).animation).toMatchObject({ plays: false, seconds: moment?.seconds });
  const seconds = Number(moment?.seconds.toFixed(4));
  // A link leaves the beginning out.
  await expect(page).toHaveURL(new RegExp(`&clip=0${seconds === 0 ? '' : `&time=${seconds}`}$`));
  await expect(page.getByRole('button', { name: 'Play the animation' })).toBeVisible();

  await heatwalk.dropAndOpen([['still.glb', glb(sphere(12))]]);
  await expect(section).toBeHidden();
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await heatwalk.dropAndOpen([['arm.glb', armGlb()]]);
  expect((await heatwalk.scene()).animation).toMatchObject({ clip: 0, plays: false, seconds: 0 });
});

test('a link shows the moment, and distance, path and pins ride along', async ({ heatwalk }) => {
  await openArm(heatwalk, 'clip=0');
  const straight = await apart(heatwalk, ARM.start, ARM.end);
  const [length, far] = [await walked(heatwalk), await heatwalk.distanceAt({ vertex: ARM.end })];
  expect(far).toBeCloseTo(ARM_LENGTH + 1, 1);
  expect(length).toBeCloseTo(far, 1);

  await openArm(heatwalk, 'clip=0&time=1');
  expect((await animation(heatwalk)).moment).toEqual({ clip: 0, seconds: 1 });
  // The camera keeps its distance: the ends of a right angle are nearer to each other.
  expect((await apart(heatwalk, ARM.start, ARM.end)) / straight).toBeLessThan(0.9);
  expect(await heatwalk.distanceAt({ vertex: ARM.end })).toBeCloseTo(far, 9);
  expect(await walked(heatwalk)).toBeCloseTo(length, 9);
});

test('where the view refuses another mesh, the pose comes back', async ({ heatwalk, page }) => {
  // Of equally short paths around the arm another search may find another one.
  await openArm(heatwalk, 'clip=0', 'none');
  const straight = await heatwalk.picture();
  await openArm(heatwalk, 'clip=0&time=1', 'none');
  const bent = await heatwalk.picture();
  expect((await heatwalk.scene()).walker).toBeNull();
  await expect(page).toHaveURL(/&w=none&/);
  expect(difference(straight, bent)).toBeGreaterThan(0.02);

  // The next buffer ends the renderer as a panic does.
  await page.evaluate(() => {
    const target = WebGL2RenderingContext.prototype;
    const original = Object.getOwnPropertyDescriptor(target, 'createBuffer') ?? {};
    const trap = () => {
      Object.defineProperty(target, 'createBuffer', original);
      throw new WebAssembly.RuntimeError('unreachable');
    };
    Object.defineProperty(target, 'createBuffer', { ...original, value: trap });
  });
  await heatwalk.drop([['still.glb', glb(sphere(12))]]);
  await expect(page.getByRole('alert')).toContainText('still.glb');
  await expect.poll(() => page.evaluate(() => window.heatwalk.backend)).toBe(heatwalk.backend);
  expect(await page.evaluate(() => window.heatwalk.mesh?.name)).toBe('arm.glb');
  expect((await animation(heatwalk)).moment).toEqual({ clip: 0, seconds: 1 });
  // Ambient occlusion follows once a pose has stood for a while.
  expect(difference(await heatwalk.picture(), bent)).toBeLessThan(0.01);
});

test('places are found where they are seen', async ({ heatwalk, page }) => {
  await openArm(heatwalk, 'clip=0&time=1&cam=3.1,0.3,3,0,0,0');
  const found = await page.evaluate(() => {
    const faces = Array.from({ length: 1900 }, (_, face) => face);
    return faces.filter((face) => {
      const pixel = window.heatwalk.pixelOf({ face, weights: [0.4, 0.3, 0.3] });
      const under = pixel && window.heatwalk.placeAt(...pixel);
      return under && 'face' in under && under.face === face;
    }).length;
  });
  // About half of them face away.
  expect(found).toBeGreaterThan(600);
});

test('distance is measured in each pose where that is wanted', async ({ heatwalk, page }) => {
  await openArm(heatwalk, 'clip=1&time=2&live=1');
  const { maxDistance } = await heatwalk.field();
  expect(maxDistance).toBeCloseTo(2 * (ARM_LENGTH + 1), 0);
  expect(await heatwalk.refining()).toBe('exact');
  expect(await walked(heatwalk)).toBeCloseTo(maxDistance, 1);

  await page.getByRole('combobox', { name: 'Distance' }).selectOption('Of the pose in the file');
  await expect.poll(async () => (await heatwalk.field()).maxDistance).toBeCloseTo(maxDistance / 2, 9);
  await heatwalk.settled();
  expect((await animation(heatwalk)).moment, 'the pose that is shown stays').toEqual({ clip: 1, seconds: 2 });
  await page.getByRole('combobox', { name: 'Distance' }).selectOption('Of each pose, live');
  await page.getByRole('slider', { name: 'Time' }).fill('1');
  await expect.poll(async () => (await heatwalk.field()).maxDistance).toBeCloseTo((maxDistance * 3) / 4, 9);
  await expect(page).toHaveURL(/&clip=1&time=1&live=1/);

  const before = await heatwalk.solves();
  await page.getByRole('button', { name: 'Play the animation' }).click();
  await expect.poll(async () => (await heatwalk.solves()) - before).toBeGreaterThan(4);
  await page.keyboard.press('p');
  await heatwalk.settled();
  expect(await heatwalk.refining(), 'where it stops it is measured well').toBe('exact');
});

test('what is asked while a pose is not measured yet leaves no message', async ({ heatwalk, page }) => {
  // The answer in the other pose waits until arrows have been asked for.
  await runInWorkers(
    page,
    `let held = null;
    addEventListener('message', (event) => {
      const [name] = event.data.path ?? [];
      if (name === 'propagate' && globalThis.holds) {
        globalThis.holds = false;
        held = event.data;
        event.stopImmediatePropagation();
        console.info('held');
      } else if (name === 'gradients' && held) {
        const data = held;
        held = null;
        setTimeout(() => dispatchEvent(new MessageEvent('message', { data })));
        console.info('asked');
      }
    });`,
  );
  await openArm(heatwalk, 'clip=1&time=1&live=1&refine=0');
  for (const worker of page.workers()) await worker.evaluate('globalThis.holds = true');
  const [held, asked] = ['held', 'asked'].map((text) => workerThatPrints(page, text));
  await page.getByRole('slider', { name: 'Time' }).fill('2');
  await held;
  await page.evaluate(() => void window.heatwalk.set({ show: 'distance' }));
  await asked;
  await heatwalk.settled();
  expect((await heatwalk.field()).maxDistance).toBeCloseTo(2 * (ARM_LENGTH + 1), 0);
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('parts are joined where they meet in the pose in which a model stands still', async ({ heatwalk, page }) => {
  const unreached = () => page.evaluate(() => window.heatwalk.field?.unreachableVertices);
  await heatwalk.open('#v=1&m=file&name=arm.glb&s=0&method=auto&clip=2&time=0&live=1');
  await heatwalk.dropAndOpen([['arm.glb', armGlb()]]);
  await heatwalk.settled();
  expect(await unreached()).toBe(8);
  const time = page.getByRole('slider', { name: 'Time' });
  await time.fill('1');
  await expect.poll(unreached).toBe(0);
  await time.fill('0.2');
  await expect.poll(unreached).toBe(8);
  await page.getByRole('combobox', { name: 'Distance' }).selectOption('Of the pose in the file');
  await time.fill('1');
  await heatwalk.settled();
  expect(await unreached(), 'in the file they are apart').toBe(8);
});

test('heat is measured in each pose too', async ({ heatwalk }) => {
  await openArm(heatwalk, 'method=heat&refine=0&clip=1&time=0&live=1');
  const { maxDistance } = await heatwalk.field();
  await openArm(heatwalk, 'method=heat&refine=0&clip=1&time=2&live=1');
  expect((await heatwalk.field()).maxDistance / maxDistance).toBeCloseTo(2, 6);
});

test('parts that are not walked on move as well, and so does a crowd', async ({ heatwalk, page }) => {
  await openArm(heatwalk, 'clip=1&time=0&crowd=30&cam=3.1,0.3,5,0,0,0');
  const small = await heatwalk.drawing(0.5, true);
  await page.getByRole('slider', { name: 'Time' }).fill('2');
  await heatwalk.settled();
  const covered = ({ data }: typeof small) => {
    let pixels = 0;
    for (let i = 3; i < data.length; i += 4) pixels += Math.sign(data[i]);
    return pixels;
  };
  expect(covered(await heatwalk.drawing(0.5, true)) / covered(small)).toBeGreaterThan(2);
});

test('the cameras of a file are gone to', async ({ heatwalk, page }) => {
  await openArm(heatwalk, 'show=scenery');
  await openSection(page, 'display');
  const cameras = page.getByRole('combobox', { name: 'Cameras of the file' });
  await cameras.selectOption('from the side');
  const [yaw, pitch, distance, ...offset] = (await page.evaluate(() => window.heatwalk.camera)) ?? [];
  expect([yaw, pitch]).toEqual([expect.closeTo(Math.PI / 2, 4), expect.closeTo(0, 4)]);
  // Half the field of view is twice as near: 20 of the file's units away, in bounding radii of the arm.
  const radius = Math.hypot(0.5, 2, 0);
  expect(distance).toBeCloseTo(((20 / radius) * Math.tan(0.15)) / Math.tan(0.3), 1);
  for (const shift of offset) expect(shift).toBeCloseTo(0, 4);
  await expect(page).toHaveURL(/&cam=1.5708,0,/);
  await heatwalk.dropAndOpen([['still.glb', glb(sphere(12))]]);
  await expect(cameras).toBeHidden();
});

test('a link with an animation that the file has not shows it as it is', async ({ heatwalk }) => {
  await openArm(heatwalk, 'clip=7&time=3&play=1');
  expect((await heatwalk.scene()).animation).toMatchObject({ clip: null, plays: false });
  expect((await animation(heatwalk)).moment).toBeNull();
});

test('the robot is painted and waves where it is chosen, and stands still in a link', async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await heatwalk.open('#v=1&m=robot&style=none&cam=0,0.1,3,0,0,0');
  expect((await animation(heatwalk)).clips.map(({ name }) => name)).toEqual(['Wave', 'Walk']);
  expect((await animation(heatwalk)).moment).toBeNull();
  // Its red cheeks are in the image alone.
  const { data } = await heatwalk.drawing(0.5, true);
  let reds = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i] > 100 && data[i] > 2 * data[i + 1] && data[i] > 1.5 * data[i + 2]) reds += 1;
  }
  expect(reds).toBeGreaterThan(50);
  await page.getByRole('button', { name: 'Robot' }).click();
  await expect.poll(async () => (await animation(heatwalk)).moment?.seconds ?? 0).toBeGreaterThan(0);
  expect((await heatwalk.scene()).animation).toMatchObject({ clip: 0, plays: true });
});

async function walked(heatwalk: HeatwalkPage): Promise<number> {
  const walker = await heatwalk.page.evaluate(() => window.heatwalk.walker);
  return walker?.length ?? Number.NaN;
}
