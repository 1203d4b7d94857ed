import { COMPRESSED } from '../compressed';
import { glb, gltf, obj, off, sphere } from '../fixtures';
import { brightness, crossings, difference, expect, openSection, SEEN, test } from '../page';

test.use(SEEN);

const BALL = sphere(24);

test('the first visit shows stripes, a path and one hint', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const { sources, mesh } = await heatwalk.scene();
  expect(mesh).toEqual({ kind: 'preset', id: 'bunny' });
  expect(await heatwalk.distanceAt(sources[0])).toBe(0);
  expect(await page.evaluate(() => window.heatwalk.walker?.length)).toBeGreaterThan(0);
  await expect(page.getByText('Click the surface')).toBeVisible();

  const picture = await heatwalk.picture();
  // Where the path, which is drawn over the stripes and counted with them, is level.
  const [x, y] = await heatwalk.pixelOnModel(0.04);
  const striped = crossings(picture, x, y - 150, y + 150);
  expect(striped).toBeGreaterThanOrEqual(6);
  // The background is smooth: what was counted are stripes, not noise.
  expect(crossings(picture, 20, y - 150, y + 150)).toBe(0);

  await openSection(page, 'style');
  await page.getByRole('slider', { name: 'Stripe width' }).fill('0');
  await heatwalk.rest();
  expect(crossings(await heatwalk.picture(), x, y - 150, y + 150)).toBeLessThan(striped / 2);
});

test('the walker starts and arrives', async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await heatwalk.open();
  const arc = () => page.evaluate(() => window.heatwalk.walker?.arc ?? 0);
  const before = await arc();
  await expect.poll(arc).toBeGreaterThan(before);
  await expect.poll(() => page.evaluate(() => window.heatwalk.walker?.arrived), { timeout: 60_000 }).toBe(true);
});

test('P pauses the walker', async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await heatwalk.open();
  await page.keyboard.press('p');
  await expect(page.getByRole('button', { name: 'Resume' })).toBeVisible();
  const arcs = await page.evaluate(async () => {
    const seen: (number | undefined)[] = [];
    for (let i = 0; i < 6; i++) {
      seen.push(window.heatwalk.walker?.arc);
      await new Promise(requestAnimationFrame);
    }
    return seen;
  });
  expect(new Set(arcs).size).toBe(1);
});

for (const [name, content] of [
  ['ball.obj', obj({ ball: BALL })],
  ['ball.off', off(BALL)],
  ['ball.glb', glb(BALL)],
] as const) {
  test(`a dropped ${name} opens and is solved`, async ({ heatwalk, page }) => {
    await heatwalk.open();
    await heatwalk.dropAndOpen([[name, content]]);
    await expect(page.getByText(`${name}, `)).toBeVisible();
    const mesh = await heatwalk.mesh();
    expect(mesh).toMatchObject({
      triangles: BALL.triangles.length,
      vertices: BALL.positions.length,
      components: 1,
      boundaryLoops: 0,
    });
    // Half the way round a unit sphere, up to the mesh's coarseness and the width of the heat kernel.
    const { maxDistance } = (await page.evaluate(() => window.heatwalk.field)) ?? { maxDistance: 0 };
    expect(maxDistance).toBeGreaterThan(0.95 * Math.PI);
    expect(maxDistance).toBeLessThan(1.05 * Math.PI);
    const picture = await heatwalk.picture();
    const [x, y] = await heatwalk.pixelOnModel();
    expect(crossings(picture, x, y - 150, y + 150)).toBeGreaterThanOrEqual(4);
  });
}

test('a glTF opens together with its .bin, in whatever order they are dropped', async ({ heatwalk }) => {
  await heatwalk.open();
  const { json, bin } = gltf(BALL, 'ball.bin');
  await heatwalk.drop([
    ['ball.bin', bin],
    ['ball.gltf', json],
  ]);
  await expect.poll(async () => (await heatwalk.mesh()).name).toBe('ball.gltf');
  expect(await heatwalk.mesh()).toMatchObject({ triangles: BALL.triangles.length, components: 1 });
});

for (const [compression, content] of Object.entries(COMPRESSED)) {
  test(`a GLB compressed by ${compression} opens`, async ({ heatwalk }) => {
    await heatwalk.open();
    await heatwalk.dropAndOpen([[`ball_${compression}.glb`, Buffer.from(content, 'base64')]]);
    const { positions, triangles } = sphere(8);
    expect(await heatwalk.mesh()).toMatchObject({
      vertices: positions.length,
      triangles: triangles.length,
      components: 1,
      boundaryLoops: 0,
    });
  });
}

