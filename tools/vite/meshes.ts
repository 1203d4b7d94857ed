import { createRequire } from 'node:module';
import type { Plugin } from 'vite';

/** Packages that are a mesh as lists of numbers. */
const PACKAGE = /\/node_modules\/bunny\/index\.js$/;
/** Of its positions. */
const DECIMALS = 6;
/** Bytes of a coordinate above the least of its axis, and of an index of a vertex. */
const [COORDINATE, INDEX] = [3, 2] as const;

interface PlainMesh {
  positions: readonly (readonly number[])[];
  cells: readonly (readonly number[])[];
}

/** Packs a mesh into text that compresses to three quarters of what its numbers do. What a module of it exports stays the same. */
export function meshes(): Plugin {
  return {
    name: 'heatwalk-meshes',
    transform: {
      filter: { id: PACKAGE },
      handler(_code, id) {
        const { positions, cells } = createRequire(import.meta.url)(id) as PlainMesh;
        const scaled = positions.flat().map((value) => Math.round(value * 10 ** DECIMALS));
        const isSame = scaled.every(
          (value, index) => value / 10 ** DECIMALS === positions[Math.floor(index / 3)]?.[index % 3],
        );
        const least = [0, 1, 2].map((axis) => Math.min(...scaled.filter((_, index) => index % 3 === axis)));
        const above = scaled.map((value, index) => value - (least[index % 3] ?? NaN));
        const indices = cells.flat();
        if (!isSame || !isWithin(above, COORDINATE) || !isWithin(indices, INDEX)) {
          this.error(`${id} has positions of more digits, or more vertices, than it is packed with.`);
        }
        const code = `
const numbers = (text, size) => {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const count = bytes.length / size;
  return Array.from({ length: count }, (_, index) => {
    let code = 0;
    for (let plane = 0; plane < size; plane++) code = 256 * code + bytes[plane * count + index];
    return code;
  });
};
const rows = (list) => Array.from({ length: list.length / 3 }, (_, row) => list.slice(3 * row, 3 * row + 3));
const least = [${least.join()}];
export default {
  positions: rows(numbers('${planes(above, COORDINATE)}', ${COORDINATE})).map((row) =>
    row.map((value, axis) => (value + least[axis]) / ${10 ** DECIMALS})),
  cells: rows(numbers('${planes(indices, INDEX)}', ${INDEX})),
};`;
        return { code, map: null };
      },
    },
  };
}

function isWithin(values: readonly number[], size: number): boolean {
  return values.every((value) => value >= 0 && value < 256 ** size);
}

/** The highest bytes of all, then the next. */
function planes(values: readonly number[], size: number): string {
  const plane = (shift: number) => values.map((value) => (value >> shift) & 255);
  return Buffer.from(Array.from({ length: size }, (_, k) => plane(8 * (size - 1 - k))).flat()).toString('base64');
}
