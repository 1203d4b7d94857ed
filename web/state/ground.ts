/** Ground of different difficulty: what it costs to walk on each triangle, and walls; as bytes, and as text in a link. */
import type { GroundChange } from '../protocol';
import { pack, unpack } from './text';
import { entry } from './entry';

/** A wall along edges. */
export interface WallLine {
  /** Vertices of the input, each with an edge to the next. */
  vertices: readonly number[];
  /** A gate that lets through. */
  open: boolean;
}

export interface Ground {
  /** A code of each drawn triangle, see `costOf`; empty where nothing is painted. */
  faces: Uint8Array;
  lines: readonly WallLine[];
  /** Whether slopes cost what Tobler's hiking function says, as the mean of both directions. */
  slope: boolean;
  /** What it costs at the highest place, as a multiple of the lowest; 1: height costs nothing. */
  highest: number;
}

/** Where everything costs 1. */
export const LEVEL: Ground = { faces: new Uint8Array(), lines: [], slope: false, highest: 1 };

/** Least and largest cost. */
export const COSTS = [0.001, 1000] as const;

/** Codes: of a cost of 1, of walls, and of gates. */
export const EVEN = 0;
export const WALL = 255;
export const CLOSED_GATE = 254;
export const OPEN_GATE = 253;

/** Other costs are powers of two in steps of a twelfth, so that 1/2, 2, 4 are exact: this code would be 1 again. */
const MIDDLE = 128;
const STEPS = 12;

/** What a code costs; Infinity for what nobody walks through. */
export function costOf(code: number): number {
  if (code === WALL || code === CLOSED_GATE) return Infinity;
  if (code === EVEN || code === OPEN_GATE) return 1;
  return Math.min(COSTS[1], Math.max(COSTS[0], 2 ** (levelOf(code) / STEPS)));
}

/** The code whose cost is nearest to a cost. */
export function codeOf(cost: number): number {
  return codeAt(STEPS * Math.log2(Math.min(COSTS[1], Math.max(COSTS[0], cost))));
}

/** Between two codes of costs, by their logarithm; `share` 1 is all of `to`. */
export function blend(from: number, to: number, share: number): number {
  return codeAt((1 - share) * levelOf(from) + share * levelOf(to));
}

export function isCost(code: number): boolean {
  return code < OPEN_GATE;
}

export function isWall(code: number): boolean {
  return code === WALL || code === CLOSED_GATE;
}

/** Twelfths of a power of two. */
function levelOf(code: number): number {
  return code === EVEN || !isCost(code) ? 0 : code - MIDDLE;
}

function codeAt(level: number): number {
  const rounded = Math.round(level);
  return rounded === 0 ? EVEN : MIDDLE + rounded;
}

const WEIGHTED = new WeakMap<Ground, boolean>();

/** Whether it costs more here than there, so that no distances are exact. */
export function isWeighted(ground: Ground): boolean {
  let weighted = WEIGHTED.get(ground);
  if (weighted === undefined) {
    const open = openCost(ground);
    const differs = (code: number) => !isWall(code) && costOf(code) !== open;
    weighted = ground.slope || ground.highest !== 1 || ground.faces.some(differs);
    WEIGHTED.set(ground, weighted);
  }
  return weighted;
}

/** Whether what is measured are costs, not lengths: it costs other than 1 somewhere, or everywhere. */
export function hasCosts(ground: Ground): boolean {
  return isWeighted(ground) || openCost(ground) !== 1;
}

/** The cost of the first triangle that is no wall. */
export function openCost({ faces }: Ground): number {
  return costOf(faces.find((code) => !isWall(code)) ?? EVEN);
}

const WALLED = new WeakMap<Ground, boolean>();

/** Whether there is a wall that is no open gate. */
export function hasWalls(ground: Ground): boolean {
  let walled = WALLED.get(ground);
  if (walled === undefined) {
    walled = ground.faces.some(isWall) || ground.lines.some(({ open }) => !open);
    WALLED.set(ground, walled);
  }
  return walled;
}

/** Whether there is anything to draw. */
export function isPainted({ faces, lines }: Ground): boolean {
  return faces.length > 0 || lines.length > 0;
}

