// npm run check: format, lint, types, documentation, cycles and spelling, of Rust (native and wasm32) and of TypeScript;
// licenses of the crates that it builds on, and advisories on these and on npm packages.

import { spawnSync } from 'node:child_process';
import { buildModules } from './bundle.mjs';
import { lint, lintTheRest } from './checks.mjs';
import { prepare, requireDeny } from './needs.mjs';
import { attempt, fail, root, run } from './steps.mjs';

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

console.log('\n— Checking advisories on npm packages');
const { vulnerabilities } = audited();
if (!vulnerabilities) console.log('They cannot be reached: not checked.');
else if (Object.keys(vulnerabilities).length > 0)
  fail(`There are advisories on ${Object.keys(vulnerabilities).join(', ')}: "npm audit" tells them.`);

/** What npm tells of them, where the registry answers. */
function audited() {
  const { stdout } = spawnSync('npm', ['audit', '--json'], { cwd: root, encoding: 'utf8' });
  try {
    return JSON.parse(stdout);
  } catch {
    return {};
  }
}
