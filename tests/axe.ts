/** What axe, a checker of accessibility, finds on a page. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import type axe from 'axe-core';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

export async function violations(page: Page): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(AXE);
  return page.evaluate(async () => {
    // Of WCAG 2.2, and off unless it is asked for.
    const rules = { 'target-size': { enabled: true } };
    const { violations: found } = await (globalThis as unknown as { axe: typeof axe }).axe.run({ rules });
    const all = found.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 120)}`));
    // Like pins on a map, places of tapes are as near to each other as what they mark: WCAG 2.5.8 leaves these out.
    return all.filter((each) => !each.startsWith('target-size: <button class="tape-place"'));
  });
}
