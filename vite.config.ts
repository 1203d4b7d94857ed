import { defineConfig } from 'vite';
import { docs } from './tools/vite/docs.ts';
import { host } from './tools/vite/host.ts';
import { meshes } from './tools/vite/meshes.ts';
import { offline, OFFLINE_WORKER } from './tools/vite/offline.ts';
import { policy } from './tools/vite/policy.ts';
import { schemes } from './tools/vite/schemes.ts';

/** d3-scale-chromatic makes its other color schemes by these when it is loaded, wanted or not. */
const SCHEME_MAKERS = ['colors', 'ramp', 'ramp$1', 'rgb', 'cubehelix$1', 'interpolateCubehelixLong'];

/** What other pages and the browser ask for by name. */
const NAMED = new Set<string>([OFFLINE_WORKER, 'embed']);

export default defineConfig({
  // Relative addresses, so that a build serves from any sub-path.
  base: './',
  worker: { format: 'es' },
  assetsInclude: ['**/*.ply.gz'],
  plugins: [docs(import.meta.dirname), host(), meshes(), policy(), offline(), schemes()],
  build: {
    target: 'es2022',
    outDir: 'dist',
    rolldownOptions: {
      input: { index: 'index.html', [OFFLINE_WORKER]: 'web/offline/worker.ts', embed: 'web/embed.ts' },
      output: {
        // One file of what the first picture needs: the wait for texts would part it into many.
        codeSplitting: { groups: [{ name: 'page', test: /\/web\/main\.ts$/ }] },
        entryFileNames: ({ name }) => (NAMED.has(name) ? '[name].js' : 'assets/[name]-[hash].js'),
      },
      // The last is a module for other pages.
      preserveEntrySignatures: 'exports-only',
      treeshake: { manualPureFunctions: SCHEME_MAKERS },
    },
  },
});
