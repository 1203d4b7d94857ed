/** Lines that reproduce the distances, run as they stand by the program that the Rust tests have built. */
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { delimiter, join, resolve } from 'node:path';
import { armGlb } from '../animated';
import { expect, type HeatwalkPage, openSection, test } from '../page';

/** Of the largest distance: rounding alone, which is not the same in wasm. */
const ROUNDING = 1e-9;

const PROGRAMS = resolve('target/debug');
const RUNS = {
  env: { ...process.env, PATH: `${PROGRAMS}${delimiter}${process.env['PATH']}` },
  encoding: 'utf8',
} as const;

async function save({ page }: HeatwalkPage, folder: string): Promise<string> {
  const downloading = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save distances' }).click();
  const download = await downloading;
  const name = download.suggestedFilename();
  await download.saveAs(join(folder, name));
  return name;
}

/** What the page has saved and what its lines give, a value a vertex, in an empty folder that has the file of the mesh. */
async function reproduced(heatwalk: HeatwalkPage, files: readonly (readonly [string, string | Buffer])[] = []) {
  const { page } = heatwalk;
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await heatwalk.settled();
  const folder = await mkdtemp(join(tmpdir(), 'heatwalk-lines-'));
  for (const [name, content] of files) await writeFile(join(folder, name), content);
  const section = await openSection(page, 'export');
  const table = await readFile(join(folder, await save(heatwalk, folder)), 'utf8');
  await section.getByRole('button', { name: 'Copy lines' }).click();
  const field = section.getByLabel('Lines that reproduce the distances');
  await expect(section.getByRole('status')).toHaveText('Copied.');
  const lines = await field.inputValue();
  // What the lines say is to be saved first.
  const [, kind] = /"Save distances" as "([^"]+)"/.exec(lines) ?? [];
  if (kind) {
    await section.getByRole('combobox', { name: 'Distances' }).selectOption({ label: kind });
    await save(heatwalk, folder);
  }
  execFileSync('sh', ['-eu', '-c', lines], { ...RUNS, cwd: folder });
  const answer = await readFile(join(folder, 'distances.csv'), 'utf8');
  return { lines, folder, saved: valuesOf(table), answered: valuesOf(answer) };
}

function valuesOf(table: string): number[] {
  const rows = table.trim().split('\n').slice(1);
  return rows.map((row) => Number(row.split(',')[1]?.replace('inf', 'Infinity')));
}

function expectSame(kept: readonly number[], answered: readonly number[], nearness = ROUNDING): void {
  expect(answered).toHaveLength(kept.length);
  const finite = kept.filter(Number.isFinite);
  expect(finite.length).toBeGreaterThan(0);
  const largest = finite.reduce((one, other) => Math.max(one, other), 0);
  const differences = kept.map((value, vertex) =>
    value === answered[vertex] ? 0 : Math.abs(value - answered[vertex]),
  );
  expect(differences.reduce((one, other) => Math.max(one, other), 0) / largest).toBeLessThan(nearness);
}

/**
 * Where costs differ and in the march, ties decide which windows are kept and which waves pass first, and the last digits of sines
 * decide ties: vertices that move by 1e-15 move these distances by some 1e-4 in the program alone. A wrong axis or wall moves them by far more.
 */
const TIES = 2e-3;
/** The same by heat. */
const TIES_BY_HEAT = 1e-4;

/** Links, what their lines have to have, and how near their distances come. */
const LINKS: readonly (readonly [link: string, lines: RegExp, nearness?: number])[] = [
  ['m=torus', /^heatwalk distance shape:torus --source 7264 --method exact /],
  ['m=torus&refine=0&t=10&near=0&b=dirichlet', /--method heat --boundary dirichlet --t 10 --near 0 /],
  ['m=animal&method=propagation&windows=4&s=14829,12:0.2/0.3/0.5@0.1', /--source 12:0.2,0.3,0.5@0.1 .*--windows 4/],
  ['m=skull', /--part 0 /],
  ['m=hike', /^cat > weights\.csv /],
  ['m=village&slope=1', /walls\.csv .*--slope-cost tobler --up y /, TIES],
  ['m=village&slope=1&height=3&method=heat', /walls\.csv .*--height-cost 3 --up y --method heat /, TIES_BY_HEAT],
  ['m=terrain&slope=1&up=z', /--slope-cost tobler --up z /, TIES],
  ['m=teapot&bridge=off&refine=0', /--bridge off /],
  ['m=teapot&links=1&unit=mm&scale=2&s=420@1', /^# .*PLY, double.*\n.* --source 420@2 .*--link 1 /],
  ['m=bunny', /bunny\.distances\.ply/],
  ['m=pipe', /shape:pipe .*--method march/, TIES],
  [
    'm=torus&fill=5000&s=100:0.25/0.25/0.25/0.25&method=heat',
    /^heatwalk fill shape:torus --tetrahedra 5000 --output filled\.msh\n/,
  ],
];
for (const [link, expected, nearness] of LINKS) {
  test(`${link}: lines give the distances that the page has saved`, async ({ heatwalk }) => {
    await heatwalk.open(`#${link}`);
    const { lines, saved: ofPage, answered } = await reproduced(heatwalk);
    expect(lines).toMatch(expected);
    expectSame(ofPage, answered, nearness);
  });
}

test('lines of a pose and of a part are those of the file, from Python too', async ({ heatwalk }) => {
  const { page } = heatwalk;
  const name = "an arm's.glb";
  await heatwalk.open(`#v=1&m=file&name=${encodeURIComponent(name)}&s=30&p=0&clip=1&time=0.5&live=1&unit=cm`);
  await heatwalk.dropAndOpen([[name, armGlb()]]);
  const { lines, folder, saved: ofPage, answered } = await reproduced(heatwalk, [[name, armGlb()]]);
  expect(lines).toContain("'an arm'\\''s.glb' --part 0 --unit cm --animation 1 --time 0.5 --source 30 ");
  expectSame(ofPage, answered);

  const section = page.locator('#section-export');
  await section.getByRole('combobox', { name: 'Reproduce by' }).selectOption({ label: 'Python' });
  await section.getByRole('button', { name: 'Copy lines' }).click();
  const field = section.getByLabel('Lines that reproduce the distances');
  await expect(field).toHaveValue(/^import pathlib/);
  await writeFile(join(folder, 'lines.py'), await field.inputValue());
  // In the place of numpy, which not every machine has.
  const stub = ['class Rows:', '  def __getitem__(self, at): return []', 'def loadtxt(*a, **k): return Rows()', ''];
  await writeFile(join(folder, 'numpy.py'), stub.join('\n'));
  await rm(join(folder, 'distances.csv'));
  execFileSync('python3', ['lines.py'], { ...RUNS, cwd: folder });
  expect(valuesOf(await readFile(join(folder, 'distances.csv'), 'utf8'))).toEqual(answered);
});
