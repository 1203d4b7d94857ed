import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';
import type { KeptFiles } from '../../web/offline/files.ts';

/** The service worker, which is to lie beside the page: it serves what is in its own folder. */
export const OFFLINE_WORKER = 'offline';
const MARK = 'KEPT_FILES';

/** Tells the service worker which files the build has. */
export function offline(): Plugin {
  return {
    name: 'heatwalk-offline',
    apply: 'build',
    enforce: 'post',
    generateBundle(_, bundle) {
      const worker = bundle[`${OFFLINE_WORKER}.js`];
      const page = bundle['index.html'];
      const entry = Object.values(bundle).find(
        (file) => file.type === 'chunk' && file.isEntry && file.name === 'index',
      );
      if (worker?.type !== 'chunk' || page?.type !== 'asset' || !entry)
        throw new Error('The build has no page, or no service worker.');
      const inFolder = (folder: string) =>
        Object.keys(bundle)
          .filter((name) => name.startsWith(folder))
          .toSorted();
      const [files, documents] = [inFolder('assets/'), inFolder('docs/')];
      const hash = createHash('sha256');
      // Their names tell their content.
      hash.update([page.source, ...files].join('\n'));
      for (const name of documents) {
        const file = bundle[name];
        hash.update(`\n${name}\n`).update(file.type === 'chunk' ? file.code : file.source);
      }
      const build = hash.digest('hex').slice(0, 16);
      const kept: KeptFiles = { build, page: entry.fileName, files, documents };
      if (!worker.code.includes(MARK)) throw new Error(`The service worker does not read ${MARK}.`);
      worker.code = worker.code.replace(MARK, () => JSON.stringify(kept));
    },
  };
}
