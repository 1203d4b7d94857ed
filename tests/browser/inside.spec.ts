import { readFile } from 'node:fs/promises';
import type { InnerPoint, MeshPoint } from '../../web/protocol';
import { grid, off, sphere } from '../fixtures';
import { difference, expect, type HeatwalkPage, openSection, test } from '../page';
import { cubeMsh, cubesMsh, cubeVertex } from '../tetrahedra';

const N = 6;
const CUBE = cubeMsh(N);
const [CORNER, FAR, MIDDLE] = [cubeVertex(N, 0, 0, 0), cubeVertex(N, N, N, N), cubeVertex(N, 3, 3, 3)];
const VIEW = 'up=y&cam=0.3,0.3,3.2,0,0,0';

async function openCube(heatwalk: HeatwalkPage, options = 'method=auto&cut=plane'): Promise<void> {
  const link = `${VIEW}&s=${CORNER.vertex}&w=${FAR.vertex}&${options}`;
  await heatwalk.openInSection('inside', 'cube.msh', CUBE, link);
}

/** The corner in the middle of a triangle or beside it, clicked with a key held. */
async function clickAt(heatwalk: HeatwalkPage, place: MeshPoint, key?: 'Shift'): Promise<void> {
  const [x, y] = await heatwalk.pixelOf(place);
  if (key) await heatwalk.page.keyboard.down(key);
  await heatwalk.page.mouse.click(x + 1, y + 1);
  if (key) await heatwalk.page.keyboard.up(key);
}

function isInside(point: MeshPoint | undefined): boolean {
  return point !== undefined && 'tetrahedron' in point;
}

async function inside(heatwalk: HeatwalkPage) {
  return (await heatwalk.scene()).inside;
}

test('a file of tetrahedra opens: distance leads through them, exact where lines are straight', async ({
  heatwalk,
  page,
}) => {
  await openCube(heatwalk);
  expect((await heatwalk.mesh()).tetrahedra).toBe(6 * N ** 3);
  expect((await heatwalk.mesh()).volume).toBeCloseTo(1, 12);
  await expect(page.locator('.heading .size')).toHaveText('1,296 tetrahedra');
  expect(await heatwalk.distanceAt(MIDDLE)).toBeCloseTo(Math.sqrt(0.75), 6);
  expect(await heatwalk.distanceAt(FAR)).toBeCloseTo(Math.sqrt(3), 6);
  expect((await heatwalk.field()).exactShare).toBe(1);
  expect(await heatwalk.refining()).toBe('exact');
  expect((await page.evaluate(() => window.heatwalk.walker))?.length).toBeCloseTo(Math.sqrt(3), 6);
  await expect(await openSection(page, 'ground')).toContainText('Inside of tetrahedra there is no ground.');
  await expect(page.getByRole('switch', { name: 'Brush' })).toBeHidden();
  await openSection(page, 'inside');
  await expect(page.getByRole('button', { name: 'Fill the inside' })).toBeHidden();
  // A girth is of surfaces.
  const girth = await openSection(page, 'girth');
  await expect(girth.getByRole('switch')).toBeDisabled();
  await expect(girth).toContainText('This is for surfaces, not for the inside of tetrahedra.');
  await openCube(heatwalk, 'method=auto&cut=plane&girth=0,90,0');
  await expect(page.getByText("The link's girth=0,90,0 is invalid")).toBeVisible();
  expect((await heatwalk.scene()).girth).toBeNull();
});

test('what was repaired is told of files, not of built-in shapes', async ({ heatwalk, page }) => {
  // Of the six tetrahedra of each cube, half are.
  await openCube(heatwalk);
  const section = page.locator('#section-inside');
  await expect(section.getByText(` ${3 * N ** 3} inside out were turned.`)).toBeVisible();
  await heatwalk.open('#v=1&m=cave');
  await openSection(page, 'inside');
  await expect(section.getByText(/ tetrahedra with dihedral angles /)).toBeVisible();
  await expect(section.getByText(/inside out/)).toHaveCount(0);
});

