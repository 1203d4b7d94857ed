import { defineConfig } from 'vite';
import { docs } from './tools/docs.mjs';

/** d3-scale-chromatic makes each of its colour schemes by one of these when it is loaded, wanted or not. */
const SCHEME_MAKERS = ['colors', 'ramp', 'ramp$1', 'rgb', 'cubehelix$1', 'interpolateCubehelixLong'];

export default defineConfig({
  // Relative addresses, so that a build serves from any sub-path.
  base: './',
  worker: { format: 'es' },
  plugins: [docs(import.meta.dirname)],
  assetsInclude: ['**/*.ply.gz'],
  build: {
    target: 'es2022',
    outDir: 'dist',
    rolldownOptions: { treeshake: { manualPureFunctions: SCHEME_MAKERS } },
  },
});
