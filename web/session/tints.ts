/** What the ground looks like, and what a path over it costs. */
import type { DrawMesh, DrawPath } from '../protocol';
import { CLOSED_GATE, costOf, EVEN, type Ground, OPEN_GATE, WALL } from '../state/ground';
import type { Places } from '../state/places';
import { parseColour } from '../state/styles';
import type { Edges } from '../view/layers';
import { entry } from '../state/entry';
import { between, distance, type Vector, vectorAt } from '../state/vector';

/** Colors by the power of two that it costs, from the cheapest on. */
const CHEAPEST = [-10, '#2f8fd8'] as const;
const SCALE: readonly (readonly [power: number, colour: string])[] = [
  [-1, '#93aebd'],
  [1, '#dcb765'],
  [2, '#7a4a22'],
  [4, '#41230f'],
  [10, '#160a06'],
];
/** Opacity of what costs hardly more than 1, and of what costs twice or half as much and beyond. */
const OPACITY = [0.35, 0.78] as const;

export const WALL_COLOURS = { wall: '#5d626e', gate: '#c8601f', open: '#4fae6b' } as const;

/** The color of a cost; that of even ground is none. */
export function colourOfCost(cost: number): string {
  const power = Math.log2(cost);
  const next = SCALE.findIndex(([other]) => other >= power);
  const [low, dark] = SCALE[next - 1] ?? CHEAPEST;
  const [high, light] = entry(SCALE, Math.max(0, next));
  const share = Math.min(1, Math.max(0, (power - low) / (high - low)));
  const mixed = between(parseColour(dark), parseColour(light), share);
  return `rgb(${mixed.map(Math.round).join(', ')})`;
}

/** Linear RGB and opacity, 255 for walls; of each code. */
const TINTS = Uint8Array.from({ length: 256 * 4 });
for (let code = 1; code < 256; code++) TINTS.set(tintOf(code), 4 * code);

function tintOf(code: number): [number, number, number, number] {
  if (code === WALL) return [...linear(WALL_COLOURS.wall), 255];
  if (code === CLOSED_GATE) return [...linear(WALL_COLOURS.gate), 255];
  if (code === OPEN_GATE) return [...linear(WALL_COLOURS.open), 255 * OPACITY[1]];
  const cost = costOf(code);
  const strength = Math.min(1, Math.abs(Math.log2(cost)));
  return [...linear(colourOfCost(cost)), 255 * (OPACITY[0] + strength * (OPACITY[1] - OPACITY[0]))];
}

function linear(colour: string): [number, number, number] {
  const [r, g, b] = parseColour(colour);
  return [linearChannel(r), linearChannel(g), linearChannel(b)];
}

function linearChannel(value: number): number {
  return Math.round(255 * (value / 255) ** 2.2);
}

/** `#F × 4`. */
export function tintsOf({ faces }: Ground, { triangles }: DrawMesh): Uint8Array {
  const tints = new Uint8Array((4 * triangles.length) / 3);
  const [texels, table] = [new Uint32Array(tints.buffer), new Uint32Array(TINTS.buffer)];
  faces.forEach((code, face) => {
    if (code !== EVEN) texels[face] = entry(table, code);
  });
  return tints;
}

/** Walls along edges, as they lie on the mesh. */
export function wallsOf({ lines }: Ground, places: Places): Edges[] {
  const ends = { wall: [] as number[], open: [] as number[] };
  for (const { vertices, open } of lines) {
    const points = vertices.map((vertex): Vector => places.at({ vertex })?.position ?? [0, 0, 0]);
    points.slice(1).forEach((to, index) => ends[open ? 'open' : 'wall'].push(...entry(points, index), ...to));
  }
  return (['wall', 'open'] as const).map((kind) => ({
    ends: Float32Array.from(ends[kind]),
    colour: WALL_COLOURS[kind],
    width: 5,
  }));
}

/** What a unit of a path costs at an arc length from its start. */
export function costAlong(path: DrawPath | null): ((arc: number) => number) | undefined {
  if (!path || path.segmentCosts.length === 0) return undefined;
  const { points, segmentCosts, length, drawnLength } = path;
  const scale = drawnLength > 0 ? length / drawnLength : 1;
  let arc = 0;
  const ends = Float64Array.from(segmentCosts, (_, i) => {
    arc += scale * distance(vectorAt(points, i), vectorAt(points, i + 1));
    return arc;
  });
  return (at) => {
    const segment = ends.findIndex((end) => end > at);
    return entry(segmentCosts, segment < 0 ? segmentCosts.length - 1 : segment);
  };
}
