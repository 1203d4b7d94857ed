/** The documents of docs/ as pages beside the page, with a search over all of them. */
import { readdirSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import GithubSlugger from 'github-slugger';
import MarkdownIt, { type Token } from 'markdown-it';
import type { Plugin } from 'vite';
import type { Section } from '../../web/docs/section.ts';
import { licensesOf } from './licenses.ts';
import { DOCUMENT_POLICY } from './policy.ts';

/** In the order of the index; what is not named comes last. */
const ORDER = [
  'page',
  'program',
  'python',
  'npm',
  'datasets',
  'method',
  'accuracy',
  'benchmarks',
  'table1',
  'gallery',
  'scripting',
  'embedding',
  'hosting',
  'accessibility',
  'reliability',
  'architecture',
  'notes',
];
const IMAGE_TYPES: Record<string, string> = {
  '.jpg': 'image/jpeg',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.webp': 'image/webp',
};

const TYPES: Record<string, string> = {
  ...IMAGE_TYPES,
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.json': 'application/json',
};

/** Where the pages are, relative to the page. */
const FOLDER = 'docs';
const SEARCH = 'web/docs/search.ts';
/** The colors of the page, and what only documents have. */
const STYLES = ['web/style/colors.css', 'web/docs/docs.css'];
const STYLE = 'docs.css';

interface Page {
  name: string;
  title: string;
  html: string;
}

function rank(name: string): number {
  return ORDER.includes(name) ? ORDER.indexOf(name) : ORDER.length;
}

/**
 * The documents of a folder: `pages` by name with title and HTML, `sections` of all of them in order, each with the plain
 * text below its heading. Headings have the identifiers that GitHub gives them.
 */
export function readDocuments(folder: string): { pages: Page[]; sections: Section[] } {
  const names = readdirSync(folder)
    .filter((file) => file.endsWith('.md'))
    .map((file) => file.slice(0, -'.md'.length))
    .toSorted((a, b) => rank(a) - rank(b) || a.localeCompare(b));
  const pages: Page[] = [];
  const sections: Section[] = [];
  for (const name of names) {
    const document = render(readFileSync(join(folder, `${name}.md`), 'utf8'));
    pages.push({ name, title: document.title, html: document.html });
    for (const { id, heading, text } of document.sections) {
      sections.push({ page: name, title: document.title, id, heading, text });
    }
  }
  return { pages, sections };
}

function render(markdown: string) {
  const converter = new MarkdownIt({ linkify: true });
  const slugs = new GithubSlugger();
  const tokens = converter.parse(markdown, {});
  const sections: Pick<Section, 'id' | 'heading' | 'text'>[] = [];
  tokens.forEach((token, i) => {
    if (token.type === 'heading_open') {
      const heading = plain(tokens[i + 1]);
      const id = slugs.slug(heading);
      token.attrSet('id', id);
      sections.push({ id, heading, text: '' });
    } else if (token.type === 'inline' && tokens[i - 1].type !== 'heading_open') {
      const section = sections.at(-1);
      if (section) section.text += `${plain(token)} `;
    }
    for (const link of token.children ?? []) {
      const address = link.type === 'link_open' ? link.attrGet('href') : null;
      if (address) link.attrSet('href', String(address).replace(/^([\w-]+)\.md(?=#|$)/, '$1.html'));
    }
  });
  // A table may be wider than a phone.
  const html = converter.renderer
    .render(tokens, converter.options, {})
    .replaceAll('<table>', '<div class="table"><table>')
    .replaceAll('</table>', '</table></div>')
    // Styles of single elements are not allowed.
    .replaceAll(/ style="text-align:(\w+)"/g, ' class="$1"');
  return { title: sections[0].heading, html, sections };
}

function plain({ children }: Token): string {
  return (children ?? []).map(({ type, content }) => (type === 'softbreak' ? ' ' : content)).join('');
}

function pageOf({ title, html }: Omit<Page, 'name'>, pages: Page[], here: string, search: string): string {
  const links = pages.map(({ name, title: other }) => {
    const current = name === here ? ' aria-current="page"' : '';
    return `<li><a href="./${name}.html"${current}>${escaped(other)}</a></li>`;
  });
  return shell(
    `${escaped(title)} – Heatwalk`,
    `<meta http-equiv="Content-Security-Policy" content="${DOCUMENT_POLICY}">
<link rel="stylesheet" href="./${STYLE}">
<script type="module" src="${search}"></script>`,
    `<nav aria-label="Documents">
<a class="home" href="../">Heatwalk</a>
<input type="search" placeholder="Search" aria-label="Search in all documents" autocomplete="off">
<ul class="found" hidden></ul>
<ul>
${links.join('\n')}
</ul>
</nav>
<main>
${html}</main>`,
  );
}

function shell(title: string, head: string, body: string): string {
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark">
<title>${title}</title>
${head}
</head>
<body>
${body}
</body>
</html>
`;
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
}

/** All files of `docs/` but for the script of the search, which pages name so: contents by path in that folder. */
function filesOf(folder: string, search: string): Map<string, string | Uint8Array> {
  const { pages, sections } = readDocuments(folder);
  const overview = pages.map(({ name, title }) => `<li><a href="./${name}.html">${escaped(title)}</a></li>`).join('\n');
  const index = { title: 'Documents', html: `<h1>Documents</h1>\n<ul>\n${overview}\n</ul>\n` };
  const files = new Map<string, string | Uint8Array>([['index.html', pageOf(index, pages, '', search)]]);
  for (const page of pages) files.set(`${page.name}.html`, pageOf(page, pages, page.name, search));
  const licenses = { title: 'Licenses', html: licensesOf(join(folder, '..')) };
  files.set('licenses.html', pageOf(licenses, pages, '', search));
  files.set(STYLE, styleOf(folder));
  files.set('sections.json', JSON.stringify(sections));
  for (const path of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (extname(path) in IMAGE_TYPES) files.set(path.replaceAll('\\', '/'), readFileSync(join(folder, path)));
  }
  return files;
}

function styleOf(folder: string): string {
  return STYLES.map((path) => readFileSync(join(folder, '..', path), 'utf8')).join('\n');
}

/** All documents as one page of HTML, without images. Headings have the names of their documents and `--` before their own. */
export function onePage(folder: string): string {
  const { pages } = readDocuments(folder);
  const articles = pages.map(({ name, html }) => {
    const own = html
      .replaceAll(/<(h\d) id="([^"]*)"/g, `<$1 id="${name}--$2"`)
      .replaceAll(/href="#([^"]*)"/g, `href="#${name}--$1"`)
      .replaceAll(/href="([\w-]+)\.html(?:#([^"]*))?"/g, (_, page: string, heading?: string) =>
        heading === undefined ? `href="#${page}"` : `href="#${page}--${heading}"`,
      )
      .replaceAll(/<img[^>]*alt="([^"]*)"[^>]*>/g, '<em>$1</em>');
    return `<article id="${name}">\n${own}</article>`;
  });
  articles.push(`<article id="licenses">\n${licensesOf(join(folder, '..'))}</article>`);
  const links = pages.map(({ name, title }) => `<li><a href="#${name}">${escaped(title)}</a></li>`);
  return shell(
    'Documents – Heatwalk',
    `<style>${styleOf(folder)}</style>`,
    `<nav aria-label="Documents">
<ul>
${links.join('\n')}
</ul>
</nav>
<main>
${articles.join('\n')}
</main>`,
  );
}

/** The style that is in that page. */
export function styleWithin(root: string): string {
  return styleOf(join(root, 'docs'));
}

const VIRTUAL = 'virtual:documents';

/** Puts them into the page in one file. */
export function documentsWithin(root: string): Plugin {
  return {
    name: 'heatwalk-documents-within',
    resolveId: (source) => (source === VIRTUAL ? `\0${VIRTUAL}` : null),
    load: (id) => (id === `\0${VIRTUAL}` ? `export default ${JSON.stringify(onePage(join(root, 'docs')))}` : null),
  };
}

export function docs(root: string): Plugin {
  const folder = join(root, 'docs');
  let isBuild = false;
  return {
    name: 'heatwalk-docs',
    configResolved({ command }) {
      isBuild = command === 'build';
    },
    buildStart() {
      if (isBuild) this.emitFile({ type: 'chunk', id: join(root, SEARCH), fileName: `${FOLDER}/search.js` });
    },
    generateBundle() {
      for (const [path, source] of filesOf(folder, './search.js'))
        this.emitFile({ type: 'asset', fileName: `${FOLDER}/${path}`, source });
    },
    configureServer(server) {
      server.middlewares.use(`/${FOLDER}`, (request, response, next) => {
        const path = new URL(request.url ?? '', 'http://localhost').pathname.slice(1) || 'index.html';
        const content = filesOf(folder, `/${SEARCH}`).get(path);
        if (content === undefined) return next();
        response.setHeader('Content-Type', TYPES[extname(path)]);
        response.end(content);
      });
    },
  };
}