test('a bad file leaves the scene as it is and says why', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const before = await heatwalk.scene();
  for (const [name, content] of [
    ['broken.obj', 'v 0 0 zero\nf 1 2 3\n'],
    ['empty.off', ''],
    ['notes.txt', 'not a mesh'],
  ]) {
    await heatwalk.drop([[name, content]]);
    const alert = page.getByRole('alert');
    await expect(alert).toContainText(name);
    await expect(alert.getByRole('button', { name: 'Copy details' })).toBeVisible();
    expect(await heatwalk.scene()).toEqual(before);
  }
  const solves = await heatwalk.solves();
  await page.mouse.click(...(await heatwalk.pixelOnModel()));
  await expect.poll(() => heatwalk.solves()).toBeGreaterThan(solves);
});

test('a long load shows its stage; Cancel keeps the old scene and a usable page', async ({ heatwalk, page }) => {
  // By a link without a method the file is factored, which takes longest.
  await heatwalk.open('#v=1&m=file&name=large.off');
  const before = await heatwalk.mesh();
  await heatwalk.drop([['large.off', off(sphere(330))]]);
  await expect(page.getByRole('status').filter({ hasText: 'large.off:' })).toHaveText(/large\.off: \w+.*\d+ %/);
  // Not `click`: it waits for two frames alike, and where drawing is slow the file is open by then.
  await page.getByRole('button', { name: 'Cancel' }).dispatchEvent('click');
  await expect(page.getByRole('button', { name: 'Cancel' })).toBeHidden();
  expect(await heatwalk.mesh()).toEqual(before);
  await page.mouse.click(...(await heatwalk.pixelOnModel()));
  await expect.poll(async () => 'face' in (await heatwalk.scene()).sources[0]).toBe(true);
  await heatwalk.dropAndOpen([['ball.off', off(BALL)]]);
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('a component that no source reaches is named in the panel', async ({ heatwalk, page }) => {
  await heatwalk.open();
  const small = sphere(12, [0.9, -0.6, 1.2]);
  const file = obj({
    earth: sphere(24),
    moon: { ...small, positions: small.positions.map(([x, y, z]) => [x, y, z + 1]) },
  });
  await heatwalk.dropAndOpen([['planets.obj', file]]);
  expect(await heatwalk.mesh()).toMatchObject({ components: 2, parts: ['earth', 'moon'] });
  const sources = page.locator('#section-sources');
  await expect(sources).toContainText(/(earth|moon) \([\d,]+ vertices of 1,\d+\) is not connected to any source/);

  // Solved on one part alone, nothing is out of reach.
  await page.getByRole('checkbox', { name: 'moon' }).click();
  await expect.poll(async () => (await heatwalk.mesh()).active).toEqual([0]);
  await expect(sources.getByText('is not connected to any source')).toBeHidden();
  expect(await page.evaluate(() => window.heatwalk.field?.unreachableVertices)).toBe(0);
});

/** Larger, and away from the middle. */
function ball(parallels: number, size: number, shift: number): typeof BALL {
  const { positions, triangles } = sphere(parallels);
  const moved = positions.map(([x, y, z]): [number, number, number] => [
    size * x + shift,
    size * y + shift,
    size * z + shift,
  ]);
  return { positions: moved, triangles };
}

test('the first source of a file is in its largest group, wherever that lies', async ({ heatwalk }) => {
  await heatwalk.open();
  // The nearest one to the eye is the smallest, then comes the largest.
  const balls = { small: ball(8, 0.2, 9), large: ball(12, 2, 0), middle: ball(8, 1, -9) };
  await heatwalk.dropAndOpen([['balls.obj', obj(balls)]]);
  await heatwalk.settled();
  const { sources, walker } = await heatwalk.scene();
  const [first, last] = [balls.small.positions.length, balls.small.positions.length + balls.large.positions.length];
  for (const place of [sources[0], walker]) {
    const vertex = place && 'vertex' in place ? place.vertex : -1;
    expect(vertex).toBeGreaterThanOrEqual(first);
    expect(vertex).toBeLessThan(last);
  }
  expect(await heatwalk.distanceAt(sources[0])).toBe(0);
});

test('a link brings back the same scene and nearly the same picture', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await page.keyboard.press('p');
  await page.mouse.click(...(await heatwalk.pixelOnModel(0.03, 0.05)));
  const stage = await heatwalk.pixelOnModel(-0.03, 0.1);
  await page.keyboard.down('Control');
  await page.mouse.click(...stage);
  await page.keyboard.up('Control');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('+');
  await openSection(page, 'style');
  await page.getByRole('button', { name: 'lagoon' }).click();
  await expect(page).toHaveURL(/s=[^&]+,[^&]+.*look=lagoon.*cam=/);
  await heatwalk.rest();
  const link = new URL(page.url()).hash;
  const before = await heatwalk.scene();
  const solves = await heatwalk.solves();
  expect(solves).toBeGreaterThan(1);
  const picture = await heatwalk.lastPicture();

  await heatwalk.open(link);
  const after = await heatwalk.scene();
  expect(after.style).toEqual(before.style);
  expect(after.sources).toHaveLength(2);
  for (const [i, source] of before.sources.entries()) {
    expect(after.sources[i]).toMatchObject('face' in source ? { face: source.face } : source);
  }
  after.camera?.forEach((value, i) => expect(value).toBeCloseTo(before.camera?.[i] ?? Number.NaN, 3));
  // The link rounds to four digits.
  await expect.poll(async () => difference(picture, await heatwalk.picture())).toBeLessThan(0.03);
});

test('a link to a preset with other triangles or parts has places on them', async ({ heatwalk, page }) => {
  const places = async () => {
    const { sources, sets, walker } = await heatwalk.scene();
    return { sources: sources.length, sets: sets.length, walks: walker !== null };
  };
  const chosen = { sources: 1, sets: 0, walks: true };
  await heatwalk.open('#v=1&m=ring&triangles=800');
  expect(await places()).toEqual(chosen);
  // Its source is on the second part, its walker on none.
  await heatwalk.follow('v=1&m=robot&p=0');
  expect(await places()).toEqual(chosen);
  await expect(page.locator('.message.notice')).toHaveCount(0);
  await heatwalk.follow('v=1&m=bunny&s=999999&w=999999');
  expect(await places()).toEqual(chosen);
  await expect(page.locator('.message.notice')).toHaveText([
    /w=999999/,
    /No source of the link is on this mesh; one was chosen\./,
  ]);
  await page.goto('about:blank');
  await heatwalk.open('#v=1&m=ring&triangles=800&s=none&w=none');
  expect(await places()).toEqual({ sources: 0, sets: 0, walks: false });
});

test('a link to a file asks for it by name and checks its hash', async ({ heatwalk, page }) => {
  await heatwalk.open();
  await heatwalk.dropAndOpen([['ball.off', off(BALL)]]);
  await expect(page).toHaveURL(/m=file&name=ball\.off&hash=[\da-f]{64}/);
  await openSection(page, 'style');
  await page.getByRole('button', { name: 'neon' }).click();
  await expect(page).toHaveURL(/look=neon/);
  const link = new URL(page.url()).hash;
  const before = await heatwalk.scene();

  await heatwalk.forgetFiles();
  await heatwalk.open(link);
  await expect(page.getByText('This link needs your file ball.off')).toBeVisible();
  expect(new URL(page.url()).hash).toBe(link);
  await heatwalk.dropAndOpen([['ball.off', off(BALL)]]);
  await expect(page.getByText('This link needs your file')).toBeHidden();
  expect(await heatwalk.scene()).toEqual(before);

  await heatwalk.forgetFiles();
  await heatwalk.open(link);
  await heatwalk.dropAndOpen([['ball.off', off(sphere(10))]]);
  await expect(page.getByText('not the file the link was made with')).toBeVisible();
});

test(
  'every preset opens, is solved and has a walker, whose path is as long as its distance',
  { tag: '@slow' },
  async ({ heatwalk, page }) => {
    test.setTimeout(300_000);
    await heatwalk.open();
    const cards = page.locator('.gallery').getByRole('button');
    const inexact: string[] = [];
    for (const card of await cards.all()) {
      await card.click();
      await expect(card).toHaveAttribute('aria-pressed', 'true', { timeout: 60_000 });
      await expect(page.getByRole('alert')).toBeEmpty();
      const { mesh } = await heatwalk.scene();
      const name = mesh.kind === 'preset' ? mesh.id : mesh.kind;
      const { field, walker } = await page.evaluate(() => ({
        field: window.heatwalk.field,
        walker: window.heatwalk.walker,
      }));
      expect(field?.maxDistance, name).toBeGreaterThan(0);
      expect(field?.unreachableVertices, name).toBe(0);
      expect(walker?.length, name).toBeGreaterThan(0);
      const [cost, distance, isExact] = await page.evaluate(async () => {
        const { heatwalk: api } = window;
        await api.settled();
        const place = api.scene.walker;
        if (!place || !api.walker) return [0, 0, false] as const;
        const best = (await api.bestDistanceAt(place)) ?? 0;
        return [api.walker.cost, best, (await api.exactDistanceAt(place)) !== null] as const;
      });
      if (!isExact) inexact.push(name);
      expect(Math.abs(cost - distance), name).toBeLessThan(1e-9 * distance);
    }
    // Costs, and tetrahedra.
    expect(inexact).toEqual(['hike', 'village', 'inside', 'pipe', 'cave']);
  },
);

test('light and dark follow the system', async ({ heatwalk, page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await heatwalk.open();
  const light = brightness(await heatwalk.picture(), 20, 300);
  await page.emulateMedia({ colorScheme: 'dark' });
  await heatwalk.rest();
  await expect.poll(async () => brightness(await heatwalk.picture(), 20, 300)).toBeLessThan(light - 0.3);
});
