/** Cells as colors that lie on the surface. */
import type { DrawMesh, DrawPose, FoundCells, Material } from '../protocol';
import { linearColourOfCell } from '../state/cells';
import { entry } from '../state/entry';
import { moved, normalized, type Vector, vectorAt } from '../state/vector';
import type { Patches } from './layers';

/** How much of the color beneath is covered, and how far above the surface that lies, as a share of the diameter. */
const OPACITY = 0.78;
const LIFT = 4e-4;

const FILM: Material = {
  baseColor: Float32Array.of(1, 1, 1, 1),
  metalness: 0,
  roughness: 0.7,
  emission: new Float32Array(3),
  normalScale: 1,
  occlusionStrength: 1,
  alpha: 'blend',
  cutoff: 0,
  unlit: false,
  doubleSided: true,
  textures: [null, null, null, null, null],
};

/** `pose`: of the surface as it is drawn. `diameter`: as it is drawn. `isOpen`: it is seen from behind, too. */
export function colouredCells(
  { triangles }: Pick<DrawMesh, 'triangles'>,
  pose: DrawPose,
  { tiles, corners, areas }: FoundCells,
  diameter: number,
  isOpen: boolean,
): Patches {
  const film = new Film(areas.length);
  const lifts = isOpen ? [LIFT * diameter, -LIFT * diameter] : [LIFT * diameter];
  for (const lift of lifts) {
    const drawn = new Map<number, number>();
    for (let tile = 0; 2 * tile < tiles.length; tile++) {
      const [cell, triangle] = [entry(tiles, 2 * tile), entry(tiles, 2 * tile + 1)];
      const vertices = vectorAt(triangles, triangle);
      for (let k = 0; k < 3; k++) {
        const weights = vectorAt(corners, 3 * tile + k);
        const place = () => blended(pose, vertices, weights, lift);
        const at = weights.indexOf(1);
        if (at < 0) {
          film.corner(film.vertex(cell, ...place()));
          continue;
        }
        // Walls can part the cells of a drawn vertex.
        const key = entry(vertices, at) * areas.length + cell;
        let vertex = drawn.get(key);
        if (vertex === undefined) drawn.set(key, (vertex = film.vertex(cell, ...place())));
        film.corner(vertex);
      }
    }
  }
  return { mesh: film.mesh, materials: [FILM] };
}

function blended(
  { positions, normals }: DrawPose,
  vertices: Vector,
  weights: Vector,
  lift: number,
): [position: Vector, normal: Vector] {
  const sum = (values: Float32Array) =>
    vertices.reduce((all: Vector, vertex, k) => moved(all, vectorAt(values, vertex), entry(weights, k)), [0, 0, 0]);
  const normal = normalized(sum(normals));
  return [moved(sum(positions), normal, lift), normal];
}

/** A mesh that grows by vertices and corners of triangles. */
class Film {
  readonly #colours: Uint16Array;
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #cells: number[] = [];
  readonly #corners: number[] = [];

  constructor(cells: number) {
    this.#colours = new Uint16Array(4 * cells);
    for (let cell = 0; cell < cells; cell++) {
      this.#colours.set(
        [...linearColourOfCell(cell), OPACITY].map((value) => Math.round(65_535 * value)),
        4 * cell,
      );
    }
  }

  vertex(cell: number, position: Vector, normal: Vector): number {
    this.#positions.push(...position);
    this.#normals.push(...normal);
    return this.#cells.push(cell) - 1;
  }

  corner(vertex: number): void {
    this.#corners.push(vertex);
  }

  get mesh(): Patches['mesh'] {
    const colors = new Uint16Array(4 * this.#cells.length);
    this.#cells.forEach((cell, vertex) => colors.set(this.#colours.subarray(4 * cell, 4 * cell + 4), 4 * vertex));
    return {
      positions: Float32Array.from(this.#positions),
      normals: Float32Array.from(this.#normals),
      triangles: Uint32Array.from(this.#corners),
      texcoords: new Float32Array(),
      colors,
      runs: Uint32Array.of(0, this.#corners.length / 3, 0),
    };
  }
}
