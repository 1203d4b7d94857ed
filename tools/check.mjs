// npm run check: format, lint, types, documentation, cycles and spelling, of Rust (native and wasm32) and of TypeScript.

import { buildModules } from './bundle.mjs';
import { lint, lintTheRest } from './checks.mjs';
import { prepare } from './needs.mjs';

prepare();
lint(buildModules);
lintTheRest();