test('heat flows inside too, and takes the options of the solver', async ({ heatwalk, page }) => {
  // Where all is seen from the source, distances by heat would be straight whatever the options.
  const [source, end] = [cubeVertex(N, N, 0, 0), cubeVertex(N, N / 2, N, 1)];
  const truth = Math.hypot(Math.SQRT1_2 + 0.5, 1 / N);
  const options = `s=${source.vertex}&w=${end.vertex}&method=heat&near=2&t=0.5`;
  const bent = cubesMsh(N, (i, j) => Math.min(i, j) < N / 2);
  await heatwalk.openFile('bent.msh', bent, `${VIEW}&${options}`);
  await heatwalk.settled();
  const byHeat = await heatwalk.distanceAt(end);
  expect(Math.abs(byHeat / truth - 1)).toBeLessThan(0.1);
  expect(byHeat).not.toBeCloseTo(truth, 3);
  expect(await page.evaluate(() => window.heatwalk.factorNonzeros)).toBeGreaterThan(1000);
  expect((await heatwalk.field()).timeFactor).toBeCloseTo(0.5, 6);
  expect(await heatwalk.refining()).toBe('inside');
  await openSection(page, 'solver');
  await page.getByRole('combobox', { name: 'Boundary' }).selectOption('dirichlet');
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(end)).not.toBe(byHeat);
  await page.getByRole('combobox', { name: 'Method' }).selectOption('auto');
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(end)).toBeCloseTo(truth, 3);
});

test('a click through the cut sets a source inside; it is dragged along the cut, undone, and in the link', async ({
  heatwalk,
  page,
}) => {
  await openCube(heatwalk);
  const [x, y] = await heatwalk.pixelOf(MIDDLE);
  await page.mouse.click(x + 30, y - 20);
  await heatwalk.settled();
  const [first] = (await heatwalk.scene()).sources;
  expect(isInside(first)).toBe(true);
  // Linear between the corners of its tetrahedron.
  expect(await heatwalk.distanceAt(first)).toBeLessThan(1 / N);
  const before = await heatwalk.distanceAt(MIDDLE);
  expect(before).toBeGreaterThan(0.02);

  await page.mouse.move(x + 30, y - 20);
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 30, { steps: 6 });
  await page.mouse.up();
  await heatwalk.settled();
  const [second] = (await heatwalk.scene()).sources;
  expect(isInside(second)).toBe(true);
  expect(second).not.toEqual(first);
  expect(await heatwalk.distanceAt(second)).toBeLessThan(1 / N);
  await expect(page).toHaveURL(/&s=\d+:[\d.]+\/[\d.]+\/[\d.]+\/[\d.]+/);
  const there = await heatwalk.distanceAt(FAR);

  await page.keyboard.press('Control+z');
  await heatwalk.settled();
  expect((await heatwalk.scene()).sources).toEqual([first]);
  await page.keyboard.press('Control+Shift+z');
  await heatwalk.settled();
  const { tetrahedron, weights } = second as InnerPoint;
  const written = weights.map((weight) => Number(weight.toFixed(4))).join('/');
  await expect(page).toHaveURL(new RegExp(`&s=${tetrahedron}:${written}&`));
  const link = new URL(page.url()).hash;
  // The browser keeps the file.
  await heatwalk.kept();
  await heatwalk.open(link);
  await heatwalk.settled();
  expect(isInside((await heatwalk.scene()).sources[0])).toBe(true);
  expect(await heatwalk.distanceAt(FAR)).toBeCloseTo(there, 3);
});

test('what is cut away is not picked, and the cut moves by handle, keys and panel', async ({ heatwalk, page }) => {
  await openCube(heatwalk, 'method=auto&cut=plane&turn=0&tilt=0');
  const near = cubeVertex(N, 3, 3, N);
  const [x, y] = await heatwalk.pixelOf(near);
  const under = () => page.evaluate(([px, py]) => window.heatwalk.placeAt(px, py), [x, y] as const);
  expect(isInside((await under()) ?? undefined)).toBe(true);

  const handle = page.getByRole('slider', { name: 'Position of the cut' });
  await handle.focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  expect((await inside(heatwalk)).place).toBeCloseTo(0.04, 6);
  const box = await handle.boundingBox();
  if (!box) throw new Error('no handle');
  const [hx, hy] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(hx, hy);
  await page.mouse.down();
  // The cut faces the camera but for 0.3 rad: its way leads to the left and down.
  await page.mouse.move(hx - 20, hy + 20, { steps: 4 });
  await page.mouse.up();
  await heatwalk.settled();
  const moved = (await inside(heatwalk)).place;
  expect(moved).toBeGreaterThan(0.1);
  // It stays under the pointer, but for what leads across its way.
  const after = await handle.boundingBox();
  if (!after) throw new Error('no handle');
  const [right, down] = [after.x + after.width / 2 - hx, after.y + after.height / 2 - hy];
  const far = Math.hypot(right, down);
  expect(Math.abs((-20 * right + 20 * down) / far - far)).toBeLessThan(1.5);
  await page.keyboard.press('Control+z');
  expect((await inside(heatwalk)).place).toBeCloseTo(0.04, 6);

  await page.locator('.stage').focus();
  await page.keyboard.press('.');
  expect((await inside(heatwalk)).place).toBeCloseTo(0.06, 6);
  await page.keyboard.press('i');
  await heatwalk.settled();
  expect((await inside(heatwalk)).cut).toBe('none');
  await expect(handle).toBeHidden();
  expect(isInside((await under()) ?? undefined)).toBe(false);
});

