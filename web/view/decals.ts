/** Images that lie on the surface. */
import type { DrawMesh, DrawPose, LaidDecal, Material } from '../protocol';
import { entry } from '../state/entry';
import { vectorAt } from '../state/vector';
import type { Patches } from './layers';
import { cornerAt, FILM, PatchMesh } from './patches';

/** How far the first one lies above the surface, and how much farther each next one, as shares of the diameter. */
const LIFT = 8e-4;
const NEXT = 2e-4;

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
  const lift = (LIFT + above * NEXT) * diameter;
  const lifts = isOpen ? [lift, -lift] : [lift];
  const film = new PatchMesh(pose, 3 * lifts.length * parts.length);
  for (const by of lifts) {
    const drawn = new Map<number, number>();
    for (let part = 0; part < parts.length; part++) {
      const vertices = vectorAt(triangles, entry(parts, part));
      for (let corner = 3 * part; corner < 3 * part + 3; corner++) {
        const at = cornerAt(corners, 3 * corner);
        let vertex = at < 0 ? undefined : drawn.get(entry(vertices, at));
        if (vertex === undefined) {
          vertex = film.vertex(vertices, corners, 3 * corner, by);
          film.texture(entry(places, 2 * corner), entry(places, 2 * corner + 1));
          if (at >= 0) drawn.set(entry(vertices, at), vertex);
        }
        film.corner(vertex);
      }
    }
  }
  return film.in(IMAGE, [image]);
}
