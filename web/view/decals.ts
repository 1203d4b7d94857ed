/** Images that lie on the surface. */
import type { DrawMesh, DrawPose, LaidDecal, Material } from '../protocol';
import { entry } from '../state/entry';
import { vectorAt } from '../state/vector';
import type { Patches } from './layers';
import { FILM, lifted, PatchMesh } from './patches';

/** How far the first one lies above the surface, and how much farther each next one, as shares of the diameter. */
const LIFT = 8e-4;
const NEXT = 2e-4;

const WHITE = [1, 1, 1, 1] as const;
const IMAGE: Material = {
  ...FILM,
  textures: [
    { image: 0, set: 0, transform: Float32Array.of(1, 0, 0, 0, 1, 0), wrapU: 'clamp', wrapV: 'clamp', sharp: false },
    null,
    null,
    null,
    null,
  ],
};

/** `above`: how many lie below it. The rest as of cells. */
export function laidImage(
  { triangles }: Pick<DrawMesh, 'triangles'>,
  pose: DrawPose,
  { triangles: parts, corners, image: places }: LaidDecal,
  image: ImageBitmap,
  above: number,
  diameter: number,
  isOpen: boolean,
): Patches {
  const film = new PatchMesh();
  const lift = (LIFT + above * NEXT) * diameter;
  for (const by of isOpen ? [lift, -lift] : [lift]) {
    parts.forEach((triangle, part) => {
      const vertices = vectorAt(triangles, triangle);
      for (let k = 0; k < 3; k++) {
        const corner = 3 * part + k;
        const place = [entry(places, 2 * corner), entry(places, 2 * corner + 1)] as const;
        film.corner(film.vertex(lifted(pose, vertices, vectorAt(corners, corner), by), WHITE, place));
      }
    });
  }
  return film.in(IMAGE, [image]);
}
