/** Triangles that lie on the surface, a little above it, in materials of their own. */
import type { DrawPose, Material } from '../protocol';
import { entry } from '../state/entry';
import { moved, normalized, type Vector, vectorAt } from '../state/vector';
import type { Patches } from './layers';
import type { View } from './view';

/** What lies on the surface, from below to above. */
const GROUPS = ['cells', 'decals'] as const;
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

/** A place of a drawn triangle so far above the surface, with the normal there. */
export function lifted(
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
export class PatchMesh {
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #texcoords: number[] = [];
  readonly #colours: number[] = [];
  readonly #corners: number[] = [];

  /** `colour`: linear RGBA, 0 to 1. Its number. */
  vertex([position, normal]: [Vector, Vector], colour: readonly number[], texture: readonly [number, number]): number {
    this.#positions.push(...position);
    this.#normals.push(...normal);
    this.#texcoords.push(...texture, 0, 0);
    this.#colours.push(...colour.map((value) => Math.round(65_535 * value)));
    return this.#positions.length / 3 - 1;
  }

  corner(vertex: number): void {
    this.#corners.push(vertex);
  }

  /** All of it in one material. */
  in(material: Material, images: ImageBitmap[]): Patches {
    const mesh = {
      positions: Float32Array.from(this.#positions),
      normals: Float32Array.from(this.#normals),
      triangles: Uint32Array.from(this.#corners),
      texcoords: Float32Array.from(this.#texcoords),
      colors: Uint16Array.from(this.#colours),
      runs: Uint32Array.of(0, this.#corners.length / 3, 0),
    };
    return { mesh, materials: [material], images };
  }
}
