/** Triangles that lie on the surface, a little above it, in materials of their own. */
import type { DrawPose, Material } from '../protocol';
import { entry } from '../state/entry';
import type { Patches } from './layers';
import type { View } from './view';

/** What lies on the surface, from below to above. */
const GROUPS = ['sides', 'cells', 'decals'] as const;
type Group = (typeof GROUPS)[number];

/** What lets the surface be seen through it. */
export const FILM: Material = {
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

const laid = new WeakMap<View, Map<Group, Patches>>();

/** Lays something on the surface, beside what else lies there; null: nothing of this. */
export function layPatches(view: View, group: Group, patches: Patches | null): void {
  const groups = laid.get(view) ?? new Map<Group, Patches>();
  laid.set(view, groups);
  if (patches && patches.mesh.triangles.length > 0) groups.set(group, patches);
  else groups.delete(group);
  const all = GROUPS.flatMap((name) => groups.get(name) ?? []);
  view.setPatches(all.length > 0 ? all.reduce(together) : null);
}

/** Both, the second one above. */
export function together(one: Patches, other: Patches): Patches {
  const vertices = one.mesh.positions.length / 3;
  const triangles = one.mesh.triangles.length / 3;
  const textures = (material: Material) =>
    material.textures.map((texture) => texture && { ...texture, image: texture.image + one.images.length });
  const run = (value: number, k: number) => value + (k % 3 === 2 ? one.materials.length : triangles);
  return {
    mesh: {
      positions: joined(Float32Array, one.mesh.positions, other.mesh.positions),
      normals: joined(Float32Array, one.mesh.normals, other.mesh.normals),
      triangles: joined(
        Uint32Array,
        one.mesh.triangles,
        other.mesh.triangles.map((vertex) => vertex + vertices),
      ),
      texcoords: joined(Float32Array, one.mesh.texcoords, other.mesh.texcoords),
      colors: joined(Uint16Array, one.mesh.colors, other.mesh.colors),
      runs: joined(Uint32Array, one.mesh.runs, other.mesh.runs.map(run)),
    },
    materials: [
      ...one.materials,
      ...other.materials.map((material) => ({ ...material, textures: textures(material) })),
    ],
    images: [...one.images, ...other.images],
  };
}

function joined<T extends Float32Array | Uint32Array | Uint16Array>(
  Kind: new (length: number) => T,
  one: T,
  other: T,
): T {
  const both = new Kind(one.length + other.length);
  both.set(one);
  both.set(other, one.length);
  return both;
}

/** A mesh that grows by vertices and corners of triangles, up to so many of these. */
export class PatchMesh {
  readonly #pose: DrawPose;
  readonly #positions: Float32Array;
  readonly #normals: Float32Array;
  readonly #texcoords: Float32Array;
  readonly #colours: Uint16Array;
  readonly #corners: Uint32Array;
  #vertices = 0;
  #count = 0;

  constructor(pose: DrawPose, most: number) {
    this.#pose = pose;
    this.#positions = new Float32Array(3 * most);
    this.#normals = new Float32Array(3 * most);
    this.#texcoords = new Float32Array(4 * most);
    this.#colours = new Uint16Array(4 * most).fill(65_535);
    this.#corners = new Uint32Array(most);
  }

  /**
   * A vertex so far above a place of the surface: corners of a drawn triangle, and from `first` on their weights. Its number. It is white
   * and opaque unless `colour` follows.
   */
  vertex(corners: ArrayLike<number>, weights: ArrayLike<number>, first: number, lift: number): number {
    const { positions, normals } = this.#pose;
    const at = 3 * this.#vertices;
    const blend = (values: Float32Array, axis: number) => {
      let sum = 0;
      for (let k = 0; k < 3; k++) sum += entry(weights, first + k) * entry(values, 3 * entry(corners, k) + axis);
      return sum;
    };
    const [x, y, z] = [blend(normals, 0), blend(normals, 1), blend(normals, 2)];
    const length = Math.hypot(x, y, z) || 1;
    this.#normals[at] = x / length;
    this.#normals[at + 1] = y / length;
    this.#normals[at + 2] = z / length;
    for (let axis = 0; axis < 3; axis++) {
      this.#positions[at + axis] = blend(positions, axis) + lift * entry(this.#normals, at + axis);
    }
    return this.#vertices++;
  }

  /** Of the last vertex, linear RGBA from 0 to 1. */
  colour(colour: readonly number[]): void {
    const first = 4 * (this.#vertices - 1);
    colour.forEach((value, k) => (this.#colours[first + k] = Math.round(65_535 * value)));
  }

  /** Where the last vertex is in the image. */
  texture(u: number, v: number): void {
    const first = 4 * (this.#vertices - 1);
    this.#texcoords[first] = u;
    this.#texcoords[first + 1] = v;
  }

  corner(vertex: number): void {
    this.#corners[this.#count++] = vertex;
  }

  /** All of it in one material. */
  in(material: Material, images: ImageBitmap[]): Patches {
    const mesh = {
      positions: this.#positions.subarray(0, 3 * this.#vertices),
      normals: this.#normals.subarray(0, 3 * this.#vertices),
      triangles: this.#corners.subarray(0, this.#count),
      texcoords: this.#texcoords.subarray(0, 4 * this.#vertices),
      colors: this.#colours.subarray(0, 4 * this.#vertices),
      runs: Uint32Array.of(0, this.#count / 3, 0),
    };
    return { mesh, materials: [material], images };
  }
}

/** The corner of a triangle that weights, from `first` on, are of alone; −1 where they are of several. */
export function cornerAt(weights: ArrayLike<number>, first: number): number {
  for (let k = 0; k < 3; k++) if (weights[first + k] === 1) return k;
  return -1;
}
