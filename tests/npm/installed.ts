import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from '@playwright/test';

/** A fresh folder in which the package is installed before the tests of a file begin, from what npm would publish. */
export function installed(): () => string {
  let folder = '';
  test.beforeAll(() => {
    const tarball = process.env['HEATWALK_PACKAGE'];
    if (!tarball) throw new Error('HEATWALK_PACKAGE names no package; npm test makes one');
    folder = mkdtempSync(join(tmpdir(), 'heatwalk-package-'));
    writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
    execFileSync('npm', ['install', '--offline', '--no-audit', '--no-fund', tarball], { cwd: folder, stdio: 'pipe' });
  });
  test.afterAll(() => rmSync(folder, { recursive: true, force: true }));
  return () => folder;
}