/** The same where nothing is left that costs other than 1 is an empty one, so that equal grounds are written alike. */
export function withFaces(ground: Ground, faces: Uint8Array): Ground {
  return { ...ground, faces: faces.some((code) => code !== EVEN) ? faces : LEVEL.faces };
}

/** A mesh that a ground may be of. */
interface Size {
  triangles: number;
  inputVertices: number;
}

export function fits({ faces, lines }: Ground, { triangles, inputVertices }: Size): boolean {
  const isThere = (vertex: number) => vertex < inputVertices;
  return (faces.length === 0 || faces.length === triangles) && lines.every((line) => line.vertices.every(isThere));
}

/** What a worker has to know. */
export function changeOf(before: Ground, after: Ground): GroundChange {
  const triangles: number[] = [];
  const count = Math.max(before.faces.length, after.faces.length);
  for (let i = 0; i < count; i++) {
    if ((before.faces[i] ?? EVEN) !== (after.faces[i] ?? EVEN)) triangles.push(i);
  }
  const closed = after.lines.filter(({ open }) => !open);
  return {
    triangles: Uint32Array.from(triangles),
    costs: Float64Array.from(triangles, (triangle) => costOf(after.faces[triangle] ?? EVEN)),
    lines: Uint32Array.from(closed.flatMap(({ vertices }) => [vertices.length].concat(vertices))),
    slope: after.slope,
    highest: after.highest,
  };
}

/** What a link may hold: as many triangles as any mesh that opens. */
const MOST_TRIANGLES = 2 ** 24;

/** Runs of equal codes and the vertices of walls, packed; empty where nothing is painted. */
export function encodeGround(ground: Ground): string {
  if (!isPainted(ground)) return '';
  const bytes: number[] = [];
  const write = (value: number) => {
    let rest = value;
    for (; rest > 127; rest = Math.floor(rest / 128)) bytes.push((rest % 128) + 128);
    bytes.push(rest);
  };
  const { faces, lines } = ground;
  write(faces.length);
  for (let first = 0; first < faces.length;) {
    let end = first + 1;
    while (end < faces.length && faces[end] === faces[first]) end += 1;
    write(end - first);
    bytes.push(entry(faces, first));
    first = end;
  }
  write(lines.length);
  for (const { vertices, open } of lines) {
    write(2 * vertices.length + (open ? 1 : 0));
    let before = 0;
    for (const vertex of vertices) {
      const step = vertex - before;
      write(step < 0 ? -2 * step - 1 : 2 * step);
      before = vertex;
    }
  }
  return pack(Uint8Array.from(bytes));
}

/** Undefined for text that is none. */
export function decodeGround(text: string): Pick<Ground, 'faces' | 'lines'> | undefined {
  try {
    return text === '' ? { faces: LEVEL.faces, lines: [] } : read(unpack(text));
  } catch {
    return undefined;
  }
}

function read(bytes: Uint8Array): Pick<Ground, 'faces' | 'lines'> {
  let at = 0;
  const byte = () => {
    const next = bytes[at];
    if (next === undefined) throw new RangeError('cut off');
    at += 1;
    return next;
  };
  const number = () => {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const next = byte();
      value += (next % 128) * scale;
      if (next < 128) return value;
      if (scale > MOST_TRIANGLES) throw new RangeError('too large');
    }
  };
  const count = number();
  if (count > MOST_TRIANGLES) throw new RangeError('too large');
  const faces = new Uint8Array(count);
  for (let first = 0; first < count;) {
    const end = first + number();
    const code = byte();
    const level = code - MIDDLE;
    const isKnown = code === EVEN || !isCost(code) || Math.abs(level) <= STEPS * Math.log2(COSTS[1]) + 1;
    if (end <= first || end > count || !isKnown) throw new RangeError('no run');
    faces.fill(code, first, end);
    first = end;
  }
  const lines = Array.from({ length: Math.min(number(), bytes.length) }, (): WallLine => {
    const head = number();
    let vertex = 0;
    const vertices = Array.from({ length: Math.min(Math.floor(head / 2), bytes.length) }, () => {
      const step = number();
      vertex += step % 2 === 1 ? -(step + 1) / 2 : step / 2;
      if (vertex < 0) throw new RangeError('no vertex');
      return vertex;
    });
    return { vertices, open: head % 2 === 1 };
  });
  if (at !== bytes.length) throw new RangeError('too long');
  return { faces, lines };
}
