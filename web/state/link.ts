/** The scene as a readable fragment. Only what differs from where the mesh starts out is written. */
import type { Source, MeshPoint } from '../protocol';
import { PATH_KIND, UP, VERTEX_FIELD } from '../wasm/contract';
import { addressIn } from '../files/address';
import { COSTS, decodeGround, encodeGround, type Ground } from './ground';
import { CUTS, FILLS, type Inside, INSIDE_NUMBERS, INSIDE_RANGES } from './inside';
import type { Finish, Style, MapName } from './styles';
import {
  findStyle,
  isRamp,
  STYLE_NUMBERS,
  STYLE_RANGES,
  BLENDS,
  MAPS,
  PATTERNS,
  SURFACE_SOURCES,
  SURROUNDINGS,
} from './styles';
import {
  type Animation,
  type Bridge,
  LARGEST_CROWD,
  LIGHTS,
  type MeshReference,
  OVERLAYS,
  type SceneState,
  SPEEDS,
  TRIANGLES,
  UNITS,
} from './scene';
import { decodeCompared, encodeCompared } from './compared';
import { decodeIsolines, encodeIsolines } from './isolines';
import { decodeSets, encodeSets } from './sets';
import { encodeSettings, parserOf, SETTINGS } from './settings';
import { MOST_POINTS, withOffset } from './sources';
import { decodeTapes, encodeTapes, SCALES } from './tapes';
import { amount, automaticOr, choiceOf, flag, number, oneOf, parseAmount, within } from './text';
import { t } from '../texts';

const VERSION = '1';
/** An hour: longer than any animation of a model. */
const LONGEST_CLIP_SECONDS = 3600;

export interface Decoded {
  /** Null where the fragment names no mesh, or none that there can be. */
  state: SceneState | null;
  /** One sentence for each value that could not be used. */
  notices: string[];
  /** Keys that mean nothing, or nothing any more. */
  unknown: string[];
}

/** Keys of which mesh it is, and how the page looks. */
const OF_ADDRESS = ['v', 'm', 'model', 'name', 'hash', 'kiosk'];

/** The state a mesh starts out with; null for a preset that does not exist. */
export type StartOf = (mesh: MeshReference) => SceneState | null;

export function encodeLink(state: SceneState, start: SceneState): string {
  const entries: [string, string][] = [['v', VERSION], ...encodeMesh(state.mesh)];
  const add = (key: string, value: string, initial: string) => {
    if (value !== initial) entries.push([key, value]);
  };
  add('p', state.parts.join(','), start.parts.join(','));
  add('triangles', triangles(state.triangles), triangles(start.triangles));
  add('fill', fill(state.fill), fill(start.fill));
  add('hide', state.hidden.join(','), start.hidden.join(','));
  add('s', encodePoints(state.sources), encodePoints(start.sources));
  add('sets', encodeSets(state.sets), encodeSets(start.sets));
  add('w', encodePoints(state.walker ? [state.walker] : []), encodePoints(start.walker ? [start.walker] : []));
  add('up', state.up, start.up);
  add('unit', state.unit, start.unit);
  add('scale', amount(state.scale), amount(start.scale));
  add('tape', encodeTapes(state.tapes, encodePoints), encodeTapes(start.tapes, encodePoints));
  add('ground', encodeGround(state.ground), encodeGround(start.ground));
  add('slope', flag(state.ground.slope), flag(start.ground.slope));
  add('height', number(state.ground.highest), number(start.ground.highest));
  const { inside } = state;
  add('cut', inside.cut, start.inside.cut);
  for (const key of INSIDE_NUMBERS) add(key, number(inside[key]), number(start.inside[key]));
  add('whole', flag(inside.whole), flag(start.inside.whole));
  add('arrows', flag(inside.arrows), flag(start.inside.arrows));
  const [settings, initial] = [encodeSettings(state), encodeSettings(start)];
  for (const key of SETTINGS) add(key, settings[key], initial[key]);
  add('bridge', bridge(state.bridge), bridge(start.bridge));
  add('links', number(state.links), number(start.links));
  add('way', state.pathKind, start.pathKind);
  add('vs', encodeCompared(state.compared, state), encodeCompared(start.compared, start));
  if (state.camera) add('cam', state.camera.map(number).join(','), start.camera?.map(number).join(',') ?? '');
  add('lights', state.lights, start.lights);
  const { animation } = state;
  add('clip', clipNumber(animation.clip), clipNumber(start.animation.clip));
  add('time', number(animation.seconds), number(start.animation.seconds));
  add('play', flag(animation.plays), flag(start.animation.plays));
  add('speed', number(animation.speed), number(start.animation.speed));
  add('loop', flag(animation.loops), flag(start.animation.loops));
  add('live', flag(animation.live), flag(start.animation.live));
  add('look', state.style.name, start.style.name);
  const style = baseStyle(state.style.name, start.style);
  add('paint', state.colorBy, start.colorBy);
  add('show', state.overlays.join(',') || 'none', start.overlays.join(',') || 'none');
  add('iso', encodeIsolines(state.isolines), encodeIsolines(start.isolines));
  add('crowd', number(state.crowd), number(start.crowd));
  add('ramp', state.style.ramp, style.ramp);
  add('stripe', state.style.stripe.replace('#', ''), style.stripe.replace('#', ''));
  add('of', state.style.surfaceOf, style.surfaceOf);
  add('blend', state.style.blend, style.blend);
  add('style', state.style.pattern, style.pattern);
  for (const key of STYLE_NUMBERS) add(key, number(state.style[key]), number(style[key]));
  add('surface', encodeFinish(state.style.surface), encodeFinish(style.surface));
  add('stripes', encodeFinish(state.style.stripes), encodeFinish(style.stripes));
  add('maps', encodeMaps(state.style.maps), encodeMaps(style.maps));
  add('around', state.style.surroundings, style.surroundings);
  return entries.map(([key, value]) => `${key}=${value}`).join('&');
}

