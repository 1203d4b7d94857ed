/** The search field of the documents: sections of all of them, best first. */
import MiniSearch from 'minisearch';
import type { Section } from './section';

const MOST_FOUND = 12;

const field = document.querySelector<HTMLInputElement>('input[type=search]');
const list = document.querySelector<HTMLUListElement>('.found');

/** Fetched when the field is used first. */
let index: Promise<MiniSearch<Section & { number: number }>> | null = null;

async function load(): Promise<MiniSearch<Section & { number: number }>> {
  const answer = await fetch('./sections.json');
  if (!answer.ok) throw new Error(`The documents could not be fetched: ${answer.status}.`);
  const sections = (await answer.json()) as Section[];
  const search = new MiniSearch<Section & { number: number }>({
    idField: 'number',
    fields: ['heading', 'title', 'text'],
    storeFields: ['page', 'title', 'id', 'heading'],
    searchOptions: { boost: { heading: 4, title: 2 }, prefix: true, fuzzy: 0.15, combineWith: 'AND' },
  });
  for (const [number, section] of sections.entries()) search.add({ ...section, number });
  return search;
}

async function find(words: string): Promise<Node[]> {
  index ??= load();
  const found = (await index).search(words).slice(0, MOST_FOUND);
  if (found.length === 0) return [item('Nothing was found.')];
  return found.map(({ page, title, id, heading }) => {
    const link = document.createElement('a');
    link.href = `./${page}.html#${id}`;
    link.textContent = heading === title ? title : `${title}: ${heading}`;
    return item(link);
  });
}

function item(content: string | Node): HTMLLIElement {
  const element = document.createElement('li');
  element.append(content);
  return element;
}

function showFound(): void {
  if (!field || !list) return;
  const words = field.value.trim();
  list.hidden = words === '';
  if (words === '') return;
  find(words)
    .catch((error: unknown) => {
      index = null;
      return [item(error instanceof Error ? error.message : String(error))];
    })
    .then((items) => {
      // What was typed meanwhile is answered by itself.
      if (words === field.value.trim()) list.replaceChildren(...items);
    })
    .catch(reportError);
}

field?.addEventListener('input', showFound);
// What was typed before this was loaded, or stood there when the reader left.
showFound();
