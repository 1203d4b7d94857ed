/** How the brush changes the ground: which triangles a disc on the surface covers, strokes and areas. */
import { type Brush, MATERIAL_COSTS } from './brush';
import { blend, CLOSED_GATE, codeOf, EVEN, type Ground, isCost, isWall, OPEN_GATE, WALL, withFaces } from './ground';
import { cornersOf, distance, dot, minus, moved, type Vector, weighted } from './vector';
import { entry } from './entry';

/** The code that a material paints. */
export function codeOfMaterial({ material, cost }: Pick<Brush, 'material' | 'cost'>): number {
  if (material === 'wall') return WALL;
  if (material === 'gate') return CLOSED_GATE;
  return codeOf(material === 'custom' ? cost : MATERIAL_COSTS[material]);
}

/** Triangles as they are drawn, and what lies beside each. */
export interface Terrain {
  positions: Float32Array;
  triangles: Uint32Array;
  /** `#F × 3`; itself at the boundary. */
  neighbors: Uint32Array;
}

export interface Disc {
  /** The triangle that its center is on. */
  face: number;
  center: Vector;
  radius: number;
}

/** The triangles that a disc touches, joined to its middle by triangles that it touches too, and how far each is. */
export function touched(terrain: Terrain, { face, center, radius }: Disc): Map<number, number> {
  const found = new Map([[face, 0]]);
  const waiting = [face];
  for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
    for (const other of terrain.neighbors.subarray(3 * next, 3 * next + 3)) {
      if (found.has(other)) continue;
      const away = distanceTo(terrain, other, center);
      if (away > radius) continue;
      found.set(other, away);
      waiting.push(other);
    }
  }
  return found;
}

/** The triangles of the same code around one. */
export function areaOf(neighbors: Uint32Array, faces: Uint8Array, face: number): number[] {
  const code = faces[face] ?? EVEN;
  const found = new Set([face]);
  // What is added while it goes on is visited too.
  for (const next of found) {
    for (const other of neighbors.subarray(3 * next, 3 * next + 3)) {
      if ((faces[other] ?? EVEN) === code) found.add(other);
    }
  }
  return [...found];
}

/** A stroke of the brush: however often it passes a place, it paints it once. */
export class Stroke {
  readonly #before: Uint8Array;
  /** How much of each triangle is painted, 0 to 1. */
  readonly #shares: Float32Array;
  readonly #code: number;
  readonly #soft: number;

  constructor(ground: Ground, triangles: number, brush: Brush) {
    this.#before = ground.faces.length === triangles ? ground.faces : new Uint8Array(triangles);
    this.#shares = new Float32Array(triangles);
    this.#code = codeOfMaterial(brush);
    this.#soft = isCost(this.#code) ? brush.soft : 0;
  }

  /** The ground after the stroke has passed a disc. */
  paint(ground: Ground, terrain: Terrain, disc: Disc): Ground {
    const faces = ground.faces.length > 0 ? ground.faces.slice() : this.#before.slice();
    const hard = (1 - this.#soft) * disc.radius;
    for (const [face, away] of touched(terrain, disc)) {
      // Walls cover all that they touch, so that they have no holes; the rest what the disc covers half.
      const reach = isCost(this.#code) && face !== disc.face ? distanceToMiddle(terrain, face, disc.center) : away;
      const share = reach <= hard ? 1 : fade((reach - hard) / (disc.radius - hard));
      if (share <= entry(this.#shares, face)) continue;
      this.#shares[face] = share;
      faces[face] = painted(entry(this.#before, face), this.#code, share);
    }
    return withFaces(ground, faces);
  }
}

function painted(before: number, code: number, share: number): number {
  if (isCost(before) && isCost(code)) return blend(before, code, share);
  return share >= 0.5 ? code : before;
}

/** A smooth step down from 1 to 0. */
function fade(share: number): number {
  const rest = 1 - Math.min(1, Math.max(0, share));
  return rest * rest * (3 - 2 * rest);
}

/** All of some triangles in one material. */
export function filled(ground: Ground, triangles: number, faces: Iterable<number>, code: number): Ground {
  const changed = ground.faces.length === triangles ? ground.faces.slice() : new Uint8Array(triangles);
  for (const face of faces) changed[face] = code;
  return withFaces(ground, changed);
}

/** Opens the wall or gate around a triangle, or closes it; null where there is none. */
export function toggled(ground: Ground, neighbors: Uint32Array, face: number): Ground | null {
  const code = ground.faces[face] ?? EVEN;
  if (!isWall(code) && code !== OPEN_GATE) return null;
  const area = areaOf(neighbors, ground.faces, face);
  return filled(ground, ground.faces.length, area, code === OPEN_GATE ? CLOSED_GATE : OPEN_GATE);
}

const MIDDLE: Vector = [1 / 3, 1 / 3, 1 / 3];

function distanceToMiddle({ positions, triangles }: Terrain, face: number, center: Vector): number {
  return distance(center, weighted(cornersOf(positions, triangles, face), MIDDLE));
}

/** From a point to the nearest one of a triangle. */
function distanceTo({ positions, triangles }: Terrain, face: number, point: Vector): number {
  const [a, b, c] = cornersOf(positions, triangles, face);
  const [ab, ac, ap] = [minus(b, a), minus(c, a), minus(point, a)];
  const [abab, abac, acac] = [dot(ab, ab), dot(ab, ac), dot(ac, ac)];
  const [apab, apac] = [dot(ap, ab), dot(ap, ac)];
  const whole = abab * acac - abac * abac;
  const [u, v] = [(acac * apab - abac * apac) / whole, (abab * apac - abac * apab) / whole];
  if (u >= 0 && v >= 0 && u + v <= 1) return distance(ap, weighted([ab, ac, ap], [u, v, 0]));
  return Math.min(distanceToEdge(point, a, b), distanceToEdge(point, b, c), distanceToEdge(point, c, a));
}

function distanceToEdge(point: Vector, from: Vector, to: Vector): number {
  const [along, there] = [minus(to, from), minus(point, from)];
  const share = Math.min(1, Math.max(0, dot(there, along) / (dot(along, along) || 1)));
  return distance(there, moved([0, 0, 0], along, share));
}
