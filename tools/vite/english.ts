/** Gives workers the texts in English: see web/texts/english.ts. */
import { join } from 'node:path';
import type { Plugin } from 'vite';

export function english(root: string): Plugin {
  return {
    name: 'heatwalk:english',
    enforce: 'pre',
    resolveId: (source) => (/(^|\/)texts$/.test(source) ? join(root, 'web/texts/english.ts') : null),
  };
}
