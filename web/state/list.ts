/** Lists of sources as rows of text: a CSV file, what is pasted, what is typed. */
import { Failure } from '../error';
import { inModel, inUnit, type LengthUnit, type ModelLength } from '../length';
import { MOST_POINTS } from './sources';
import type { Vector } from './vector';
import { count, t, type Words } from '../texts';

/** Where a source is to be: at a vertex of the input, or at the place of the surface that is nearest to coordinates of the model. */
export type RowPlace = { vertex: number } | { coordinates: Vector };

export interface Row {
  place: RowPlace;
  /** Initial distance. */
  offset: ModelLength;
  /** What a message names it by. */
  at: Words;
}

const SEPARATORS = /\s*[,;\t]\s*|\s+/;
const DECIMAL_COMMA = /^[-+]?\d+,\d+$/;
/** Of a row that has these a comma separates nothing: it is one of decimals, which no number has here. */
const STRONGER = /\s*[;\t]\s*/;
const FORMS = t('Give a vertex, or x y z; an initial distance may follow.');
/** The unit of a column, in its heading. */
const UNIT = /\s*\(([^()]*)\)/;
const UNITS = new RegExp(UNIT, 'g');
/** Names of the columns, by the first row. */
const VERTEX = ['vertex', 'v', 'vertex_id'];
const OFFSET = ['offset', 'initial', 'initial_distance', 'distance'];
const AXES = ['x', 'y', 'z'];

/** Where in a row what is found; −1: nowhere. */
interface Columns {
  vertex: number;
  axes: readonly number[];
  offset: number;
}

/** Whether it is one row alone, and no list. */
export function isOneLine(text: string): boolean {
  return rowsIn(text).length === 1;
}

/** Whether the first row says that the others are sources. */
export function isNamedList(text: string): boolean {
  const [first] = rowsIn(text);
  return first !== undefined && columnsNamed(first.cells) !== null;
}

/** Whether text may be a list of sources: its first row is one, or says what the others are. */
export function isList(text: string): boolean {
  const [first] = rowsIn(text);
  return first !== undefined && (columnsNamed(first.cells) !== null || columnsOf(first.cells) !== null);
}

/**
 * Rows `vertex`, `vertex,offset`, `x,y,z` or `x,y,z,offset`, vertices counted from 0. Commas, semicolons, tabs and blanks separate. A
 * first row of words is a heading: it says which column is what, and may say in which unit lengths are, `x (mm)`; else they are in `unit`.
 *
 * @throws where a row is none, with its line.
 */
export function rowsOf(name: Words, text: string, unit: LengthUnit): Row[] {
  const rows = rowsIn(text);
  const [, symbol] = UNIT.exec(rows[0]?.text ?? '') ?? [];
  const own = symbol ? inUnit(unit, symbol) : unit;
  const named = rows[0] && columnsNamed(rows[0].cells);
  const names = rows[0]?.cells.length ?? 0;
  if (named || (rows[0] && rows[0].cells.every((cell) => Number.isNaN(numberIn(cell))))) rows.shift();
  if (rows.length === 0) throw new Failure(t`${name} has no sources. ${FORMS}`);
  if (rows.length > MOST_POINTS) {
    throw new Failure(t`${name} has ${count(rows.length)} sources; up to ${count(MOST_POINTS)} are taken.`);
  }
  const isOne = rows.length === 1 && !named;
  return rows.map(({ cells, line }) => {
    const at = isOne ? name : t`${name}, line ${line}`;
    const columns = named ?? columnsOf(cells);
    const comma = cells.find((cell) => DECIMAL_COMMA.test(cell));
    if (comma) throw new Failure(t`${at}: “${comma.slice(0, 40)}” has a decimal comma; write a point.`);
    if (!columns) throw new Failure(t`${at}: “${cells.join(' ').slice(0, 40)}” is no source. ${FORMS}`);
    if (named && cells.slice(names).some((cell) => cell !== ''))
      throw new Failure(t`${at} has more cells than the first row has names.`);
    return rowOf(cells, columns, at, own);
  });
}

function rowOf(cells: readonly string[], { vertex, axes, offset: own }: Columns, at: Words, unit: LengthUnit): Row {
  const valueAt = (column: number) => numberIn(cells[column] ?? '');
  const typed = own < 0 || (cells[own] ?? '') === '' ? 0 : valueAt(own);
  const offset = inModel(typed, unit);
  // Negated, so that NaN is rejected too.
  if (!(offset >= 0 && offset < Infinity)) {
    throw new Failure(t`${at}: an initial distance is a number from 0 on, not “${(cells[own] ?? '').slice(0, 40)}”.`);
  }
  if (vertex >= 0) {
    const index = valueAt(vertex);
    if (!(Number.isInteger(index) && index >= 0)) {
      throw new Failure(t`${at}: a vertex is a whole number from 0 on, not “${(cells[vertex] ?? '').slice(0, 40)}”.`);
    }
    return { place: { vertex: index }, offset, at };
  }
  const [x = NaN, y = NaN, z = NaN] = axes.map(valueAt);
  if (![x, y, z].every(Number.isFinite)) throw new Failure(t`${at}: x, y and z must be numbers.`);
  return { place: { coordinates: [inModel(x, unit), inModel(y, unit), inModel(z, unit)] }, offset, at };
}

function rowsIn(text: string): { text: string; cells: string[]; line: number }[] {
  return text
    .split(/\r\n|\r|\n/)
    .map((row, index) => ({ row: row.trim(), line: index + 1 }))
    .filter(({ row }) => row !== '')
    .map(({ row, line }) => {
      const plain = row.replaceAll(UNITS, '');
      const isMixed = plain.split(STRONGER).some((cell) => DECIMAL_COMMA.test(cell)) && STRONGER.test(plain);
      return { text: row, cells: plain.split(isMixed ? STRONGER : SEPARATORS), line };
    });
}

/** What a heading says; null for a row that is none. */
function columnsNamed(cells: readonly string[]): Columns | null {
  const names = cells.map((cell) => cell.replaceAll('"', '').toLowerCase());
  const among = (wanted: readonly string[]) => names.findIndex((name) => wanted.includes(name));
  const vertex = among(VERTEX);
  const axes = AXES.map((axis) => names.indexOf(axis));
  const isHeading = vertex >= 0 || axes.every((column) => column >= 0);
  return isHeading ? { vertex, axes, offset: among(OFFSET) } : null;
}

/** What a row without a heading holds, by how many numbers it has; null where it is none. */
function columnsOf(cells: readonly string[]): Columns | null {
  if (cells.some((cell) => Number.isNaN(numberIn(cell)))) return null;
  switch (cells.length) {
    case 1:
    case 2:
      return { vertex: 0, axes: [], offset: cells.length === 2 ? 1 : -1 };
    case 3:
    case 4:
      return { vertex: -1, axes: [0, 1, 2], offset: cells.length === 4 ? 3 : -1 };
    default:
      return null;
  }
}

function numberIn(cell: string): number {
  return cell === '' ? Number.NaN : Number(cell);
}
