/** Table 1 of the report: conjugate gradients beside Cholesky factors on eleven models. */
import type { Parameters } from '../protocol';
import { DEFAULT_PARAMETERS } from '../wasm/contract';
import { entry } from './entry';
import { markdownTable } from './markdown';
import { type ModelOfReport, REPORT, type Times } from './report';

/** What is measured of a model. */
export interface Row {
  title: string;
  triangles: number;
  iterated: Times;
  factored: Times;
}

/** What the report measured with. */
const DEVICE_OF_REPORT = 'ALGLIB in C# on a laptop of 2015';

/** The method of the report: t = h², the operator of the triangles as they are, no exact region. */
export function parametersOfReport(solver: Parameters['solver']): Parameters {
  return { ...DEFAULT_PARAMETERS, operator: 'plain', timeStep: 1, exactRadius: 0, solver };
}

export const HEAD = [
  'Model',
  'Triangles',
  'CG precompute (ms)',
  'CG solve (ms)',
  'Cholesky precompute (ms)',
  'Cholesky solve (ms)',
  'Report: CG precompute (ms)',
  'Report: CG solve (ms)',
  'Report: Cholesky precompute (ms)',
  'Report: Cholesky solve (ms)',
] as const;

/** What a row of the table has under `HEAD`, as numbers. */
export function cellsOf(row: Row): (string | number)[] {
  const times = ({ iterated, factored }: Pick<Row, 'iterated' | 'factored'>) =>
    [iterated, factored].flatMap(({ precompute, solve }) => [precompute, solve]);
  return [row.title, row.triangles, ...times(row), ...times(reportOf(row))];
}

/** What the report says of the same model. */
export function reportOf({ title }: Row): ModelOfReport {
  const model = REPORT.find((each) => each.title === title);
  if (!model) throw new Error(`the report has no model ${title}`);
  return model;
}

/** To a tenth, which is what browsers measure to. */
export function milliseconds(time: number): string {
  return time >= 100 ? time.toFixed(0) : time.toFixed(1);
}

/** Whether a column under `HEAD` has times that were measured here; the report's are as it gives them. */
function isMeasured(column: number): boolean {
  return column > 1 && column < 6;
}

/** A table in Markdown; `device` is named below it. */
export function markdownOf(rows: readonly Row[], device: string): string {
  const cells = rows.map((row) =>
    cellsOf(row).map((cell, index) =>
      typeof cell === 'number' && isMeasured(index) ? milliseconds(cell) : String(cell),
    ),
  );
  return `${markdownTable(HEAD, cells, [0])}\nMeasured by Heatwalk in ${device}. Report: ${DEVICE_OF_REPORT}.\n`;
}

export function csvOf(rows: readonly Row[]): string {
  return [HEAD, ...rows.map(cellsOf)].map((cells) => `${cells.join(',')}\r\n`).join('');
}

/** The middle one, or the mean of the middle two. */
export function median(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  const middle = sorted.length / 2;
  return (entry(sorted, Math.ceil(middle) - 1) + entry(sorted, Math.floor(middle))) / 2;
}