test('shells, whole tetrahedra and tetrahedra apart are drawn, each another picture', async ({ heatwalk, page }) => {
  // Beside the faces of tetrahedra that lie in the middle.
  await openCube(heatwalk, 'method=auto&cut=plane&place=0.1');
  const section = await openSection(page, 'inside');
  const pictures = [await heatwalk.drawing(0.3, false)];
  const another = () =>
    expect
      .poll(async () => {
        const drawn = await heatwalk.drawing(0.3, false);
        const isNew = pictures.every((picture) => difference(picture, drawn) > 0.0005);
        if (isNew) pictures.push(drawn);
        return isNew;
      })
      .toBe(true);
  await section.getByRole('switch', { name: 'Whole tetrahedra' }).check();
  await another();
  await section.getByRole('slider', { name: 'Pull apart' }).fill('0.5');
  await another();
  await section.getByRole('slider', { name: 'Pull apart' }).fill('0');
  await section.getByRole('switch', { name: 'Whole tetrahedra' }).uncheck();
  await section.getByRole('slider', { name: 'Shells' }).fill('0.1');
  await another();
  await section.getByRole('switch', { name: 'Arrows inside' }).check();
  await another();
  await section.getByRole('combobox', { name: 'Cut away' }).selectOption('wedge');
  await another();
  await expect(page).toHaveURL(/&cut=wedge&place=0.1&spacing=0.1&arrows=1/);
});

test('what is pulled apart is framed as its link frames it, and together again as before', async ({
  heatwalk,
  page,
}) => {
  // Without a camera of its own.
  const open = (gap: string) =>
    heatwalk.openInSection('inside', 'cube.msh', CUBE, `method=auto&s=${CORNER.vertex}&whole=1${gap}`);
  await open('');
  const distance = () => page.evaluate(() => window.heatwalk.camera?.[2] ?? Number.NaN);
  const together = await distance();
  const gap = (await openSection(page, 'inside')).getByRole('slider', { name: 'Pull apart' });
  await gap.fill('1');
  await expect.poll(distance).toBeGreaterThan(1.5 * together);
  await expect(page).toHaveURL(/&gap=1&/);
  expect(page.url()).not.toContain('cam=');
  const apart = await distance();
  await gap.fill('0');
  await expect.poll(distance).toBeCloseTo(together, 6);
  await open('&gap=1');
  expect(await distance()).toBeCloseTo(apart, 6);
});

