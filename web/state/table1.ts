/** Table 1 of the report: conjugate gradients beside Cholesky factors on eleven models. */
import type { Parameters } from '../protocol';
import { DEFAULT_PARAMETERS } from '../wasm/contract';
import { markdownTable } from './markdown';
import { entry } from './entry';

/** Milliseconds. */
export interface Times {
  precompute: number;
  solve: number;
}

export interface ModelOfReport {
  title: string;
  /** The preset that stands for it, or a shape that is in none. */
  model: { preset: string } | { shape: string };
  triangles: number;
  iterated: Times;
  factored: Times;
}

/** What is measured of a model. */
export interface Row {
  title: string;
  triangles: number;
  iterated: Times;
  factored: Times;
}

/** What the report measured with. */
const DEVICE_OF_REPORT = 'ALGLIB in C# on a laptop of 2015';

/** The report's models with its times. */
export const REPORT: readonly [ModelOfReport, ...ModelOfReport[]] = [
  reported('High Genus', { preset: 'high_genus' }, 3328, [34, 27], [64, 8.9]),
  reported('Bague', { preset: 'ring' }, 5304, [55, 60], [109, 17]),
  reported('Cow', { preset: 'animal' }, 5804, [62, 109], [335, 16]),
  reported('Triceratops', { preset: 'triceratops' }, 5660, [59, 105], [306, 15]),
  reported('Sphere 1', { shape: 'uv_sphere' }, 9024, [94, 99], [236, 21]),
  reported('Sphere 3', { preset: 'icosphere' }, 6912, [65, 59], [327, 18]),
  reported('Hemisphere', { preset: 'hemisphere' }, 3456, [51, 34], [131, 10]),
  reported('Skull', { preset: 'skull' }, 12200, [183, 338], [989, 38]),
  reported('Maze', { preset: 'maze' }, 5120, [63, 94], [134, 12]),
  reported('Horse', { preset: 'horse' }, 39996, [447, 1355], [2047, 113]),
  reported('Dragon', { preset: 'dragon' }, 20388, [188, 1291], [1787, 58]),
];

function reported(
  title: string,
  model: ModelOfReport['model'],
  triangles: number,
  [iteratedFirst, iteratedThen]: readonly [number, number],
  [factoredFirst, factoredThen]: readonly [number, number],
): ModelOfReport {
  const iterated = { precompute: iteratedFirst, solve: iteratedThen };
  return { title, model, triangles, iterated, factored: { precompute: factoredFirst, solve: factoredThen } };
}

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
