/** Lines on the settings of the panel, below each of them. */
import { h } from '../dom';
import { addressOf } from './documents';
import { explanationOf, SECTIONS } from './settings';
import { Phrase, t, type Words } from '../../texts';

/** The name that a setting has in the panel. */
function nameOf(field: Element): string {
  return field.querySelector('span')?.textContent.trim() ?? '';
}

function isExplained(element: Element): boolean {
  return element.nextElementSibling?.classList.contains('explanation') ?? false;
}

/** Shows a line below every setting that has none yet, and a link to its documents below every heading. */
export function explain(panel: HTMLElement): void {
  for (const section of panel.querySelectorAll<HTMLElement>('details[id^="section-"]')) {
    const id = section.id.replace('section-', '');
    const summary = section.querySelector('summary');
    const see = SECTIONS[id];
    if (summary && see !== undefined && !isExplained(summary)) {
      summary.after(
        h('p', { class: 'explanation' }, link(see, t`More about ${new Phrase(() => summary.textContent)}`)),
      );
    }
    for (const field of section.querySelectorAll<HTMLElement>('.field')) {
      const name = nameOf(field);
      const explanation = explanationOf(id, name);
      if (!explanation || isExplained(field)) continue;
      const line = h(
        'p',
        { class: 'explanation' },
        explanation.line,
        ' ',
        link(explanation.see, t`More about ${new Phrase(() => nameOf(field))}`),
      );
      line.hidden = field.hidden;
      field.after(line);
      // A setting that does not apply takes its line along.
      new MutationObserver(() => (line.hidden = field.hidden)).observe(field, { attributeFilter: ['hidden'] });
    }
  }
}

function link(see: string, name: Words): HTMLElement {
  return h(
    'a',
    { class: 'about', href: addressOf(see), target: '_blank', rel: 'noopener', 'aria-label': name },
    t('more'),
  );
}
