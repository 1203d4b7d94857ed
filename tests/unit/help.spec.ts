import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { onePage, readDocuments } from '../../tools/vite/docs';
import { addressOf } from '../../web/ui/help/documents';
import { explanationOf, SECTIONS, SETTINGS } from '../../web/ui/help/settings';

const FOLDER = join(import.meta.dirname, '../../docs');
const { pages, sections } = readDocuments(FOLDER);
const seen = [
  ...Object.values(SECTIONS),
  ...Object.entries(SETTINGS).flatMap(([section, lines]) =>
    Object.keys(lines).map((name) => explanationOf(section, name)?.see ?? ''),
  ),
];

test('every explanation leads to a heading of the documents', () => {
  const addresses = new Set([
    ...pages.map(({ name }) => `./docs/${name}.html`),
    ...sections.map(({ page, id }) => `./docs/${page}.html#${id}`),
  ]);
  expect(seen.map(addressOf).filter((address) => !addresses.has(address))).toEqual([]);
});

test('links between documents lead to headings that there are', () => {
  const ids = new Set(sections.map(({ page, id }) => `${page}.html#${id}`));
  const broken = pages.flatMap(({ name, html }) =>
    [...html.matchAll(/href="([^":]*)"/g)]
      .map(([, address]) => (address.startsWith('#') ? `${name}.html${address}` : address))
      .filter((address) =>
        address.includes('#') ? !ids.has(address) : !pages.some((page) => address === `${page.name}.html`),
      )
      .map((address) => `${name}: ${address}`),
  );
  expect(broken).toEqual([]);
});

test('the documents on one page have each heading once, and every explanation and every link leads to one', () => {
  const html = onePage(FOLDER);
  const ids = [...html.matchAll(/ id="([^"]*)"/g)].map(([, id]) => id);
  // One more is the list of licenses.
  expect(ids).toHaveLength(pages.length + sections.length + 1);
  expect(ids).toContain('licenses');
  expect(new Set(ids).size).toBe(ids.length);
  const links = [...html.matchAll(/href="([^":]*)"/g)].map(([, address]) => address);
  const wanted = [...links, ...seen.map((see) => `#${see.replace('#', '--')}`)];
  expect(wanted.filter((address) => !address.startsWith('#') || !ids.includes(address.slice(1)))).toEqual([]);
  expect(html).not.toContain('<img');
});

test('headings have the names that GitHub gives them, one each', () => {
  expect(sections).toContainEqual(
    expect.objectContaining({ page: 'method', id: 'operator-the-intrinsic-delaunay-triangulation' }),
  );
  const all = sections.map(({ page, id }) => `${page}#${id}`);
  expect(new Set(all).size).toBe(all.length);
});
