import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { expect, test } from '@playwright/test';

/** What `tools/cycles.mjs` says of these files. */
function check(files: Readonly<Record<string, string>>) {
  const folder = mkdtempSync(join(tmpdir(), 'heatwalk-cycles-'));
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  }
  const { status, stderr } = spawnSync(process.execPath, ['tools/cycles.mjs', folder], { encoding: 'utf8' });
  rmSync(folder, { recursive: true });
  return { passes: status === 0, said: stderr };
}

test('a cycle of files is named with files and lines, types included', () => {
  const { passes, said } = check({
    'a.ts': "import { b } from './b';\nexport const a = b;\n",
    'b.ts': "\nimport type { C } from './c';\nexport const b = 1 as unknown as C;\n",
    'c.ts': "export type C = typeof import('./a').a;\n",
  });
  expect(passes).toBe(false);
  expect(said).toContain('a.ts → b.ts → c.ts → a.ts');
  expect(said).toMatch(/b\.ts:2 imports .*c\.ts/);
});

test('folders whose files import each other are a cycle, though no files are', () => {
  const files = {
    'panel/dom.ts': 'export const h = 1;\n',
    'panel/sources.ts': "import { edit } from '../input/edit';\nedit();\n",
    'input/edit.ts': 'export const edit = (): void => undefined;\n',
    'input/drop.ts': "import { h } from '../panel/dom';\nexport const drop = h;\n",
  };
  const { passes, said } = check(files);
  expect(passes).toBe(false);
  expect(said).toMatch(/input → panel → input|panel → input → panel/);
  expect(check({ ...files, 'input/drop.ts': '' }).passes).toBe(true);
});

test('a worker that is started is an import', () => {
  const start = "new Worker(new URL('./worker.ts', import.meta.url));\n";
  const worker = "import { b } from './page';\nb();\n";
  expect(check({ 'page.ts': start, 'worker.ts': worker }).passes).toBe(false);
  expect(check({ 'page.ts': start, 'worker.ts': '' }).passes).toBe(true);
});
