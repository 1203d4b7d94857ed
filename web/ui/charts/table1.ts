/** Table 1 of the report, measured on this device when it is asked for. */
import { measureTable } from '../../solver/table1';
import { REPORT, type Times } from '../../state/report';
import { csvOf, markdownOf, milliseconds, reportOf, type Row } from '../../state/table1';
import { save } from '../../view/picture';
import { h, say } from '../dom';
import { markdownButton, measurement, measuring } from './measuring';
import { trianglesWords } from '../words';
import { t, type Words } from '../../texts';

export function table1(): HTMLElement {
  const rows: Row[] = [];
  const table = h(
    'table',
    { class: 'rows', hidden: true },
    h('caption', { class: 'quiet' }, t('Precompute / solve, in milliseconds')),
    h('thead', {}, h('tr', {}, heading(t('Model')), h('td'), heading('CG'), heading(t('Cholesky')))),
  );
  const measure = async (signal: AbortSignal) => {
    rows.length = 0;
    table.querySelectorAll('tbody').forEach((body) => body.remove());
    [table.hidden, saving.hidden, progress.max] = [false, true, REPORT.length];
    await measureTable(
      signal,
      ({ done, title }) => {
        progress.value = done;
        say(said, t`Measuring ${title}, ${done + 1} of ${REPORT.length}.`);
      },
      (row) => {
        rows.push(row);
        const model = h('th', { scope: 'rowgroup', rowspan: 2 }, row.title, h('br'), trianglesWords(row.triangles));
        table.append(
          h('tbody', {}, timesRow(t('Here'), row, milliseconds, model), timesRow(t('Report'), reportOf(row), String)),
        );
      },
    );
    return t('Done. Other work on this device makes times longer.');
  };
  const ended = () => {
    saving.hidden = rows.length === 0;
    table.hidden = rows.length === 0;
  };
  const { button, progress, said } = measuring({
    label: t('Measure Table 1'),
    steps: t('Models measured'),
    measure,
    ended,
  });
  const copy = markdownButton(
    () => markdownOf(rows, navigator.userAgent),
    said,
    t('The clipboard is not available. Save the table as CSV.'),
  );
  const saveCsv = h('button', { class: 'small' }, t('Save as CSV'));
  const saving = h('div', { class: 'saving', hidden: true }, copy, saveCsv);
  saveCsv.addEventListener('click', () => save(new Blob([csvOf(rows)], { type: 'text/csv' }), 'table1.csv'));
  return measurement(
    t('Table 1 of the report'),
    t(
      'Conjugate gradients (CG) beside Cholesky factors, by the method of the report, on models of about as many triangles. The report measured by ALGLIB in C# on a laptop of 2015.',
    ),
    button,
    progress,
    said,
    h('div', { class: 'scroll', tabIndex: 0, role: 'region', 'aria-label': t('Times') }, table),
    saving,
  );
}

function heading(name: Words): HTMLElement {
  return h('th', { scope: 'col' }, name);
}

function timesRow(
  name: Words,
  { iterated, factored }: Pick<Row, 'iterated' | 'factored'>,
  words: (time: number) => string,
  model?: HTMLElement,
): HTMLElement {
  const times = [iterated, factored].map((each) => h('td', {}, timesOf(each, words)));
  return h('tr', {}, ...(model ? [model] : []), h('th', { scope: 'row' }, name), ...times);
}

function timesOf({ precompute, solve }: Times, words: (time: number) => string): string {
  return `${words(precompute)} / ${words(solve)}`;
}
