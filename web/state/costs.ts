/** Costs that a file gives: rows of a CSV file, or numbers of vertices. */
import { Failure } from '../error';
import { codeOf, COSTS, WALL } from './ground';
import { vectorAt } from './vector';
import { count, t, type Words } from '../texts';
import { entry } from './entry';

/**
 * The codes of triangles by the rows of a CSV file: `triangle,cost`, a triangle alone or with the cost `inf` for a wall. Triangles are counted
 * from 0; those in no row cost 1. A first row of words is a heading.
 *
 * @throws where a row is none, with its line.
 */
export function codesOfRows(name: string, text: string, triangles: number): Uint8Array {
  const codes = new Uint8Array(triangles);
  text.split(/\r?\n/).forEach((row, index) => {
    if (row.trim() === '') return;
    const at = t`${name}, line ${index + 1}`;
    const cells = row.split(',').map((cell) => cell.trim());
    const [triangle = Number.NaN, cost = Infinity] = cells.map(numberOf);
    if (Number.isNaN(triangle) && index === 0) return;
    if (cells.length > 2 || Number.isNaN(triangle) || Number.isNaN(cost)) {
      throw new Failure(t`${at}: give a triangle and its cost, such as 12,2.5; or a triangle alone for a wall.`);
    }
    if (!(Number.isInteger(triangle) && triangle >= 0 && triangle < triangles)) {
      throw new Failure(t`${at}: there is no triangle ${triangle}; the mesh has ${count(triangles)}, counted from 0.`);
    }
    codes[triangle] = checkedCode(cost, at);
  });
  return codes;
}

/**
 * The same by numbers of the vertices of the input: a triangle costs the mean of its corners. `corners`: those of the triangles, #F × 3.
 *
 * @throws where a mean is no cost.
 */
export function codesOfVertices(name: string, values: Float32Array, corners: Uint32Array): Uint8Array {
  return Uint8Array.from({ length: corners.length / 3 }, (_, triangle) => {
    const sum = vectorAt(corners, triangle).reduce((before, corner) => before + entry(values, corner), 0);
    return checkedCode(sum / 3, t`The cost by ${name} at triangle ${triangle}`);
  });
}

function numberOf(cell: string): number {
  if (/^\+?inf(inity)?$/i.test(cell)) return Infinity;
  return cell === '' ? Number.NaN : Number(cell);
}

function checkedCode(cost: number, at: Words): number {
  if (cost === Infinity) return WALL;
  // Negated, so that NaN is rejected too.
  if (!(cost >= COSTS[0] && cost <= COSTS[1])) {
    throw new Failure(t`${at}: a cost is ${cost}; it must be from ${COSTS[0]} to ${COSTS[1]}, or inf for a wall.`);
  }
  return codeOf(cost);
}
