/** Cells as colors that lie on the surface. */
import type { DrawMesh, DrawPose, FoundCells } from '../protocol';
import { linearColourOfCell } from '../state/cells';
import { entry } from '../state/entry';
import { vectorAt } from '../state/vector';
import type { Patches } from './layers';
import { cornerAt, FILM, PatchMesh } from './patches';

/** How much of the color beneath is covered, and how far above the surface that lies, as a share of the diameter. */
const OPACITY = 0.78;
const LIFT = 4e-4;

export function colouredCells(
  surface: Pick<DrawMesh, 'triangles'>,
  pose: DrawPose,
  found: FoundCells,
  diameter: number,
  isOpen: boolean,
): Patches {
  const colours = found.areas.map((_, cell) => [...linearColourOfCell(cell), OPACITY]);
  return patchesOfTiles(surface, pose, found, (cell) => entry(colours, cell), diameter, isOpen);
}

/**
 * Parts of triangles in colors, linear RGBA: of a cell, where that is not the same, at the corner of a part whose weights begin at `first`.
 * `pose`: of the surface as it is drawn. `diameter`: as it is drawn. `isOpen`: it is seen from behind, too.
 */
export function patchesOfTiles(
  { triangles }: Pick<DrawMesh, 'triangles'>,
  pose: DrawPose,
  { tiles, corners }: Pick<FoundCells, 'tiles' | 'corners'>,
  colourOf: (cell: number, first: number) => readonly number[],
  diameter: number,
  isOpen: boolean,
): Patches {
  const lifts = isOpen ? [LIFT * diameter, -LIFT * diameter] : [LIFT * diameter];
  const film = new PatchMesh(pose, (lifts.length * corners.length) / 3);
  const cells = 1 + tiles.reduce((most, value, at) => (at % 2 === 0 ? Math.max(most, value) : most), 0);
  for (const lift of lifts) {
    const drawn = new Map<number, number>();
    for (let tile = 0; 2 * tile < tiles.length; tile++) {
      const [cell, triangle] = [entry(tiles, 2 * tile), entry(tiles, 2 * tile + 1)];
      const vertices = vectorAt(triangles, triangle);
      for (let first = 9 * tile; first < 9 * tile + 9; first += 3) {
        const at = cornerAt(corners, first);
        // Walls can part the cells of a drawn vertex.
        const key = at < 0 ? -1 : entry(vertices, at) * cells + cell;
        let vertex = drawn.get(key);
        if (vertex === undefined) {
          vertex = film.vertex(vertices, corners, first, lift);
          film.colour(colourOf(cell, first));
          if (at >= 0) drawn.set(key, vertex);
        }
        film.corner(vertex);
      }
    }
  }
  return film.in(FILM, []);
}
