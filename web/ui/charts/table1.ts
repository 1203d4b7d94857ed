/** Table 1 of the report, measured on this device when it is asked for. */
import { measureTable } from '../../solver/table1';
import { csvOf, markdownOf, milliseconds, REPORT, reportOf, type Row, type Times } from '../../state/table1';
import { save } from '../../view/picture';
import { h, say } from '../dom';
import { markdownButton, measuring } from './measuring';
import { count, t, type Words } from '../../texts';

export function table1(): HTMLElement {
  const rows: Row[] = [];
  const body = h('tbody', {});
  const table = h(
    'table',
    { class: 'rows', hidden: true },
    h('caption', { class: 'quiet' }, t('Precompute / solve, in milliseconds')),
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('td', { colspan: 2 }),
        h('th', { scope: 'colgroup', colspan: 2 }, t('Here')),
        h('th', { scope: 'colgroup', colspan: 2 }, t('Report')),
      ),
      cells('th', [t('Model'), t('Triangles'), 'CG', t('Cholesky'), 'CG', t('Cholesky')]),
    ),
    body,
  );
  const measure = async (signal: AbortSignal) => {
    rows.length = 0;
    body.replaceChildren();
    [table.hidden, saving.hidden, progress.max] = [false, true, REPORT.length];
    await measureTable(
      signal,
      ({ done, title }) => {
        progress.value = done;
        say(said, t`Measuring ${title}, ${done + 1} of ${REPORT.length}.`);
      },
      (row) => {
        rows.push(row);
        const times = [row, reportOf(row)].flatMap(({ iterated, factored }) => [iterated, factored].map(timesOf));
        body.append(cells('td', [row.title, count(row.triangles), ...times]));
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
  return h(
    'section',
    { class: 'stack measured', 'aria-label': t('Table 1 of the report') },
    h('h2', {}, t('Table 1 of the report')),
    h(
      'p',
      { class: 'quiet' },
      t(
        'Conjugate gradients (CG) beside Cholesky factors, by the method of the report, on models of the same numbers of triangles. The report measured by ALGLIB in C# on a laptop of 2015.',
      ),
    ),
    button,
    progress,
    said,
    h('div', { class: 'scroll', tabIndex: 0, role: 'region', 'aria-label': t('Times') }, table),
    saving,
  );
}

function cells(tag: 'th' | 'td', words: readonly Words[]): HTMLElement {
  return h('tr', {}, ...words.map((word) => h(tag, {}, word)));
}

function timesOf({ precompute, solve }: Times): string {
  return `${milliseconds(precompute)} / ${milliseconds(solve)}`;
}
