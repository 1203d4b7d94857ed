/** The same as documents.ts where the page is one file: they are in it, all on one page. */
import documents from 'virtual:documents';

let page: string | undefined;

export function addressOf(see: string): string {
  page ??= URL.createObjectURL(new Blob([documents], { type: 'text/html' }));
  return `${page}#${see.replace('#', '--')}`;
}
