/** The scene as a readable fragment. Only what differs from where the mesh starts out is written. */
import { findLook, isRamp, type Look } from './looks';
import type { Boundary, SurfacePoint } from './protocol';
import type { MeshReference, SceneState } from './scene';

const VERSION = '1';
const BOUNDARIES: readonly Boundary[] = ['neumann', 'dirichlet', 'average'];

export const TIME_FACTOR_RANGE: readonly [number, number] = [0.1, 1000];

export interface Decoded {
  state: SceneState;
  /** One sentence for each value that could not be used. */
  notices: string[];
}

/** The state a mesh starts out with; null for a preset that does not exist. */
export type StartOf = (mesh: MeshReference) => SceneState | null;

export function encodeLink(state: SceneState, start: SceneState): string {
  const entries: [string, string][] = [['v', VERSION]];
  if (state.mesh.kind === 'preset') {
    entries.push(['m', state.mesh.id]);
  } else {
    entries.push(['m', 'file'], ['name', encodeURIComponent(state.mesh.name)], ['hash', state.mesh.hash]);
  }
  const add = (key: string, value: string, initial: string) => {
    if (value !== initial) entries.push([key, value]);
  };
  add('p', state.parts.join(','), start.parts.join(','));
  add('s', encodePoints(state.sources), encodePoints(start.sources));
  add('w', encodePoints(state.walker ? [state.walker] : []), encodePoints(start.walker ? [start.walker] : []));
  add('t', number(state.parameters.timeFactor), number(start.parameters.timeFactor));
  add('b', state.parameters.boundary, start.parameters.boundary);
  if (state.camera) add('cam', state.camera.map(number).join(','), start.camera?.map(number).join(',') ?? '');
  add('look', state.look.name, start.look.name);
  const look = baseLook(state.look.name, start.look);
  add('ramp', state.look.ramp, look.ramp);
  add('stripe', state.look.stripe.slice(1), look.stripe.slice(1));
  add('width', number(state.look.width), number(look.width));
  add('period', number(state.look.period), number(look.period));
  return entries.map(([key, value]) => `${key}=${value}`).join('&');
}

/** Null when the fragment names no mesh. */
export function decodeLink(fragment: string, startOf: StartOf): Decoded | null {
  const entries = new URLSearchParams(fragment.replace(/^#/, ''));
  const m = entries.get('m');
  if (m === null) return null;
  const notices: string[] = [];
  const mesh: MeshReference =
    m === 'file'
      ? { kind: 'file', name: entries.get('name') ?? '', hash: entries.get('hash') ?? '' }
      : { kind: 'preset', id: m };
  const start = startOf(mesh);
  if (!start) return null;
  if ((entries.get('v') ?? VERSION) !== VERSION) {
    notices.push('This link comes from another version; what is understood of it is shown.');
  }
  const state = { ...start, parameters: { ...start.parameters } };
  const read = <T>(key: string, parse: (text: string) => T | null, apply: (value: T) => void) => {
    const text = entries.get(key);
    if (text === null) return;
    const value = parse(text);
    if (value === null) notices.push(`The link's ${key}=${text.slice(0, 40)} cannot be read; the default stands in.`);
    else apply(value);
  };
  read('p', parseIndices, (parts) => (state.parts = parts));
  read('s', parsePoints, (sources) => (state.sources = sources));
  read('w', parsePoints, ([walker]) => (state.walker = walker ?? null));
  read('t', within(...TIME_FACTOR_RANGE), (factor) => (state.parameters.timeFactor = factor));
  read('b', parseBoundary, (boundary) => (state.parameters.boundary = boundary));
  read('cam', parseCamera, (camera) => (state.camera = camera));
  read(
    'look',
    (name) => findLook(name) ?? null,
    ({ name }) => (state.look = baseLook(name, start.look)),
  );
  const change = (part: Partial<Look>) => (state.look = { ...state.look, ...part });
  read(
    'ramp',
    (name) => (isRamp(name) ? name : null),
    (ramp) => change({ ramp }),
  );
  read(
    'stripe',
    (text) => (/^[\da-f]{6}$/i.test(text) ? `#${text.toLowerCase()}` : null),
    (stripe) => change({ stripe }),
  );
  read('width', within(0, 1), (width) => change({ width }));
  read('period', within(0.001, 1), (period) => change({ period }));
  return { state, notices };
}

/** A preset may refine its own look; any other look is as named. */
function baseLook(name: string, start: Look): Look {
  return name === start.name ? start : (findLook(name) ?? start);
}

function number(value: number): string {
  return String(Number(value.toFixed(4)));
}

function encodePoints(points: readonly SurfacePoint[]): string {
  return points.length === 0 ? 'none' : points.map(encodePoint).join(',');
}

function encodePoint(point: SurfacePoint): string {
  return 'vertex' in point ? String(point.vertex) : `${point.face}:${point.weights.map(number).join('/')}`;
}

function parsePoints(text: string): SurfacePoint[] | null {
  if (text === 'none') return [];
  const points = text.split(',').map(parsePoint);
  return points.every((point) => point !== null) ? points : null;
}

function parsePoint(text: string): SurfacePoint | null {
  if (/^\d{1,9}$/.test(text)) return { vertex: Number(text) };
  const match = /^(\d{1,9}):([\d.]+)\/([\d.]+)\/([\d.]+)$/.exec(text);
  if (!match) return null;
  const [face, a, b, c] = match.slice(1).map(Number);
  const sum = a + b + c;
  // The digits of a link are rounded, so the weights may miss 1 by a little.
  return Math.abs(sum - 1) < 0.01 ? { face, weights: [a / sum, b / sum, c / sum] } : null;
}

function parseIndices(text: string): number[] | null {
  if (text === '') return [];
  return /^\d{1,6}(,\d{1,6})*$/.test(text) ? text.split(',').map(Number) : null;
}

function parseBoundary(text: string): Boundary | null {
  return BOUNDARIES.find((boundary) => boundary === text) ?? null;
}

function parseCamera(text: string): number[] | null {
  const values = text.split(',').map(Number);
  return values.length === 6 && values.every(Number.isFinite) && values[2] > 0 ? values : null;
}

function within(low: number, high: number): (text: string) => number | null {
  return (text) => {
    const value = Number(text);
    return text.trim() !== '' && value >= low && value <= high ? value : null;
  };
}