test('a closed surface is filled, about where it is, and shown again', async ({ heatwalk, page }) => {
  const ball = sphere(16);
  await heatwalk.openFile('ball.off', off(ball), 'method=auto&s=40&w=300&tape=40,80&sets=line:100-105,component:3@9');
  await heatwalk.settled();
  const before = await heatwalk.pixelOf({ vertex: 40 });
  await openSection(page, 'inside');
  await expect(page.locator('#section-inside')).toContainText('A closed surface can be filled');
  await page.locator('#section-inside').getByRole('slider', { name: 'Tetrahedra' }).fill('70');
  await page.getByRole('button', { name: 'Fill the inside' }).click();
  await expect.poll(async () => (await heatwalk.mesh()).tetrahedra).toBeGreaterThan(0);
  await heatwalk.settled();
  const { tetrahedra, volume } = await heatwalk.mesh();
  expect(Math.abs(tetrahedra / 3200 - 1)).toBeLessThan(0.15);
  expect(volume).toBeGreaterThan(3.7);
  expect(volume).toBeLessThan(4.2);
  const { sources, sets, tapes, fill, inside: looked } = await heatwalk.scene();
  // What is of surfaces alone keeps its places.
  expect(sets.map(({ shape, points, offset }) => [shape.kind, points.length, offset])).toEqual([
    ['stroke', 6, 0],
    ['list', ball.positions.length, 9],
  ]);
  expect(tapes).toMatchObject([{ points: { length: 2 } }]);
  expect(fill).toBe(3200);
  expect(looked.cut).toBe('plane');
  const [[x, y], [x0, y0]] = [await heatwalk.pixelOf(sources[0]), before];
  expect(Math.hypot(x - x0, y - y0)).toBeLessThan(30);
  await expect(page).toHaveURL(/&fill=3200/);
  await expect(page.locator('#section-inside')).toContainText('dihedral angles from');
  await page.getByRole('button', { name: 'Show the surface' }).click();
  await expect.poll(async () => (await heatwalk.mesh()).tetrahedra).toBe(0);
  await heatwalk.settled();
  expect(await heatwalk.scene()).toMatchObject({ fill: null, sets: { length: 2 } });
});

test('lines along edges and whole boundaries are sources inside too', async ({ heatwalk, page }) => {
  await openCube(heatwalk, `method=auto&cut=none&sets=line:${CORNER.vertex}-${cubeVertex(N, 0, 3, 0).vertex}`);
  const names = page.locator('.source-name');
  await expect(names).toHaveText(['Vertex 0', 'Line of 4 vertices']);
  // From the last source, which the line replaces, and on from there.
  await clickAt(heatwalk, cubeVertex(N, 1, 2, N), 'Shift');
  await expect(names).toHaveText(['Line of 4 vertices', /Line of \d+ vertices/]);
  await clickAt(heatwalk, cubeVertex(N, 4, 2, N), 'Shift');
  await expect.poll(async () => (await heatwalk.scene()).sets[1].shape).toMatchObject({ corners: { length: 3 } });
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(cubeVertex(N, 2, 2, N))).toBe(0);
  expect(await heatwalk.distanceAt(cubeVertex(N, 2, 2, N - 2))).toBeCloseTo(2 / N, 6);
  await page.keyboard.press('Escape');

  const draw = page.getByRole('combobox', { name: 'Draw' });
  await draw.selectOption('boundary');
  await clickAt(heatwalk, cubeVertex(N, 3, 3, N));
  await expect(page.getByRole('alert')).toContainText('it has no boundary');
  await draw.selectOption('part');
  await clickAt(heatwalk, cubeVertex(N, 3, 3, N));
  await expect(names.nth(2)).toHaveText(`Component of ${(N + 1) ** 3 - (N - 1) ** 3} vertices`);
  await heatwalk.settled();
  expect(await heatwalk.distanceAt(MIDDLE)).toBeCloseTo(0.5, 6);
});

test('what has no inside says so, and the scene stays', async ({ heatwalk, page }) => {
  await heatwalk.openFile('grid.off', off(grid(8)), 'method=auto&s=3');
  await heatwalk.settled();
  await page.locator('.stage').focus();
  await page.keyboard.press('i');
  await expect(page.locator('.message').first()).toContainText(
    'was not filled: the surface does not enclose a volume: it has a hole of 32 edges',
  );
  expect((await heatwalk.mesh()).name).toBe('grid.off');
  expect((await heatwalk.scene()).fill).toBeNull();
  expect(await heatwalk.distanceAt({ vertex: 3 })).toBe(0);

  for (const [content, sentence] of [
    [CUBE.slice(0, CUBE.length / 2), 'cube.msh was not opened'],
    [CUBE.replace(/\$Elements[^]*/, '$Elements\n0\n$EndElements\n'), 'holds neither tetrahedra nor faces'],
    [CUBE.replace('\n1 4 0 1 2', '\n1 4 0 9999 2'), '9999'],
    [CUBE.replace('\n1 0 0 0', '\n1 nan 0 0'), 'cube.msh was not opened'],
  ] as const) {
    await heatwalk.drop([['cube.msh', content]]);
    await expect(page.locator('.message', { hasText: sentence }).first()).toBeVisible();
    expect((await heatwalk.mesh()).name).toBe('grid.off');
    await page.locator('.message').first().getByRole('button', { name: /close/i }).click();
  }
});

