/** The page in one HTML file, which opens without a server. */
import { defineConfig } from 'vite';
import { documentsWithin } from './tools/vite/docs.ts';
import { host } from './tools/vite/host.ts';
import { meshes } from './tools/vite/meshes.ts';
import { packedModules, singleFile } from './tools/vite/single.ts';
import shared from './vite.config.ts';

/** Bytes; above that, files would lie beside the page. */
const ANY_SIZE = 2 ** 30;

export default defineConfig({
  base: './',
  publicDir: false,
  assetsInclude: shared.assetsInclude ?? [],
  plugins: [packedModules(), documentsWithin(import.meta.dirname), host(), meshes(), singleFile(import.meta.dirname)],
  // Chromium loads no modules from what a page of a file makes, but other scripts.
  worker: { format: 'iife', rolldownOptions: { output: { codeSplitting: false } } },
  build: {
    target: 'es2022',
    outDir: 'dist-single',
    assetsInlineLimit: ANY_SIZE,
    cssCodeSplit: false,
    chunkSizeWarningLimit: ANY_SIZE,
    rolldownOptions: { input: 'index.html', output: { codeSplitting: false } },
  },
});
