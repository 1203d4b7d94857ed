/** A renderer that is given a coarse surface, with what is on it, and draws it divided. */
import type { DrawnSurface, FinerMesh } from '../protocol';
import { withMiddles } from '../solver/finer';
import { entry } from '../state/entry';
import {
  cornersOf,
  cross,
  minus,
  moved,
  scaled,
  type Triangle,
  type Vector,
  vectorAt,
  vectorsIn,
  weighted,
} from '../state/vector';
import type { Hit, Viewer } from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';

type Calls = Pick<
  Viewer,
  'set_surface' | 'set_pose' | 'set_field' | 'set_other_field' | 'set_tints' | 'set_arrows' | 'pick'
>;

/** The same renderer for surfaces that have a `finer` mesh, and for all others. */
export function drawingFiner(viewer: Viewer): Viewer {
  let finer: FinerMesh | undefined;
  const calls: Calls = {
    set_surface(surface: DrawnSurface, shade) {
      viewer.set_surface(surface.finer?.mesh ?? surface, shade);
      ({ finer } = surface);
    },
    set_pose(positions, normals, rests) {
      const [places, directions] = finer ? posed(finer, positions, normals) : [positions, normals];
      viewer.set_pose(places, directions, rests);
    },
    set_field(values, tangents, max, byCorner) {
      viewer.set_field(...onFiner(finer, values, tangents, byCorner), max, byCorner);
    },
    set_other_field(values, tangents, byCorner) {
      viewer.set_other_field(...onFiner(finer, values, tangents, byCorner), byCorner);
    },
    set_tints(surface, tints) {
      viewer.set_tints(
        finer?.mesh ?? surface,
        finer ? ofParts(finer, tints, new Uint8Array(4 * finer.origins.length)) : tints,
      );
    },
    set_arrows(vectors: Float32Array) {
      viewer.set_arrows(finer ? arrowsOf(finer, vectors) : vectors);
    },
    pick(x, y) {
      const hit = viewer.pick(x, y);
      return hit && finer && !hit.is_on_section ? onWhole(finer, hit) : hit;
    },
  };
  return Object.assign(Object.create(viewer) as Viewer, calls);
}

/** Positions and normals of its vertices in a pose. */
export function posed(
  { middles }: FinerMesh,
  positions: Float32Array,
  normals: Float32Array,
): [positions: Float32Array, normals: Float32Array] {
  return [withMiddles(positions, middles, 3), withMiddles(normals, middles, 3)];
}

/** Values and where they grow, of vertices or of corners: where none are given for middles, the means of the ends. */
function onFiner(
  finer: FinerMesh | undefined,
  values: Float32Array,
  tangents: Int8Array,
  byCorner: boolean,
): [values: Float32Array, tangents: Int8Array] {
  if (!finer || values.length === 0) return [values, tangents];
  const isWhole = values.length > tangents.length / 4;
  const spread = <A extends Float32Array | Int8Array>(given: A, size: number) =>
    byCorner ? ofCorners(finer, given, size) : withMiddles(given, finer.middles, size);
  return [isWhole ? values : spread(values, 1), spread(tangents, 4)];
}

/** What corners of triangles have, for those of the parts. */
function ofCorners<A extends Float32Array | Int8Array>({ origins, weights }: FinerMesh, given: A, size: number): A {
  const all = new (given.constructor as new (length: number) => A)(3 * size * origins.length);
  for (let corner = 0; corner < 3 * origins.length; corner++) {
    const shares = vectorAt(weights, corner);
    const first = 3 * size * entry(origins, Math.floor(corner / 3));
    for (let k = 0; k < size; k++) {
      // Nothing times Infinity is no number.
      const of = (i: number) => (shares[i] ? shares[i] * entry(given, first + i * size + k) : 0);
      all[corner * size + k] = of(0) + of(1) + of(2);
    }
  }
  return all;
}

/** What triangles have, for their parts, in an array for these. */
function ofParts<A extends Float32Array | Uint8Array>({ origins }: FinerMesh, given: ArrayLike<number>, all: A): A {
  const size = all.length / origins.length;
  for (let to = 0; to < all.length; to++) {
    all[to] = entry(given, size * entry(origins, Math.floor(to / size)) + (to % size));
  }
  return all;
}

/** Arrows of triangles for their parts, or those of the parts. */
function arrowsOf(finer: FinerMesh, vectors: Float32Array): Float32Array {
  const ofAll = new Float32Array(3 * finer.origins.length);
  return vectors.length === 0 || vectors.length === ofAll.length ? vectors : ofParts(finer, vectors, ofAll);
}

/** #T × 3: along the gradients of distances, as in a `DistanceField`, on the parts; nothing where they are not reached. */
export function gradientsOn({ mesh }: FinerMesh, distances: Float32Array, byCorner: boolean): Float32Array {
  const { positions, triangles } = mesh;
  const vectors = vectorsIn(triangles).map((corners, part): Vector => {
    const [p, q, r] = cornersOf(positions, triangles, part);
    const [a, b, c] = [0, 1, 2].map((k) => entry(distances, byCorner ? 3 * part + k : entry(corners, k))) as Vector;
    const along = moved(scaled(minus(r, p), a - b), minus(q, p), c - a);
    const gradient = cross(cross(minus(q, p), minus(r, p)), along);
    return gradient.every(Number.isFinite) ? gradient : [0, 0, 0];
  });
  return Float32Array.from(vectors.flat());
}

/** What was hit, as a place of the whole triangle. */
function onWhole({ origins, weights }: FinerMesh, hit: Hit): Hit {
  const corner = (k: number) => vectorAt(weights, 3 * hit.triangle + k);
  const corners: Triangle = [corner(0), corner(1), corner(2)];
  const shares: Vector = weighted(corners, vectorAt(hit.weights, 0));
  const whole = { triangle: entry(origins, hit.triangle), weights: Float32Array.from(shares), free: () => hit.free() };
  return Object.create(hit, Object.getOwnPropertyDescriptors(whole)) as Hit;
}
