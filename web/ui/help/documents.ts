/** Where the documents are: beside the page. */

/** The address of a document, or of a heading of one after `#`; of all of them where it is empty. */
export function addressOf(see: string): string {
  if (see === '') return './docs/';
  const [page, heading] = see.split('#');
  return heading === undefined ? `./docs/${page}.html` : `./docs/${page}.html#${heading}`;
}
