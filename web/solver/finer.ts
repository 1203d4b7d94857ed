/**
 * A coarse surface divided for drawing: distance is not linear on its triangles, so that stripes by its corners alone would be chords.
 * The longest edges are divided in the middle, and with each the triangles on both sides, until all are short (M.-C. Rivara,
 * "Algorithms for refining triangular grids suitable for adaptive and multigrid techniques", 1984): nothing comes apart, and angles
 * stay about as they are.
 */
import type { DrawMesh, FinerMesh, FinerPlaces, TrianglePlaces } from '../protocol';
import { entry } from '../state/entry';
import { between, distance, type Vector, vectorsIn } from '../state/vector';

/** Edges that are drawn longer are divided, where a model reaches from −1 to 1: stripes are then off by less than a pixel or so. */
const LONG = 0.05;
/** The most middles of edges: the distance at each takes microseconds with every field. */
const MOST_MIDDLES = 6000;
/** A round divides the edges that are longer than this share of the longest one. */
const ROUND = 0.7;
/** Triangles of a leaf of the renderer's hierarchy. */
const LEAF = 8;

type Ends = readonly [number, number];

interface Place {
  triangle: number;
  weights: Vector;
}

/** A triangle of the drawing, or a part of one. */
interface Part {
  corners: Vector;
  /** The triangle, and the weights of its corners at those of the part. */
  origin: number;
  weights: [Vector, Vector, Vector];
}

/** The surface divided, and where distances are drawn on it. */
export function divided(surface: DrawMesh): { finer: FinerMesh; places: FinerPlaces } {
  const division = new Division(surface);
  division.divide();
  // Parts of one triangle come one after another, as those of one material have to.
  const parts = division.parts.toSorted((a, b) => a.origin - b.origin);
  const middles = Uint32Array.from(division.middles.flat());
  const mesh = meshOf(surface, parts, middles);
  const origins = Uint32Array.from(parts, ({ origin }) => origin);
  const weights = Float32Array.from(parts.flatMap((part) => part.weights.flat()));
  const places = { middles: placesOf(division.places), ...cornersOf(parts) };
  return { finer: { mesh, middles, origins, weights }, places };
}

function placesOf(places: readonly Place[]): TrianglePlaces {
  return {
    triangles: Uint32Array.from(places, ({ triangle }) => triangle),
    weights: Float64Array.from(places.flatMap((place) => place.weights)),
  };
}

/** The corners of parts, those of one triangle once each. */
function cornersOf(parts: readonly Part[]): Pick<FinerPlaces, 'corners' | 'ofCorners'> {
  const places: Place[] = [];
  const numbers = new Map<string, number>();
  const ofCorners = parts.flatMap(({ corners, origin, weights }) =>
    corners.map((corner, k) => {
      const key = `${origin},${corner}`;
      const number = numbers.get(key) ?? places.push({ triangle: origin, weights: entry(weights, k) }) - 1;
      numbers.set(key, number);
      return number;
    }),
  );
  return { corners: placesOf(places), ofCorners: Uint32Array.from(ofCorners) };
}

function meshOf(surface: DrawMesh, parts: readonly Part[], middles: Uint32Array): DrawMesh {
  const firstOf = new Uint32Array(surface.triangles.length / 3 + 1).fill(parts.length);
  for (const [index, { origin }] of [...parts.entries()].toReversed()) firstOf[origin] = index;
  const positions = withMiddles(surface.positions, middles, 3);
  const reach = positions.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return {
    positions,
    normals: withMiddles(surface.normals, middles, 3),
    triangles: Uint32Array.from(parts.flatMap(({ corners }) => corners)),
    texcoords: withMiddles(surface.texcoords, middles, 4),
    colors: withMiddles(surface.colors, middles, 4),
    runs: surface.runs.map((value, i) => (i % 3 < 2 ? entry(firstOf, value) : value)),
    order: Uint32Array.from(parts.keys()),
    // Each box has everything in it: so few triangles are looked through one by one under the pointer.
    boxes: Float32Array.from({ length: 6 * (2 * Math.ceil(parts.length / LEAF) - 1) }, (_, i) =>
      i % 6 < 3 ? -reach : reach,
    ),
  };
}

