import { readFile } from 'node:fs/promises';
import { grid, type Mesh, off } from '../fixtures';
import { expect, test } from '../page';

/** The corners of a square at a height. */
function ring(half: number, z: number): Mesh['positions'] {
  return [
    [-half, -half, z],
    [half, -half, z],
    [half, half, z],
    [-half, half, z],
  ];
}

/** A torus: its tube is a square of 0.5, and its axis a square too. */
function frame(): Mesh {
  const positions = [ring(1, 0), ring(1.5, 0), ring(1.5, 0.5), ring(1, 0.5)].flat();
  const triangles: Mesh['triangles'] = [];
  for (let side = 0; side < 4; side++) {
    for (let k = 0; k < 4; k++) {
      const [a, b] = [4 * side + k, 4 * side + ((k + 1) % 4)];
      const [c, d] = [(b + 4) % 16, (a + 4) % 16];
      triangles.push([a, c, b], [a, d, c]);
    }
  }
  return { positions, triangles };
}

test('loops around a handle have lengths, and a file', async ({ heatwalk, page }) => {
  await heatwalk.openInSection('loops', 'frame.off', off(frame()), 'up=z&method=auto&w=none&s=0&open=measure');
  const loops = page.getByRole('switch', { name: 'Loops around handles' });
  await loops.check();
  await heatwalk.settled();
  // Around the tube and around the hole.
  await expect(page.getByText(/^2 loops\. The shortest: 2\b.* and 8\b/)).toBeVisible();
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('loops');
  await page.getByRole('combobox', { name: 'Loops' }).selectOption('obj');
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save loops' }).click();
  const text = (await readFile(await (await downloading).path())).toString();
  expect(text.match(/^g loop_\d$/gm)).toEqual(['g loop_1', 'g loop_2']);
  await loops.uncheck();
  await expect(page.getByText('2 loops.')).toBeHidden();
});

test('a surface without handles has none, in words', async ({ heatwalk, page }) => {
  const options = 'up=z&method=auto&w=none&s=0&open=measure&show=loops';
  await heatwalk.openInSection('loops', 'grid.off', off(grid(4)), options);
  await expect(page.getByText('The surface has no handle')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Save loops' })).toBeHidden();
});