test('the faces of a file without tetrahedra are a surface', async ({ heatwalk }) => {
  const nodes = '1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n';
  const msh = `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n${nodes}$EndNodes\n$Elements\n1\n1 3 0 1 2 3 4\n$EndElements\n`;
  await heatwalk.openFile('square.msh', msh, 'method=auto&s=0');
  await heatwalk.settled();
  expect(await heatwalk.distanceAt({ vertex: 2 })).toBeCloseTo(Math.SQRT2, 6);
});

test('a crowd walks inside, and all that is wanted comes with a link', async ({ heatwalk, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await openCube(heatwalk, 'method=auto&cut=none&spacing=0.2&crowd=40');
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await expect.poll(async () => (await heatwalk.scene()).crowd).toBe(40);
  const many = await heatwalk.drawing(0.5, false);
  await openSection(page, 'display');
  await page.getByRole('slider', { name: 'Crowd' }).fill('0');
  await heatwalk.settled();
  expect(difference(many, await heatwalk.drawing(0.5, false))).toBeGreaterThan(0.002);
});

test('a tape leads through the inside: exact along straight lines, approximate around bends', async ({
  heatwalk,
  page,
}) => {
  await openCube(heatwalk, `method=auto&tape=${CORNER.vertex},${MIDDLE.vertex},${FAR.vertex}!`);
  const measured = () => page.evaluate(() => window.heatwalk.tapes);
  const exact = { state: 'exact' };
  await expect.poll(measured).toMatchObject([{ legs: [exact, exact, exact], area: null }]);
  expect((await measured())[0].legs[0].length).toBeCloseTo(Math.sqrt(0.75), 6);
  await expect(page.locator('.tape-label')).toHaveText(['0.866 m', '0.866 m', '1.73 m', 'Σ 3.46 m']);

  await heatwalk.open('#m=pipe');
  const { sources, walker } = await heatwalk.scene();
  const [from, to] = [walker, ...sources].map((place) => {
    if (!place || !('tetrahedron' in place)) throw new Error('The preset has its places inside.');
    return `${place.tetrahedron}:${place.weights.join('/')}`;
  });
  await heatwalk.open(`#m=pipe&tape=${from},${to}`);
  await expect.poll(measured).toMatchObject([{ legs: [{ state: 'approximate' }] }]);
  const [{ legs }] = await measured();
  // As far as the walker has to go.
  expect(legs[0].length).toBeCloseTo((await page.evaluate(() => window.heatwalk.walker))?.length ?? 0, 6);
  expect(legs[0].length).toBeGreaterThan(1.5 * legs[0].straight);
});

test('distances inside are saved, with tetrahedra that open again', async ({ heatwalk, page }) => {
  await openCube(heatwalk);
  const section = await openSection(page, 'export');
  const saved = async (kind: string) => {
    await section.getByRole('combobox', { name: 'Distances' }).selectOption(kind);
    const downloading = page.waitForEvent('download');
    await section.getByRole('button', { name: 'Save distances' }).click();
    const download = await downloading;
    expect(download.suggestedFilename()).toBe(`cube.distances.${kind}`);
    return readFile(await download.path());
  };
  const rows = (await saved('csv')).toString().trim().split('\n').slice(1);
  expect(rows).toHaveLength((N + 1) ** 3);
  for (const row of rows) {
    const [vertex, distance] = row.split(',').map(Number);
    // Along straight lines, all of which are in the cube.
    const steps = [vertex % (N + 1), Math.floor(vertex / (N + 1)) % (N + 1), Math.floor(vertex / (N + 1) ** 2)];
    expect(distance).toBeCloseTo(Math.hypot(...steps) / N, 12);
  }
  const files = [await saved('vtu'), await saved('msh')];
  const ofSurfaces = section.getByRole('group').filter({ hasText: 'This is for surfaces, not for the inside' });
  await expect(ofSurfaces).toHaveCount(2);
  for (const name of ['Measure isolines', 'Save isolines', 'Save tracks'])
    await expect(ofSurfaces.getByRole('button', { name })).toBeDisabled();
  for (const [index, name] of ['again.vtu', 'again.msh'].entries()) {
    await heatwalk.dropAndOpen([[name, files[index]]]);
    expect((await heatwalk.mesh()).tetrahedra).toBe(6 * N ** 3);
  }
});
