/** A table in Markdown, whose columns stand to the right, but those of text. */
export function markdownTable(
  head: readonly string[],
  rows: readonly (readonly string[])[],
  isText: readonly number[] = [],
): string {
  const rule = head.map((_, index) => (isText.includes(index) ? '---' : '---:'));
  return [head, rule, ...rows].map((cells) => `| ${cells.join(' | ')} |\n`).join('');
}
