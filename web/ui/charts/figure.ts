import { save } from '../../view/picture';
import { h } from '../dom';
import { type Chart, csvOf, plot, svgFile, THEMED } from './plot';
import { t } from '../../texts';

/** A chart with the buttons that save it. */
export function figure(chart: Chart, name: string): HTMLElement {
  const file = `${name} ${String(chart.title).toLowerCase()}`;
  const button = (kind: 'SVG' | 'CSV', blob: () => Blob) =>
    h(
      'button',
      {
        class: 'small',
        'aria-label': t`Save ${chart.title} as ${kind}`,
        onclick: () => save(blob(), `${file}.${kind.toLowerCase()}`),
      },
      kind,
    );
  return h(
    'figure',
    { class: 'chart' },
    plot(chart, THEMED),
    h(
      'div',
      {},
      button('SVG', () => svgFile(chart)),
      button('CSV', () => new Blob([csvOf(chart)], { type: 'text/csv' })),
    ),
  );
}
