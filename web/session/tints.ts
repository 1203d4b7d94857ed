/** What the ground looks like, and what a path over it costs. */
import type { DrawMesh, SurfacePath } from '../protocol';
import { CLOSED_GATE, costOf, EVEN, type Ground, OPEN_GATE, WALL } from '../state/ground';
import type { Places } from '../state/places';
import { parseColour } from '../state/styles';
import type { Edges } from '../view/layers';

/** Colors by the power of two that it costs, from the cheapest on. */
const SCALE: readonly (readonly [power: number, colour: string])[] = [
  [-10, '#2f8fd8'],
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
  const next = Math.max(
    1,
    SCALE.findIndex(([other]) => other >= power),
  );
  const [[low, dark], [high, light]] = [SCALE[next - 1], SCALE[next]];
  const share = Math.min(1, Math.max(0, (power - low) / (high - low)));
  const [from, to] = [parseColour(dark), parseColour(light)];
  return `rgb(${from.map((value, k) => Math.round(value + share * (to[k] - value))).join(', ')})`;
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
  const [r, g, b] = parseColour(colour).map((value) => Math.round(255 * (value / 255) ** 2.2));
  return [r, g, b];
}

/** `#F × 4`. */
export function tintsOf({ faces }: Ground, { triangles }: DrawMesh): Uint8Array {
  const tints = new Uint8Array((4 * triangles.length) / 3);
  const [texels, table] = [new Uint32Array(tints.buffer), new Uint32Array(TINTS.buffer)];
  faces.forEach((code, face) => {
    if (code !== EVEN) texels[face] = table[code];
  });
  return tints;
}

/** Walls along edges, as they lie on the mesh. */
export function wallsOf({ lines }: Ground, places: Places): Edges[] {
  const ends = { wall: [] as number[], open: [] as number[] };
  for (const { vertices, open } of lines) {
    const points = vertices.map((vertex) => places.at({ vertex })?.position ?? [0, 0, 0]);
    for (let i = 1; i < points.length; i++) ends[open ? 'open' : 'wall'].push(...points[i - 1], ...points[i]);
  }
  return (['wall', 'open'] as const).map((kind) => ({
    ends: Float32Array.from(ends[kind]),
    colour: WALL_COLOURS[kind],
    width: 5,
  }));
}

/** What a unit of a path costs at an arc length from its start. */
export function costAlong(path: SurfacePath | null): ((arc: number) => number) | undefined {
  if (!path || path.segmentCosts.length === 0) return undefined;
  const { points, segmentCosts, length, drawnLength } = path;
  const scale = drawnLength > 0 ? length / drawnLength : 1;
  let arc = 0;
  const ends = Float64Array.from(segmentCosts, (_, i) => {
    const [dx, dy, dz] = [0, 1, 2].map((k) => points[3 * i + 3 + k] - points[3 * i + k]);
    arc += scale * Math.hypot(dx, dy, dz);
    return arc;
  });
  return (at) => {
    const segment = ends.findIndex((end) => end > at);
    return segmentCosts[segment < 0 ? segmentCosts.length - 1 : segment];
  };
}