export function decodeLink(fragment: string, startOf: StartOf): Decoded {
  // A plus sign is one: spaces are written as %20.
  const entries = new URLSearchParams(fragment.replace(/^#/, '').replaceAll('+', '%2B'));
  const notices: string[] = [];
  const mesh = parseMesh(entries);
  if (typeof mesh === 'string') notices.push(mesh);
  if (mesh === null || typeof mesh === 'string') return { state: null, notices, unknown: [] };
  const start = startOf(mesh);
  if (!start) {
    notices.push(t('The preset of this link does not exist; the first preset is shown.'));
    return { state: null, notices, unknown: [] };
  }
  if ((entries.get('v') ?? VERSION) !== VERSION) {
    notices.push(t('This link was made by another version of the page; some of it may be ignored.'));
  }
  const state = { ...start };
  const known = new Set(OF_ADDRESS);
  const read = <T>(key: string, parse: (text: string) => T | null, apply: (value: T) => void) => {
    known.add(key);
    const text = entries.get(key);
    if (text === null) return;
    const value = parse(text);
    if (value === null) notices.push(t`The link's ${key}=${text.slice(0, 40)} is invalid; the default is used.`);
    else apply(value);
  };
  read('p', parseIndices, (parts) => (state.parts = parts));
  read('triangles', parseTriangles, ([most]) => (state.triangles = most ?? null));
  read('fill', parseFill, ([count]) => (state.fill = count ?? null));
  read('hide', parseIndices, (hidden) => (state.hidden = hidden));
  read('s', listOf(parseSource), (sources) => (state.sources = sources));
  read('sets', decodeSets, (sets) => (state.sets = sets));
  read('w', listOf(parsePoint), ([walker]) => (state.walker = walker ?? null));
  read('up', automaticOr(choiceOf(UP)), (up) => (state.up = up));
  read('unit', automaticOr(oneOf(UNITS)), (unit) => (state.unit = unit));
  read('scale', within(...SCALES), (scale) => (state.scale = scale));
  const tapesOf = (text: string) => decodeTapes(text, listOf(parsePoint));
  read('tape', tapesOf, (tapes) => (state.tapes = tapes));
  const lay = (part: Partial<Ground>) => (state.ground = { ...state.ground, ...part });
  read('ground', decodeGround, lay);
  read('slope', oneOf(['0', '1']), (slope) => lay({ slope: slope === '1' }));
  read('height', within(...COSTS), (highest) => lay({ highest }));
  const look = (part: Partial<Inside>) => (state.inside = { ...state.inside, ...part });
  read('cut', oneOf(CUTS), (cut) => look({ cut }));
  for (const key of INSIDE_NUMBERS) {
    const [low, high] = INSIDE_RANGES[key];
    read(key, within(low, high), (value) => look({ [key]: value }));
  }
  read('whole', oneOf(['0', '1']), (whole) => look({ whole: whole === '1' }));
  read('arrows', oneOf(['0', '1']), (arrows) => look({ arrows: arrows === '1' }));
  for (const key of SETTINGS) read(key, parserOf(key), (apply) => Object.assign(state, apply(state)));
  read('bridge', parseBridge, (rule) => (state.bridge = rule));
  read('links', parseLinks, (links) => (state.links = links));
  read('way', choiceOf(PATH_KIND), (pathKind) => (state.pathKind = pathKind));
  const comparedOf = (text: string) => decodeCompared(text, state);
  read('vs', comparedOf, ([compared]) => (state.compared = compared ?? null));
  read('cam', parseCamera, (camera) => (state.camera = camera));
  read('lights', oneOf(LIGHTS), (lights) => (state.lights = lights));
  const animate = (part: Partial<Animation>) => (state.animation = { ...state.animation, ...part });
  read('clip', parseClip, ([clip]) => animate({ clip: clip ?? null }));
  read('time', within(0, LONGEST_CLIP_SECONDS), (seconds) => animate({ seconds }));
  read('play', oneOf(['0', '1']), (plays) => animate({ plays: plays === '1' }));
  read('speed', within(...SPEEDS), (speed) => animate({ speed }));
  read('loop', oneOf(['0', '1']), (loops) => animate({ loops: loops === '1' }));
  read('live', oneOf(['0', '1']), (live) => animate({ live: live === '1' }));
  read(
    'look',
    (name) => findStyle(name) ?? null,
    ({ name }) => (state.style = baseStyle(name, start.style)),
  );
  read('paint', choiceOf(VERTEX_FIELD), (colorBy) => (state.colorBy = colorBy));
  read('show', listOf(oneOf(OVERLAYS)), (overlays) => (state.overlays = overlays));
  read('iso', decodeIsolines, ([wish]) => (state.isolines = wish ?? null));
  read('crowd', within(0, LARGEST_CROWD), (crowd) => (state.crowd = Math.round(crowd)));
  const change = (part: Partial<Style>) => (state.style = { ...state.style, ...part });
  read(
    'ramp',
    (name) => (isRamp(name) ? name : null),
    (ramp) => change({ ramp }),
  );
  read(
    'stripe',
    (text) => (isRamp(text) ? text : /^[\da-f]{6}$/i.test(text) ? `#${text.toLowerCase()}` : null),
    (stripe) => change({ stripe }),
  );
  read('of', oneOf(SURFACE_SOURCES), (surfaceOf) => change({ surfaceOf }));
  read('blend', oneOf(BLENDS), (blend) => change({ blend }));
  read('style', oneOf(PATTERNS), (pattern) => change({ pattern }));
  for (const key of STYLE_NUMBERS) {
    const [low, high] = STYLE_RANGES[key];
    read(key, within(low, high), (value) => change({ [key]: value }));
  }
  read('surface', parseFinish, (surface) => change({ surface }));
  read('stripes', parseFinish, (stripes) => change({ stripes }));
  read('maps', parseMaps, (maps) => change({ maps }));
  read('around', oneOf(SURROUNDINGS), (surroundings) => change({ surroundings }));
  return { state, notices, unknown: [...entries.keys()].filter((key) => !known.has(key)) };
}

function encodeMesh(mesh: MeshReference): [string, string][] {
  switch (mesh.kind) {
    case 'preset':
      return [['m', mesh.id]];
    case 'file':
      return [
        ['m', 'file'],
        ['name', encodeURIComponent(mesh.name)],
        ['hash', mesh.hash],
      ];
    case 'address': {
      const model = encodeURIComponent(mesh.address).replaceAll('%3A', ':').replaceAll('%2F', '/');
      const path = mesh.path ? [['name', encodeURIComponent(mesh.path)] as [string, string]] : [];
      return [['model', model], ...path, ['hash', mesh.hash]];
    }
  }
}

/** Null where none is named; a sentence where an address is none of a file on a server. */
function parseMesh(entries: URLSearchParams): MeshReference | string | null {
  const [m, model] = [entries.get('m'), entries.get('model')];
  const [name, hash] = [entries.get('name') ?? '', entries.get('hash') ?? ''];
  if (model !== null) {
    // Who writes a link by hand leaves the address as it is.
    const address = addressIn(model.replaceAll(' ', '%20'));
    if (address) return { kind: 'address', address, path: name, hash };
    return t`The link's model=${model.slice(0, 40)} is no http or https address; the first preset is shown.`;
  }
  if (m === null) return null;
  return m === 'file' ? { kind: 'file', name, hash } : { kind: 'preset', id: m };
}

/** A preset may change its own style; any other style is as named. */
function baseStyle(name: string, start: Style): Style {
  return name === start.name ? start : (findStyle(name) ?? start);
}

function bridge(rule: Bridge): string {
  return typeof rule === 'number' ? amount(rule) : rule;
}

function parseBridge(text: string): Bridge | null {
  if (text === 'auto' || text === 'off') return text;
  return parseAmount(text);
}

function triangles(most: number | null): string {
  return most === null ? 'all' : String(most);
}

function fill(count: number | null): string {
  return count === null ? 'none' : String(count);
}

function clipNumber(index: number | null): string {
  return index === null ? 'none' : String(index);
}

function parseLinks(text: string): number | null {
  return /^\d{1,9}$/.test(text) ? Number(text) : null;
}

function encodePoints(points: readonly Source[]): string {
  return points.length === 0 ? 'none' : points.map(encodePoint).join(',');
}

function encodePoint(point: Source): string {
  const place = 'vertex' in point ? String(point.vertex) : `${numberOf(point)}:${point.weights.map(number).join('/')}`;
  return point.offset ? `${place}@${amount(point.offset)}` : place;
}

/** A face has three weights, a tetrahedron four. */
function numberOf(point: Exclude<MeshPoint, { vertex: number }>): number {
  return 'face' in point ? point.face : point.tetrahedron;
}

function encodeFinish({ metalness, roughness, glow }: Finish): string {
  return [metalness, roughness, glow].map(number).join('/');
}

/** A letter each: colour, normal, emission, specular. */
function encodeMaps(maps: readonly MapName[]): string {
  return (
    MAPS.filter((map) => maps.includes(map))
      .map((map) => map[0])
      .join('') || 'none'
  );
}

function parseFinish(text: string): Finish | null {
  const [metalness, roughness, glow, ...more] = text.split('/').map(Number);
  const [least, most] = [Math.min(metalness, roughness, glow), Math.max(metalness, roughness, glow / 3)];
  return more.length === 0 && least >= 0 && most <= 1 ? { metalness, roughness, glow } : null;
}

function parseMaps(text: string): MapName[] | null {
  if (text === 'none') return [];
  return /^[cnes]+$/.test(text) ? MAPS.filter((map) => text.includes(map.charAt(0))) : null;
}

function listOf<T>(parse: (text: string) => T | null): (text: string) => T[] | null {
  return (text) => {
    if (text === 'none') return [];
    const items = text.split(',', MOST_POINTS + 1).map(parse);
    return items.length <= MOST_POINTS && items.every((item) => item !== null) ? items : null;
  };
}

/** A place, and after `@` the initial distance there. */
function parseSource(text: string): Source | null {
  const [place, start, ...more] = text.split('@');
  const point = parsePoint(place);
  if (!point || more.length > 0) return null;
  if (start === undefined) return point;
  const offset = parseAmount(start);
  return offset === null ? null : withOffset(point, offset);
}

function parsePoint(text: string): MeshPoint | null {
  if (/^\d{1,9}$/.test(text)) return { vertex: Number(text) };
  const match = /^(\d{1,9}):([\d.]+(?:\/[\d.]+){2,3})$/.exec(text);
  if (!match) return null;
  const index = Number(match[1]);
  const weights = match[2].split('/').map(Number);
  const sum = weights.reduce((all, weight) => all + weight, 0);
  // The digits of a link are rounded, so the weights may miss 1 by a little.
  if (!(Math.abs(sum - 1) < 0.01)) return null;
  const [a, b, c, d] = weights.map((weight) => weight / sum);
  return d === undefined ? { face: index, weights: [a, b, c] } : { tetrahedron: index, weights: [a, b, c, d] };
}

/** A number, or none for all. */
function parseTriangles(text: string): number[] | null {
  if (text === 'all') return [];
  const most = within(...TRIANGLES)(text);
  return most === null ? null : [Math.round(most)];
}

/** A number of tetrahedra, or none. */
function parseFill(text: string): number[] | null {
  if (text === 'none') return [];
  const count = within(...FILLS)(text);
  return count === null ? null : [Math.round(count)];
}

/** The number of one, or of none. */
function parseClip(text: string): number[] | null {
  return text === 'none' ? [] : /^\d{1,6}$/.test(text) ? [Number(text)] : null;
}

function parseIndices(text: string): number[] | null {
  if (text === '') return [];
  return /^\d{1,6}(,\d{1,6})*$/.test(text) ? text.split(',').map(Number) : null;
}

function parseCamera(text: string): number[] | null {
  const values = text.split(',').map(Number);
  return values.length === 6 && values.every(Number.isFinite) && values[2] > 0 ? values : null;
}
