// npm run quick: format, lints, types, unit tests of the page, and the tests of the crates that changed since the last commit;
// where nothing did, of those that it changed.

import { buildModules } from './bundle.mjs';
import { lint } from './checks.mjs';
import { prepare } from './needs.mjs';
import { cargo, npmProgram, output, printTimes } from './steps.mjs';

const named = 'The message above names the test.';

prepare();
await lint(buildModules);
npmProgram('Running the unit tests of the page', '@playwright/test/cli.js', ['test', '--project=unit'], named, {
  HEATWALK_NO_PAGE: '1',
});
const changed = changedPackages();
if (changed.length > 0) {
  const chosen = changed.flatMap((name) => ['--package', name]);
  cargo(`Running the tests of ${changed.join(', ')}`, ['test', '--lib', '--bins', '--tests', ...chosen], named);
}
printTimes();

function changedPackages() {
  const uncommitted = [...paths('diff', '--name-only', 'HEAD'), ...paths('ls-files', '--others', '--exclude-standard')];
  const since = uncommitted.length > 0 ? uncommitted : paths('diff', '--name-only', 'HEAD~1');
  const folders = new Set(since.map((path) => /^crate\/([^/]+)\//.exec(path)?.[1]).filter(Boolean));
  const { packages } = JSON.parse(output('cargo', ['metadata', '--no-deps', '--format-version', '1']));
  return packages.filter(({ manifest_path: path }) => folders.has(path.split(/[\\/]/).at(-2))).map(({ name }) => name);
}

/** What git lists. */
function paths(...args) {
  return output('git', args)?.split('\n').filter(Boolean) ?? [];
}