class Division {
  readonly parts: Part[];
  /** The ends of each edge that was divided, and where its middle is. */
  readonly middles: Ends[] = [];
  readonly places: Place[] = [];
  readonly #positions: Vector[];
  /** The long edges, each with its parts. */
  readonly #edges = new Map<string, { ends: Ends; length: number; parts: Set<Part> }>();

  constructor({ positions, triangles }: DrawMesh) {
    this.#positions = vectorsIn(positions);
    this.parts = vectorsIn(triangles).map((corners, origin) => ({
      corners,
      origin,
      weights: [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ],
    }));
    for (const part of this.parts) this.#list(part);
  }

  divide(): void {
    while (this.#edges.size > 0 && this.middles.length < MOST_MIDDLES) {
      const edges = [...this.#edges.values()].toSorted((a, b) => b.length - a.length);
      const least = ROUND * entry(edges, 0).length;
      const longest = edges.filter(({ length }) => length >= least).slice(0, MOST_MIDDLES - this.middles.length);
      for (const { ends, parts } of longest) this.#divideEdge(ends, [...parts]);
    }
  }

  /** Notes the long edges of a part. */
  #list(part: Part): void {
    for (const ends of sides(part)) {
      const length = distance(entry(this.#positions, ends[0]), entry(this.#positions, ends[1]));
      if (length <= LONG) continue;
      const edge = this.#edges.get(keyOf(ends)) ?? { ends, length, parts: new Set() };
      edge.parts.add(part);
      this.#edges.set(keyOf(ends), edge);
    }
  }

  #divideEdge(ends: Ends, parts: readonly Part[]): void {
    const middle = this.#positions.length;
    this.#positions.push(between(entry(this.#positions, ends[0]), entry(this.#positions, ends[1]), 0.5));
    this.middles.push(ends);
    for (const [index, part] of parts.entries()) {
      for (const side of sides(part)) this.#edges.get(keyOf(side))?.parts.delete(part);
      const first = sides(part).findIndex((side) => keyOf(side) === keyOf(ends));
      const second = (first + 1) % 3;
      const weights = between(entry(part.weights, first), entry(part.weights, second), 0.5);
      if (index === 0) this.places.push({ triangle: part.origin, weights });
      const other: Part = { origin: part.origin, corners: [...part.corners], weights: [...part.weights] };
      [part.corners[second], part.weights[second]] = [middle, weights];
      [other.corners[first], other.weights[first]] = [middle, weights];
      this.parts.push(other);
      this.#list(part);
      this.#list(other);
    }
    this.#edges.delete(keyOf(ends));
  }
}

function sides({ corners: [a, b, c] }: Part): Ends[] {
  return [
    [a, b],
    [b, c],
    [c, a],
  ];
}

function keyOf([a, b]: Ends): string {
  return a < b ? `${a},${b}` : `${b},${a}`;
}

/**
 * Values of vertices, `size` numbers each, and after them those of middles: #E × 2 vertices, each of them in the middle of an edge, which
 * come before it.
 */
export function withMiddles<A extends Float32Array | Uint16Array | Int8Array>(
  values: A,
  middles: ArrayLike<number>,
  size: number,
): A {
  if (values.length === 0) return values;
  const all = new (values.constructor as new (length: number) => A)(values.length + (middles.length / 2) * size);
  all.set(values);
  for (let edge = 0, to = values.length; to < all.length; edge++) {
    const [a, b] = [size * entry(middles, 2 * edge), size * entry(middles, 2 * edge + 1)];
    for (let k = 0; k < size; k++, to++) all[to] = (entry(all, a + k) + entry(all, b + k)) / 2;
  }
  return all;
}
