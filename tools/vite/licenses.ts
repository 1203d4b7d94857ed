/** What the page is made of beside its own source, crates and npm packages, with their licenses: as HTML. */
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

interface Part {
  name: string;
  version: string;
  license: string;
  /** Where its files are. */
  folder: string;
}

/** Of `cargo metadata`, as far as it is read here. */
interface Metadata {
  packages: {
    id: string;
    name: string;
    version: string;
    license: string | null;
    source: string | null;
    manifest_path: string;
    targets: { kind: string[] }[];
  }[];
  workspace_members: string[];
  resolve: { nodes: { id: string; deps: { pkg: string; dep_kinds: { kind: string | null }[] }[] }[] };
}

/** Of package-lock.json. */
interface Lock {
  packages: Record<string, { version: string; license?: string; dev?: boolean; optional?: boolean }>;
}

/** The one module of the workspace that no page loads. */
const PYTHON = 'heatwalk-python';
const TARGET = 'wasm32-unknown-unknown';
const LICENSE = /^(license|licence|copying|notice|unlicense)/i;
/** Of two licenses that one may choose from, that whose text has fewer conditions. */
const CHOSEN = /mit/i;

let html: string | undefined;

/** Made once: it does not change while the page is built or served. */
export function licensesOf(root: string): string {
  html ??= htmlOf([...crates(root), ...npmPackages(root)].toSorted((a, b) => a.name.localeCompare(b.name)));
  return html;
}

/** The crates of others that the page's wasm modules are linked from. */
function crates(root: string): Part[] {
  const asked = ['metadata', '--format-version', '1', '--locked', '--filter-platform', TARGET];
  const answer = execFileSync('cargo', asked, { cwd: root, encoding: 'utf8', maxBuffer: 1 << 28 });
  const { packages, workspace_members: own, resolve } = JSON.parse(answer) as Metadata;
  const nodes = new Map(resolve.nodes.map(({ id, deps }) => [id, deps]));
  const isModule = ({ id, name, targets }: Metadata['packages'][number]) =>
    own.includes(id) && name !== PYTHON && targets.some(({ kind }) => kind.includes('cdylib'));
  const reached = new Set(packages.filter(isModule).map(({ id }) => id));
  // A set is gone through with what is added meanwhile.
  for (const id of reached) {
    for (const { pkg, dep_kinds: kinds } of nodes.get(id) ?? [])
      if (kinds.some(({ kind }) => kind === null)) reached.add(pkg);
  }
  return packages
    .filter(({ id, source }) => source !== null && reached.has(id))
    .map(({ name, version, license, manifest_path: manifest }) => ({
      name,
      version,
      license: license ?? '',
      folder: dirname(manifest),
    }));
}

/** The npm packages that the page is built from. */
function npmPackages(root: string): Part[] {
  const { packages } = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8')) as Lock;
  return (
    Object.entries(packages)
      .filter(([path, { dev }]) => path !== '' && dev !== true && existsSync(join(root, path)))
      // Types are in no script.
      .filter(([path]) => !path.includes('/@types/'))
      .map(([path, { version, license }]) => ({
        name: path.replace(/^.*node_modules\//, ''),
        version,
        license: license ?? '',
        folder: join(root, path),
      }))
  );
}

function htmlOf(parts: readonly Part[]): string {
  const rows = parts.map(
    ({ name, version, license }) =>
      `<tr><td>${escaped(name)}</td><td>${escaped(version)}</td><td>${escaped(license)}</td></tr>`,
  );
  // Many have the same text but for its spaces.
  const texts = new Map<string, { names: string[]; text: string }>();
  for (const { name, folder } of parts) {
    for (const text of textsIn(folder)) {
      const key = text.replaceAll(/\s+/g, ' ').trim();
      const known = texts.get(key);
      if (known) known.names.push(name);
      else texts.set(key, { names: [name], text });
    }
  }
  const sections = [...texts.values()].map(
    ({ names, text }) => `<h2>${escaped([...new Set(names)].join(', '))}</h2>\n<pre>${escaped(text.trim())}</pre>`,
  );
  return `<h1>Licenses</h1>
<p>Heatwalk itself is licensed under MIT OR Apache-2.0. The page contains code of these crates and npm packages; where they let one
choose, the text of the chosen license is below.</p>
<div class="table"><table>
<thead><tr><th>name</th><th>version</th><th>license</th></tr></thead>
<tbody>
${rows.join('\n')}
</tbody></table></div>
${sections.join('\n')}
`;
}

function textsIn(folder: string): string[] {
  const names = readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.isFile() && LICENSE.test(entry.name))
    .map(({ name }) => name);
  const chosen = names.filter((name) => CHOSEN.test(name));
  return (chosen.length > 0 ? chosen : names).map((name) => readFileSync(join(folder, name), 'utf8'));
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
}
