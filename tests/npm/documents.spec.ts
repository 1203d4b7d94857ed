/** The examples of the documents run, and their types hold. */
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { installed } from './installed';

const ROOT = join(import.meta.dirname, '..', '..');
const DOCUMENTS = ['docs/npm.md', 'README.md', 'crate/npm/package/README.md'];
const HOLDS = `import { ok } from 'node:assert';
console.assert = ok;
`;

const folder = installed();

function examples(document: string): string {
  const text = readFileSync(join(ROOT, document), 'utf8');
  const blocks = [...text.matchAll(/^```js\n(.*?)^```/gms)].map(([, block]) => block);
  expect(blocks.length, document).toBeGreaterThan(0);
  return blocks.join('\n');
}

for (const document of DOCUMENTS) {
  test(`the examples of ${document} run`, () => {
    const script = join(folder(), 'example.js');
    writeFileSync(script, HOLDS + examples(document));
    execFileSync(process.execPath, [script], { stdio: 'pipe' });
  });

  test(`the types of the examples of ${document} hold`, () => {
    writeFileSync(join(folder(), 'typed.ts'), `${examples(document)}\nexport {};\n`);
    const compiler = join(ROOT, 'node_modules', 'typescript', 'bin', 'tsc');
    const options = [
      '--noEmit',
      '--strict',
      '--target',
      'es2024',
      '--module',
      'nodenext',
      '--lib',
      'es2024,esnext,dom',
      '--types',
      '',
    ];
    try {
      execFileSync(process.execPath, [compiler, ...options, 'typed.ts'], {
        cwd: folder(),
        encoding: 'utf8',
        stdio: 'pipe',
      });
    } catch (error) {
      throw new Error((error as { stdout: string }).stdout, { cause: error });
    }
  });
}
