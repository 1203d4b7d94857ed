/** The type of the numbers that answers have. */
export type Floats = Float64Array | Float32Array;

/** What a mesh is, and what was done when it was made of triangles. */
export interface Report {
  /** Vertices as they were given. */
  readonly vertices: number;
  /** Triangles as they were given. */
  readonly faces: number;
  /** Polygons of a file that these are cut from; a triangle is one. */
  readonly polygons: number;
  /** Vertices that were merged into another of the same position, or across a crack. */
  readonly weldedVertices: number;
  /** Those of them that lie on the other side of a crack. */
  readonly crackVertices: number;
  /** Vertices that no triangle uses; nothing reaches them. */
  readonly unreferencedVertices: number;
  /** Triangles without area, which were left out. */
  readonly degenerateFaces: number;
  /** Triangles that were there before, which were left out. */
  readonly duplicateFaces: number;
  /** Triangles that were turned over, so that orientations agree. */
  readonly flippedFaces: number;
  /** Edges of more than two triangles. */
  readonly nonManifoldEdges: number;
  /** Parts that no edge joins. */
  readonly components: number;
  /** Closed chains of edges of one triangle. */
  readonly boundaryLoops: number;
  /** Vertices less edges plus faces. */
  readonly eulerCharacteristic: number;
  /** The mean length of the edges, in the unit of positions. */
  readonly meanEdge: number;
  /** The unit of lengths as a file says it, such as `mm`. */
  readonly unit: string | undefined;
  /** What was left out of a file, or read otherwise than it is written: a sentence each. */
  readonly warnings: readonly string[];
}

/** Distances, and how they were found. */
export interface Answer<F extends Floats = Float64Array> {
  /** One a vertex, in the unit of positions; Infinity where nothing is reached. */
  distances: F;
  /** What found them: `exact`, `propagation` or `heat`. */
  method: string;
  /** Distances below this are exact. */
  exactBelow: number;
  /** How many windows crossed a face. */
  windows: number;
}

/** Distances of pairs: row k has those from source k. */
export interface Matrix<F extends Floats = Float64Array> {
  /** `rows × columns`, row after row. */
  data: F;
  rows: number;
  columns: number;
}

/** Places on faces, one after the other. */
export interface PlacesOnFaces<F extends Floats = Float64Array> {
  /** The face of each. */
  faces: Uint32Array;
  /** Three of each: of the corners of its face, of sum 1. */
  weights: F;
  /** Three coordinates of each. */
  points: F;
}

/** The places that are nearest to points in space. */
export interface Snapped<F extends Floats = Float64Array> extends PlacesOnFaces<F> {
  /** How far each is from its point. */
  distances: F;
}

/** A path on the surface, from its start. */
export interface Path<F extends Floats = Float64Array> extends PlacesOnFaces<F> {
  /** In the unit of positions. */
  length: number;
  /** Its length, each part times what a unit of it costs. */
  cost: number;
}

/** A walk as straight as the surface lets one. */
export interface Walk<F extends Floats = Float64Array> extends PlacesOnFaces<F> {
  /** How far it came, in the unit of positions. */
  length: number;
  /** Unit vector of the direction at its end. */
  direction: F;
  /** Whether the surface ended before. */
  isAtBoundary: boolean;
}

/** In which direction shortest paths leave a source, and how long they are. */
export interface LogMap<F extends Floats = Float64Array> {
  /** u and v of each vertex: as long as its distance, v to the left of u as seen from outside; NaN where nothing is reached. */
  coordinates: F;
  /** One a vertex; Infinity where nothing is reached. */
  distances: F;
  /** Two unit vectors in space, along u and along v. */
  axes: F;
}

/** What is nearest to each of several sources. */
export interface Cells<F extends Floats = Float64Array> {
  /** Of each vertex the number of its nearest source; -1 where none is reached. */
  nearest: Int32Array;
  /** How far that is; Infinity where none is reached. */
  distances: F;
}

/** Places spread over the surface. */
export interface Samples<F extends Floats = Float64Array> extends PlacesOnFaces<F> {
  /** Their vertices; undefined where they were relaxed. */
  vertices: Uint32Array | undefined;
  /** How far the farthest vertex is from one. */
  radius: number;
}

/** Where squared distances from weighted places sum to least. */
export interface Mean<F extends Floats = Float64Array> {
  face: number;
  /** Three, of the corners of the face, of sum 1. */
  weights: F;
  /** Three coordinates. */
  point: F;
  /** The mean squared distance there. */
  variance: number;
}

/** An isoline of values at vertices. */
export interface Isoline<F extends Floats = Float64Array> {
  value: number;
  curves: IsolineCurve<F>[];
  /** Of all its curves. */
  length: number;
  /** The area of what is below the value. */
  enclosedArea: number;
}

/** A curve of an isoline; larger values are on its left, seen from outside. */
export interface IsolineCurve<F extends Floats = Float64Array> {
  /** Three coordinates of each point. */
  points: F;
  /** The face of each segment. */
  faces: Uint32Array;
  isClosed: boolean;
  length: number;
}
