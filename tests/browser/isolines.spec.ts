import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { type Mesh, off } from '../fixtures';
import { expect, openSection, test } from '../page';

/** An open tube around Z, of quads in rings, in millimeters. */
function tube(radius: number, height: number, around: number, rings: number): Mesh {
  const positions: Mesh['positions'] = [];
  const triangles: Mesh['triangles'] = [];
  for (let ring = 0; ring <= rings; ring++) {
    for (let index = 0; index < around; index++) {
      const angle = (2 * Math.PI * index) / around;
      positions.push([radius * Math.cos(angle), radius * Math.sin(angle), (height * ring) / rings]);
      if (ring === rings) continue;
      const [a, b] = [index, (index + 1) % around].map((at) => ring * around + at);
      triangles.push([a, b, b + around], [a, b + around, a + around]);
    }
  }
  return { positions, triangles };
}

/** The sides of a box at its corner in the origin, 60 long, of squares of 20, in millimeters. */
function corner(): Mesh {
  const positions: Mesh['positions'] = [];
  const triangles: Mesh['triangles'] = [];
  const vertex = (place: [number, number, number]) => {
    const known = positions.findIndex((other) => other.join() === place.join());
    return known < 0 ? positions.push(place) - 1 : known;
  };
  for (const side of [0, 1, 2]) {
    const at = (u: number, v: number) => {
      const place: [number, number, number] = [0, 0, 0];
      [place[(side + 1) % 3], place[(side + 2) % 3]] = [20 * u, 20 * v];
      return vertex(place);
    };
    for (let u = 0; u < 3; u++) {
      for (let v = 0; v < 3; v++) {
        const [a, b, c, d] = [at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)];
        triangles.push([a, b, c], [a, c, d]);
      }
    }
  }
  return { positions, triangles };
}

async function savedDxf(page: Page): Promise<string> {
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save isolines' }).click();
  return (await readFile(await (await downloading).path())).toString();
}

test('all rings of a tube are in the drawing of its unrolled strips, and nothing of no area', async ({ heatwalk }) => {
  const { page } = heatwalk;
  await heatwalk.open('#v=1&m=file&name=tube.off&unit=mm&method=exact&sets=boundary:0&s=none&w=none&iso=10');
  await heatwalk.dropAndOpen([['tube.off', off(tube(20, 100, 96, 40))]]);
  await heatwalk.settled();
  const section = await openSection(page, 'export');
  await section.getByRole('combobox', { name: 'File', exact: true }).selectOption('unrolled.dxf');
  const layers = (await savedDxf(page)).match(/(?<=POLYLINE\n\s*8\n).*/g);
  expect(layers).toEqual([0, 10, 20, 30, 40, 50, 60, 70, 80, 90].map((from, strip) => `STRIP_${strip}_${from}`));
  await expect(section.getByRole('status')).toHaveText('');
  // Of the rim at the largest distance there is one curve, where it is asked for.
  await page.getByLabel('Isolines at (mm)').fill('50, 100');
  await page.getByRole('button', { name: 'Measure isolines' }).click();
  await expect(section.locator('tbody tr').last().locator('td')).toHaveText(['100', '126', '12600', '1 of 1']);
});

test('isolines of an exact distance are as long as circles are, and what is not there is refused in few digits', async ({
  heatwalk,
}) => {
  const { page } = heatwalk;
  await heatwalk.open('#v=1&m=file&name=corner.off&method=exact&s=0&w=none&iso=10,50');
  await heatwalk.dropAndOpen([['corner.off', off(corner())]]);
  await heatwalk.settled();
  const section = await openSection(page, 'export');
  const measure = page.getByRole('button', { name: 'Measure isolines' });
  await measure.click();
  await expect(section.locator('tbody tr').first().locator('td')).toHaveText(['10', '47.1', '236', '1 of 1']);
  await expect(section.getByRole('status')).toHaveText(/^Curves follow the exact distance/);

  // The values of before do not stay beside what is refused.
  await page.getByLabel('Isolines at').fill('1000');
  await measure.click();
  await expect(section.getByRole('status')).toHaveText(
    'A spacing of 1000 mm is not below the largest distance, 84.9 mm (assumed). Give a smaller one.',
  );
  await expect(section.locator('tbody')).toHaveCount(0);

  await page.getByLabel('Isolines at').fill('0.001');
  await measure.click();
  await expect(section.getByRole('status')).toHaveText(/^These are \d+ isolines, and 10000 are .* spacing\.$/);

  // The strips at the source are parts of a cone; a source beside it leaves its tip within others.
  await heatwalk.open('#v=1&m=file&name=corner.off&method=exact&s=5&w=none&iso=5,15,25,35,60');
  await heatwalk.dropAndOpen([['corner.off', off(corner())]]);
  await heatwalk.settled();
  await openSection(page, 'export');
  await section.getByRole('combobox', { name: 'File', exact: true }).selectOption('unrolled.dxf');
  await savedDxf(page);
  await expect(section.getByRole('status')).toHaveText(/: the strips from 35 mm \(assumed\) to 60 mm\. /);

  // By heat, curves are chords.
  await heatwalk.open('#v=1&m=file&name=corner.off&method=heat&near=0&refine=0&s=0&w=none&iso=10,50');
  await heatwalk.dropAndOpen([['corner.off', off(corner())]]);
  await heatwalk.settled();
  await openSection(page, 'export');
  await measure.click();
  await expect(section.getByRole('status')).toHaveText(/^Curves are straight within triangles/);
});
