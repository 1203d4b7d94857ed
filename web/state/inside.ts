/** How the inside of a mesh of tetrahedra is looked into. */
import type { InnerCut } from '../protocol';
import type { Method } from '../wasm/contract';
import type { Box } from './places';
import { between, dot, minus, moved, type Vector } from './vector';

/** Whether a mesh can be asked by a method: inside of tetrahedra distance is by heat, or by waves from vertex to vertex. */
export function isMethodOf(method: Method, isInside: boolean): boolean {
  return !isInside || method === 'auto' || method === 'heat';
}

export const CUTS = ['none', 'plane', 'wedge'] as const;

export interface Inside {
  /** What is cut away: nothing, what is beyond a plane, or a wedge. */
  cut: (typeof CUTS)[number];
  /** The direction of what is cut away: degrees around the axis that points up, and above the horizon. */
  turn: number;
  tilt: number;
  /** Where the plane, or the edge of the wedge, is along that: 0 in the middle, −1 and 1 at the ends of the mesh. */
  place: number;
  /** Degrees between the two planes of the wedge. */
  opening: number;
  /** Whether whole tetrahedra stay; else the cut is smooth. */
  whole: boolean;
  /** How far apart tetrahedra are moved: 1 makes the mesh twice as wide. */
  gap: number;
  /** From one shell of equal distance to the next, as a share of the largest distance; 0: no shells. */
  spacing: number;
  /** Whether there are arrows on the cut. */
  arrows: boolean;
}

export const WHOLE: Inside = {
  cut: 'none',
  turn: 0,
  tilt: 0,
  place: 0,
  opening: 90,
  whole: false,
  gap: 0,
  spacing: 0,
  arrows: false,
};

/** What a mesh of tetrahedra shows at first. */
export const HALVED: Inside = { ...WHOLE, cut: 'plane', turn: 30, tilt: 10, place: 0 };

/** What numbers can be. */
export const INSIDE_RANGES = {
  turn: [-180, 180],
  tilt: [-90, 90],
  place: [-1, 1],
  opening: [10, 180],
  gap: [0, 2],
  spacing: [0, 0.5],
} as const satisfies Partial<Record<keyof Inside, readonly [number, number]>>;

/** What is a number, by the names that links have for them. */
export const INSIDE_NUMBERS = Object.keys(INSIDE_RANGES) as readonly (keyof typeof INSIDE_RANGES)[];

/** The narrowest spacing of shells but for none. */
export const LEAST_SPACING = 0.02;

/** Tetrahedra that a surface can be filled with, and the default. */
export const FILLS = [1_000, 1_000_000] as const;
export const DEFAULT_FILL = 63_000;

export function isWhole({ cut, whole, gap, spacing, arrows }: Inside): boolean {
  return cut === 'none' && !whole && gap === 0 && spacing === 0 && !arrows;
}

/** The same for the solver, of a mesh in a box as it is drawn; null where nothing of the inside is seen. */
export function innerCutOf(inside: Inside, box: Box): InnerCut | null {
  if (isWhole(inside)) return null;
  const { whole, gap, spacing, arrows } = inside;
  return { planes: planesOf(inside, box), whole, gap, spacing, arrows };
}

/** Where what is cut away lies, as it is drawn. */
export function directionOf({ turn, tilt }: Pick<Inside, 'turn' | 'tilt'>): Vector {
  const [around, above] = [radians(turn), radians(tilt)];
  return [Math.sin(around) * Math.cos(above), Math.sin(above), Math.cos(around) * Math.cos(above)];
}

/** Turn and tilt of a direction, whole degrees. */
export function anglesOf([x, y, z]: Vector): Pick<Inside, 'turn' | 'tilt'> {
  const length = Math.hypot(x, y, z) || 1;
  return { turn: degrees(Math.atan2(x, z)), tilt: degrees(Math.asin(y / length)) };
}

/** Where a plane is: its direction, and its place along that. */
export type CutPlane = Pick<Inside, 'turn' | 'tilt' | 'place'>;

/** The middle of the plane, or of the edge of the wedge. */
export function middleOf(plane: CutPlane, box: Box): Vector {
  const direction = directionOf(plane);
  const away = plane.place * reachOf(direction, box);
  return moved(between(...box, 0.5), direction, away);
}

/** How far a mesh reaches from its middle in a direction. */
export function reachOf(direction: Vector, box: Box): number {
  const [x, y, z] = direction;
  return dot([Math.abs(x), Math.abs(y), Math.abs(z)], minus(box[1], box[0])) / 2;
}

/** Unit normal and offset of each plane. */
function planesOf(inside: Inside, box: Box): number[] {
  const middle = middleOf(inside, box);
  const planes = inside.cut === 'wedge' ? [-1, 1].map((side) => sideOf(inside, side)) : [directionOf(inside)];
  return inside.cut === 'none' ? [] : planes.flatMap((normal) => normal.concat(dot(normal, middle)));
}

/** The normal of one side of the wedge: its direction turned about the edge, which is upright where there is no tilt. */
function sideOf(inside: Inside, side: number): Vector {
  const away = radians(90 - inside.opening / 2);
  const ahead = directionOf(inside);
  const around = radians(inside.turn);
  const across: Vector = [Math.cos(around), 0, -Math.sin(around)];
  return moved(moved([0, 0, 0], ahead, Math.cos(away)), across, side * Math.sin(away));
}

function radians(angle: number): number {
  return (angle * Math.PI) / 180;
}

function degrees(angle: number): number {
  return Math.round((angle * 180) / Math.PI);
}
