import { defineConfig } from 'vite';

export default defineConfig({
  // Relative addresses, so that a build serves from any sub-path.
  base: './',
  worker: { format: 'es' },
  assetsInclude: ['**/*.ply.gz'],
  build: { target: 'es2022', outDir: 'dist' },
});
