import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import type { Plugin } from 'vite';
import { styleWithin } from './docs.ts';
import { withPolicy } from './policy.ts';

const MODULE = /\.wasm\?url$/;
const REPLACED = /\/web\/(solver\/spawn|ui\/help\/documents)\.ts$/;

/** wasm modules as packed text, which is a third of their size, with addresses of their own; not for workers, which have to listen at once. */
export function packedModules(): Plugin {
  return {
    name: 'heatwalk-packed-modules',
    enforce: 'pre',
    async load(id) {
      if (!MODULE.test(id)) return null;
      const packed = gzipSync(await readFile(id.replace(/\?url$/, '')), { level: 9 }).toString('base64');
      return [
        `const packed = Uint8Array.from(atob('${packed}'), (letter) => letter.charCodeAt(0));`,
        "const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));",
        "const headers = { 'Content-Type': 'application/wasm' };",
        'export default URL.createObjectURL(await new Response(stream, { headers }).blob());',
      ].join('\n');
    },
  };
}

/** The page with its style, its script and its worker in one HTML file. Nothing is installed or kept from there. */
export function singleFile(root: string): Plugin {
  return {
    name: 'heatwalk-single-file',
    apply: 'build',
    enforce: 'post',
    resolveId: {
      order: 'pre',
      async handler(source, importer) {
        // What lies beside other builds is in this one.
        const found = await this.resolve(source.replace('&no-inline', ''), importer, { skipSelf: true });
        return found && REPLACED.test(found.id) ? found.id.replace(/\.ts$/, '.single.ts') : found;
      },
    },
    transformIndexHtml: {
      order: 'pre',
      handler: (html) =>
        html.replaceAll(
          /\s*<(link rel="(manifest|apple-touch-icon)"|meta\s+(property="og:|name="twitter:))[^>]*>/g,
          '',
        ),
    },
    generateBundle: {
      // Vite has to have put in place what loads modules.
      order: 'post',
      handler(_, bundle) {
        const page = bundle['index.html'];
        if (page?.type !== 'asset') throw new Error('The build has no page.');
        let html = String(page.source);
        const scripts: string[] = [];
        // The documents are a page that this one makes, under its policy.
        const styles = [styleWithin(root)];
        for (const file of Object.values(bundle)) {
          if (file === page) continue;
          const text = file.type === 'chunk' ? file.code.replaceAll('</script', '<\\/script') : String(file.source);
          const inside = file.type === 'chunk' ? `<script type="module">${text}</script>` : `<style>${text}</style>`;
          (file.type === 'chunk' ? scripts : styles).push(text);
          const tag = new RegExp(
            `<script[^>]*${escaped(file.fileName)}"[^>]*></script>|<link[^>]*${escaped(file.fileName)}"[^>]*>`,
          );
          if (!tag.test(html)) throw new Error(`The page does not name ${file.fileName}.`);
          html = html.replace(tag, () => inside);
          delete bundle[file.fileName];
        }
        page.source = withPolicy(html, scripts, styles);
        page.fileName = 'heatwalk.html';
      },
    },
  };
}

function escaped(text: string): string {
  return text.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&');
}
