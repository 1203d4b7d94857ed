import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { readDocuments } from '../../tools/vite/docs';
import { addressOf, SECTIONS, SETTINGS } from '../../web/ui/help/settings';

const { pages, sections } = readDocuments(join(import.meta.dirname, '../../docs'));

test('every explanation leads to a heading of the documents', () => {
  const addresses = new Set([
    ...pages.map(({ name }) => `./docs/${name}.html`),
    ...sections.map(({ page, id }) => `./docs/${page}.html#${id}`),
  ]);
  const seen = [
    ...Object.values(SECTIONS),
    ...Object.values(SETTINGS).flatMap((lines) => Object.values(lines).map(({ see }) => see)),
  ];
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

test('headings have the names that GitHub gives them, one each', () => {
  expect(sections).toContainEqual(
    expect.objectContaining({ page: 'method', id: 'operator-the-intrinsic-delaunay-triangulation' }),
  );
  const all = sections.map(({ page, id }) => `${page}#${id}`);
  expect(new Set(all).size).toBe(all.length);
});
