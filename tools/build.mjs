// npm run build: a static site in dist/ that works from any folder of any static host.
// npm run build:single: the same in one file, dist-single/heatwalk.html, which opens without a host.

import { buildSite, bundleSingle, publishModules } from './bundle.mjs';
import { prepare } from './needs.mjs';

prepare();
publishModules();
if (process.argv.includes('--single')) bundleSingle();
else buildSite();
