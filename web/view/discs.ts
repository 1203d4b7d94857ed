/** A renderer that is given the surface of a cloud, with what is on it, and draws its points as discs. */
import type { Discs, DrawMesh, DrawnSurface } from '../protocol';
import { entry } from '../state/entry';
import { dot, type Vector, vectorAt } from '../state/vector';
import type { Hit, Viewer } from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js';

type Calls = Pick<Viewer, 'set_surface' | 'set_field' | 'set_other_field' | 'set_tints' | 'set_arrows' | 'pick'>;

/** How far discs beside a gap are looked for, in pixels, and in how many directions. */
const GAPS = [2, 4, 8];
const AROUND = 8;

/** What is drawn, and the triangles that join it. */
type Drawn = Discs & { joined: DrawMesh };

/** The same renderer for surfaces that have `discs`, and for all others. */
export function drawingDiscs(viewer: Viewer): Viewer {
  let drawn: Drawn | undefined;
  const calls: Calls = {
    set_surface(surface: DrawnSurface, shade) {
      viewer.set_surface(surface.discs?.mesh ?? surface, shade);
      drawn = surface.discs && { ...surface.discs, joined: surface };
    },
    set_field(values, tangents, max, byCorner) {
      viewer.set_field(...onDiscs(drawn, values, tangents, byCorner), max, byCorner);
    },
    set_other_field(values, tangents, byCorner) {
      viewer.set_other_field(...onDiscs(drawn, values, tangents, byCorner), byCorner);
    },
    set_tints(surface, tints: Uint8Array) {
      viewer.set_tints(drawn?.mesh ?? surface, drawn ? tintsOf(drawn, tints) : tints);
    },
    set_arrows(vectors: Float32Array) {
      viewer.set_arrows(drawn && vectors.length > 0 ? arrowsOf(drawn, vectors) : vectors);
    },
    pick(x, y) {
      if (!drawn) return viewer.pick(x, y);
      const hit = pickThroughNoGap(viewer, x, y);
      return hit && atPoint(drawn, hit);
    },
  };
  return Object.assign(Object.create(viewer) as Viewer, calls);
}

/** Values and where they grow, of vertices or of corners. */
function onDiscs(
  drawn: Drawn | undefined,
  values: Float32Array,
  tangents: Int8Array,
  byCorner: boolean,
): [values: Float32Array, tangents: Int8Array] {
  if (!drawn || values.length === 0) return [values, tangents];
  return [spread(drawn, values, 1, byCorner), spread(drawn, tangents, 4, byCorner)];
}

/** What drawn vertices of the surface have, `size` numbers each, for those of the discs; or what corners have, for corners. */
function spread<A extends Float32Array | Int8Array>(
  { mesh, triangles, weights, joined }: Drawn,
  given: A,
  size: number,
  byCorner: boolean,
): A {
  const count = byCorner ? mesh.triangles.length : triangles.length;
  const all = new (given.constructor as new (length: number) => A)(size * count);
  for (let to = 0; to < count; to++) {
    const vertex = byCorner ? entry(mesh.triangles, to) : to;
    const first = 3 * entry(triangles, vertex);
    for (let step = 0; step < 3; step++) {
      const weight = entry(weights, 3 * vertex + step);
      // Nothing times Infinity is no number.
      if (weight === 0) continue;
      const from = size * (byCorner ? first + step : entry(joined.triangles, first + step));
      for (let k = 0; k < size; k++) all[size * to + k] = entry(all, size * to + k) + weight * entry(given, from + k);
    }
  }
  return all;
}

/** What triangles of the surface have, four numbers each, for those of the discs: where the first corner on the rim lies. */
function tintsOf({ mesh, triangles }: Drawn, given: Uint8Array): Uint8Array {
  const all = new Uint8Array((4 * mesh.triangles.length) / 3);
  for (let to = 0; to < all.length / 4; to++) {
    const from = 4 * entry(triangles, entry(mesh.triangles, 3 * to + 1));
    all.set(given.subarray(from, from + 4), 4 * to);
  }
  return all;
}

/** One arrow a disc. */
function arrowsOf({ mesh, triangles }: Drawn, vectors: Float32Array): Float32Array {
  const all = new Float32Array(mesh.triangles.length);
  let before = -1;
  for (let to = 0; 3 * to < all.length; to++) {
    const middle = entry(mesh.triangles, 3 * to);
    if (middle === before) continue;
    before = middle;
    const from = 3 * entry(triangles, middle);
    all.set(vectors.subarray(from, from + 3), 3 * to);
  }
  return all;
}

/** What is seen at a pixel, or around it where that is a gap between discs, through which there is nothing or the inside. */
function pickThroughNoGap(viewer: Viewer, x: number, y: number): Hit | undefined {
  const [yaw = 0, pitch = 0] = viewer.camera();
  const toEye: Vector = [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
  const hit = viewer.pick(x, y);
  if (hit && dot(vectorAt(hit.normal, 0), toEye) > 0) return hit;
  for (const radius of GAPS) {
    for (let k = 0; k < AROUND; k++) {
      const angle = (2 * Math.PI * k) / AROUND;
      const other = viewer.pick(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
      if (other && (!hit || dot(vectorAt(other.normal, 0), toEye) > 0)) return other;
      other?.free();
    }
  }
  // Open surfaces are seen from behind.
  return hit;
}

/** The point whose disc was hit. */
function atPoint({ mesh, triangles, weights }: Drawn, hit: Hit): Hit {
  const middle = entry(mesh.triangles, 3 * hit.triangle);
  const there = {
    triangle: entry(triangles, middle),
    weights: weights.slice(3 * middle, 3 * middle + 3),
    point: mesh.positions.slice(3 * middle, 3 * middle + 3),
    free: () => hit.free(),
  };
  return Object.create(hit, Object.getOwnPropertyDescriptors(there)) as Hit;
}
