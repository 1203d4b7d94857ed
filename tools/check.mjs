// npm run check: format, lint, types, documentation, cycles and spelling, of Rust (native and wasm32) and of TypeScript;
// licenses and advisories of the crates that it builds on.

import { buildModules } from './bundle.mjs';
import { lint, lintTheRest } from './checks.mjs';
import { prepare, requireDeny } from './needs.mjs';
import { attempt, run } from './steps.mjs';

prepare();
await lint(buildModules);
lintTheRest();

const deny = requireDeny();
const remedy = 'Take another crate, or say in deny.toml why this one may stay.';
run('Checking licenses and sources of crates', deny, ['check', 'bans', 'licenses', 'sources'], remedy);
if (attempt('Fetching the advisories on crates', deny, ['fetch', 'db'])) {
  run('Checking advisories on crates', deny, ['check', 'advisories'], remedy);
} else {
  console.log('They cannot be reached: not checked.');
}
