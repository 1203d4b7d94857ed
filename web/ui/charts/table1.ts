/** Table 1 of the report, measured on this device when it is asked for. */
import { Cancelled } from '../../solver/remote';
import { measureTable } from '../../solver/table1';
import { csvOf, markdownOf, milliseconds, REPORT, type Row, type Times } from '../../state/table1';
import { save } from '../../view/picture';
import { h } from '../dom';
import { t } from '../../texts';

export function table1(): HTMLElement {
  const rows: Row[] = [];
  let running: AbortController | null = null;
  const said = h('p', { class: 'quiet', role: 'status' });
  const progress = h('progress', { max: REPORT.length, value: 0, hidden: true, 'aria-label': t('Models measured') });
  const body = h('tbody', {});
  const table = h(
    'table',
    { class: 'rows', hidden: true },
    h('caption', { class: 'quiet' }, t('Precompute / solve, in milliseconds')),
    h('thead', {}, cells('th', [t('Model'), t('Triangles'), 'CG', t('Cholesky')])),
    body,
  );
  const run = h('button', { class: 'wide' }, t('Measure Table 1'));
  const copy = h('button', { class: 'small' }, t('Copy as Markdown'));
  const saveCsv = h('button', { class: 'small' }, t('Save as CSV'));
  const saving = h('div', { class: 'saving', hidden: true }, copy, saveCsv);

  const measure = async () => {
    running = new AbortController();
    rows.length = 0;
    body.replaceChildren();
    [table.hidden, saving.hidden, progress.hidden] = [false, true, false];
    run.textContent = t('Cancel');
    try {
      await measureTable(
        running.signal,
        ({ done, title }) => {
          progress.value = done;
          said.textContent = t`Measuring ${title}, ${done + 1} of ${REPORT.length}.`;
        },
        (row) => {
          rows.push(row);
          body.append(cells('td', [row.title, String(row.triangles), timesOf(row.iterated), timesOf(row.factored)]));
        },
      );
      said.textContent = t('Done. Other work on this device makes times longer.');
    } catch (error) {
      const isCancelled = error instanceof Cancelled || running.signal.aborted;
      said.textContent = isCancelled ? t('Cancelled.') : error instanceof Error ? error.message : String(error);
    } finally {
      running = null;
      run.textContent = t('Measure Table 1');
      progress.hidden = true;
      saving.hidden = rows.length === 0;
      table.hidden = rows.length === 0;
    }
  };
  run.addEventListener('click', () => {
    if (running) running.abort();
    else void measure();
  });
  copy.addEventListener('click', () => {
    navigator.clipboard.writeText(markdownOf(rows, navigator.userAgent)).then(
      () => (said.textContent = t('Copied.')),
      () => (said.textContent = t('The clipboard is not available. Save the table as CSV.')),
    );
  });
  saveCsv.addEventListener('click', () => save(new Blob([csvOf(rows)], { type: 'text/csv' }), 'table1.csv'));
  return h(
    'section',
    { class: 'stack table1', 'aria-label': t('Table 1 of the report') },
    h('h2', {}, t('Table 1 of the report')),
    h(
      'p',
      { class: 'quiet' },
      t(
        'Conjugate gradients (CG) beside Cholesky factors, by the method of the report, on models of the same numbers of triangles.',
      ),
    ),
    run,
    progress,
    said,
    h('div', { class: 'scroll', tabIndex: 0, role: 'region', 'aria-label': t('Times') }, table),
    saving,
  );
}

function cells(tag: 'th' | 'td', words: readonly string[]): HTMLElement {
  return h('tr', {}, ...words.map((word) => h(tag, {}, word)));
}

function timesOf({ precompute, solve }: Times): string {
  return `${milliseconds(precompute)} / ${milliseconds(solve)}`;
}
