/** The scene as a readable fragment. Only what differs from where the mesh starts out is written. */
import { PATH_KIND, UP, VERTEX_FIELD } from '../wasm/contract';
import { addressIn, percentDecoded } from '../files/address';
import { decodeCompared, encodeCompared } from './compared';
import { DECALS } from './decals';
import { COSTS, decodeGround, encodeGround, LEVEL } from './ground';
import { GIRTH } from './girth';
import { CUTS, FILLS, INSIDE_NUMBERS, INSIDE_RANGES } from './inside';
import { decodeIsolines, encodeIsolines } from './isolines';
import { type Key, keysOf, read } from './keys';
import { SHOWN_UNITS, UNITS } from '../length';
import { POINT, SOURCES } from './points';
import {
  HEADINGS,
  LARGEST_CROWD,
  LIGHTS,
  type MeshReference,
  OVERLAYS,
  type SceneState,
  SPEEDS,
  TRIANGLES,
} from './scene';
import { decodeSets, encodeSets } from './sets';
import { SETTINGS } from './settings';
import { UNCHOSEN } from './sources';
import {
  BLENDS,
  type Finish,
  findStyle,
  isRamp,
  type MapName,
  MAPS,
  PATTERNS,
  RAMP_NAMES,
  STYLE_NUMBERS,
  STYLE_RANGES,
  SURFACE_SOURCES,
  SURROUNDINGS,
} from './styles';
import { SCALES, TAPES } from './tapes';
import {
  AMOUNT,
  precise,
  automaticOr,
  choiceOf,
  type Codec,
  COUNT,
  FLAG,
  listOf,
  number,
  oneOf,
  or,
  rounded,
  within,
} from './text';
import { isWorkspace } from './workspace';
import { counted, enumerated, Phrase, t, type Words } from '../texts';

const VERSION = '1';
/** An hour: longer than any animation of a model. */
const LONGEST_CLIP_SECONDS = 3600;
/** Parts of a file that a link can name: more than any has. */
const MOST_PARTS = 1_000_000;
/** Letters of a value that a message names. */
const MOST_NAMED = 40;

export interface Decoded {
  /** Null where the fragment names no mesh, or none that there can be. */
  state: SceneState | null;
  /** What is to be told of it, beside what is refused. */
  notices: Words[];
  /** What could not be used, as `key=value`. */
  refused: string[];
  /** Keys that mean nothing, or nothing any more. */
  unknown: string[];
}

/** The state a mesh starts out with; null for a preset that does not exist. */
export type StartOf = (mesh: MeshReference) => SceneState | null;

const { whole, part } = keysOf<SceneState>();

const INDICES = listOf(COUNT, MOST_PARTS, '');

const CAMERA: Codec<readonly number[] | null> = {
  encode: (camera) => camera?.map(number).join(',') ?? '',
  parse: (text) => {
    const values = text.split(',').map(Number);
    const [, , distance = 0] = values;
    return values.length === 6 && values.every(Number.isFinite) && distance > 0 ? values : undefined;
  },
};

const STRIPE: Codec<string> = {
  encode: (stripe) => stripe.replace('#', ''),
  parse: (text) => (isRamp(text) ? text : /^[\da-f]{6}$/i.test(text) ? `#${text.toLowerCase()}` : undefined),
};

const FINISH: Codec<Finish> = {
  encode: ({ metalness, roughness, glow }) => [metalness, roughness, glow].map(number).join('/'),
  parse: (text) => {
    const [metalness = NaN, roughness = NaN, glow = NaN, ...more] = text.split('/').map(Number);
    const [least, most] = [Math.min(metalness, roughness, glow), Math.max(metalness, roughness, glow / 3)];
    return more.length === 0 && least >= 0 && most <= 1 ? { metalness, roughness, glow } : undefined;
  },
};

/** A letter each: colour, normal, emission, specular; `none` where there are none. */
const MAP_LETTERS: Codec<readonly MapName[]> = {
  encode: (maps) =>
    MAPS.filter((map) => maps.includes(map))
      .map((map) => map[0])
      .join('') || 'none',
  parse: (text) =>
    text === 'none' ? [] : /^[cnes]+$/.test(text) ? MAPS.filter((map) => text.includes(map.charAt(0))) : undefined,
};

/** Keys of which mesh it is, and how the page looks. */
export const ADDRESS_KEYS: readonly string[] = ['v', 'm', 'model', 'name', 'hash', 'kiosk', 'open'];

/** Keys of what a mesh is opened with. */
const OPENING = [
  whole('p', 'parts', INDICES),
  whole('triangles', 'triangles', or('all', null, rounded(TRIANGLES))),
  whole('fill', 'fill', or('none', null, rounded(FILLS))),
] as const;

/** Keys of how it is looked at, and how it moves. */
const LOOK = [
  whole('hide', 'hidden', INDICES),
  whole('cam', 'camera', CAMERA),
  whole('ortho', 'orthographic', FLAG),
  part('clip', 'animation', 'clip', or('none', null, COUNT)),
  part('time', 'animation', 'seconds', within([0, LONGEST_CLIP_SECONDS])),
  part('play', 'animation', 'plays', FLAG),
  part('speed', 'animation', 'speed', within(SPEEDS)),
  part('loop', 'animation', 'loops', FLAG),
  part('live', 'animation', 'live', FLAG),
] as const;

/** Keys of what undo goes back over. */
const EDITS = [
  whole('s', 'sources', or('', UNCHOSEN, SOURCES)),
  whole('sets', 'sets', { encode: encodeSets, parse: decodeSets }),
  whole('w', 'walker', or('', undefined, or('none', null, POINT))),
  whole('up', 'up', automaticOr(choiceOf(UP))),
  whole('unit', 'unit', automaticOr(oneOf(UNITS))),
  whole('scale', 'scale', within(SCALES, precise)),
  whole('shown', 'shownUnit', or('same', null, oneOf(SHOWN_UNITS))),
  whole('tape', 'tapes', TAPES),
  whole('girth', 'girth', GIRTH),
  whole('decal', 'decals', DECALS),
  whole('ground', 'ground', {
    encode: encodeGround,
    parse: (text, ground) => {
      const painted = decodeGround(text);
      return painted && { ...ground, ...painted };
    },
  }),
  part('slope', 'ground', 'slope', FLAG),
  part('height', 'ground', 'highest', within(COSTS)),
  part('cut', 'inside', 'cut', oneOf(CUTS)),
  ...INSIDE_NUMBERS.map((name) => part(name, 'inside', name, within(INSIDE_RANGES[name]))),
  part('whole', 'inside', 'whole', FLAG),
  part('arrows', 'inside', 'arrows', FLAG),
  ...SETTINGS,
  whole('bridge', 'bridge', or('auto', 'auto', or('off', 'off', AMOUNT))),
  whole('links', 'links', COUNT),
  whole('way', 'pathKind', choiceOf(PATH_KIND)),
  whole('vs', 'compared', {
    encode: encodeCompared,
    parse: (text, _, scene) => decodeCompared(text, scene),
  }),
  whole('lights', 'lights', oneOf(LIGHTS)),
  whole('look', 'style', {
    encode: ({ name }) => name,
    // A preset may change its own style; any other style is as named.
    parse: (name, style) => (name === style.name ? style : findStyle(name)),
  }),
  whole('paint', 'colorBy', choiceOf(VERTEX_FIELD)),
  whole('show', 'overlays', listOf(oneOf(OVERLAYS), OVERLAYS.length)),
  whole('iso', 'isolines', { encode: encodeIsolines, parse: decodeIsolines }),
  whole('heading', 'heading', within(HEADINGS)),
  whole('crowd', 'crowd', rounded([0, LARGEST_CROWD])),
  part('ramp', 'style', 'ramp', oneOf(RAMP_NAMES)),
  part('stripe', 'style', 'stripe', STRIPE),
  part('of', 'style', 'surfaceOf', oneOf(SURFACE_SOURCES)),
  part('blend', 'style', 'blend', oneOf(BLENDS)),
  part('style', 'style', 'pattern', oneOf(PATTERNS)),
  ...STYLE_NUMBERS.map((name) => part(name, 'style', name, within(STYLE_RANGES[name]))),
  part('surface', 'style', 'surface', FINISH),
  part('stripes', 'style', 'stripes', FINISH),
  part('maps', 'style', 'maps', MAP_LETTERS),
  part('around', 'style', 'surroundings', oneOf(SURROUNDINGS)),
] as const;

/** All keys of the scene, in the order in which they are written and read: later ones change what earlier ones say. */
export const KEYS: readonly Key<SceneState>[] = [...OPENING, ...EDITS, ...LOOK];

/** What undo goes back over: all but the mesh, how it is looked at, and how it moves. */
export type Undoable = Pick<SceneState, (typeof EDITS)[number]['field']>;

const UNDOABLE: ReadonlySet<keyof SceneState> = new Set(EDITS.map(({ field }) => field));
const OPENED_WITH: ReadonlySet<keyof SceneState> = new Set(['mesh', ...OPENING.map(({ field }) => field)] as const);

export function isUndoable(field: keyof SceneState): field is keyof Undoable {
  return UNDOABLE.has(field);
}

/** Whether only another opening of the mesh changes it. */
export function isOpenedWith(field: keyof SceneState): boolean {
  return OPENED_WITH.has(field);
}

/** Whether two states are of the same mesh, opened in the same way. */
export function isOpenedAlike(a: SceneState, b: SceneState): boolean {
  return [...OPENED_WITH].every((field) => JSON.stringify(a[field]) === JSON.stringify(b[field]));
}

/** What undo goes back over, of a state. */
export function undoableOf(state: SceneState): Undoable {
  return Object.fromEntries(
    Object.entries(state).filter(([field]) => isUndoable(field as keyof SceneState)),
  ) as Undoable;
}

export function encodeLink(state: SceneState, start: SceneState): string {
  const entries: [string, string][] = [['v', VERSION], ...encodeMesh(state.mesh)];
  through(start, (key, reached) => {
    const text = key.encode(state);
    const next = text === key.encode(reached) ? undefined : read(key, text, reached);
    // What has no text is left as the mesh starts out, as a camera that was never moved.
    if (next) entries.push([key.key, text]);
    return next;
  });
  return entries.map(([key, value]) => `${key}=${value}`).join('&');
}

/** What a reader of a link has come to after all keys: a style, or another mesh of the same file, brings what it has along. */
function through(
  start: SceneState,
  step: (key: Key<SceneState>, reached: SceneState) => SceneState | undefined,
): SceneState {
  let reached = start;
  for (const key of OPENING) reached = step(key, reached) ?? reached;
  // Places of a preset count its vertices and triangles.
  if (reached.triangles !== start.triangles || reached.fill !== start.fill) reached = withoutOwn(reached, start);
  for (const key of [...EDITS, ...LOOK]) reached = step(key, reached) ?? reached;
  return reached;
}

export function decodeLink(fragment: string, startOf: StartOf): Decoded {
  const refused: string[] = [];
  const refuse = (entry: string) => refused.push(shortened(entry));
  const texts = fragment.replace(/^#/, '').split('&');
  texts.filter(isMalformed).forEach(refuse);
  // A plus sign is one: spaces are written as %20.
  const readable = texts.filter((text) => !isMalformed(text)).join('&');
  const entries = new URLSearchParams(readable.replaceAll('+', '%2B'));
  const [open, kiosk] = [entries.get('open'), entries.get('kiosk')];
  if (open !== null && !isWorkspace(open)) refuse(`open=${open}`);
  if (kiosk !== null && FLAG.parse(kiosk) === undefined) refuse(`kiosk=${kiosk}`);
  const notices: Words[] = [];
  const mesh = parseMesh(entries);
  const start = mesh === null || mesh instanceof Phrase ? null : startOf(mesh);
  if (mesh instanceof Phrase) notices.push(mesh);
  else if (mesh && !start)
    notices.push(
      t`There is no preset “${mesh.kind === 'preset' ? mesh.id.slice(0, MOST_NAMED) : ''}”; the first preset is shown.`,
    );
  if (!start) {
    const left = KEYS.flatMap(({ key }) => (entries.has(key) ? [shortened(`${key}=${entries.get(key)}`)] : []));
    if (left.length > 0) notices.push(withoutMesh(left));
    return { state: null, notices, refused, unknown: [] };
  }
  if ((entries.get('v') ?? VERSION) !== VERSION) {
    notices.push(t('This link was made by another version of the page; some of it may be ignored.'));
  }
  const state = through(start, (key, reached) => {
    const text = entries.get(key.key);
    if (text === null) return undefined;
    const next = read(key, text, reached);
    if (!next) refuse(`${key.key}=${text}`);
    return next;
  });
  const known = new Set([...ADDRESS_KEYS, ...KEYS.map(({ key }) => key)]);
  return { state, notices, refused, unknown: [...entries.keys()].filter((key) => !known.has(key)) };
}

/** A state without the places and the ground that the mesh starts out with, and nobody asked for. */
export function withoutOwn(state: SceneState, start: SceneState | null): SceneState {
  return {
    ...state,
    sources: state.sources === start?.sources ? UNCHOSEN : state.sources,
    sets: state.sets === start?.sets ? [] : state.sets,
    decals: state.decals === start?.decals ? [] : state.decals,
    walker: state.walker === start?.walker ? undefined : state.walker,
    ground: state.ground === start?.ground ? LEVEL : state.ground,
  };
}

/**
 * What of a link the mesh that was opened does not have, as `key=value`: places, parts, a unit to be converted to, a cut or a girth.
 */
export function refusedBy(wanted: SceneState, opened: SceneState): string[] {
  const isLost: Readonly<Record<string, boolean>> = {
    p: opened.parts.length < wanted.parts.length,
    hide: opened.hidden.length < wanted.hidden.length,
    w: Boolean(wanted.walker) && opened.walker !== wanted.walker,
    tape: opened.tapes.length < wanted.tapes.length,
    decal: opened.decals.length < wanted.decals.length,
    shown: opened.shownUnit !== wanted.shownUnit,
    cut: opened.inside.cut !== wanted.inside.cut,
    girth: wanted.girth !== null && opened.girth === null,
  };
  return KEYS.filter(({ key }) => isLost[key]).map((key) => shortened(`${key.key}=${key.encode(wanted)}`));
}

/** What cannot be used of a link, in a sentence. */
export function refusedWords(refused: readonly string[]): Words {
  return counted(
    refused.length,
    "The link's {1} is invalid; the default is used.",
    "The link's {1} are invalid; the defaults are used.",
    enumerated(refused),
  );
}

/** What of a link is left out where its mesh is not named, or does not exist, in a sentence. */
function withoutMesh(left: readonly string[]): Words {
  return counted(
    left.length,
    "The link's {1} is left out: it is for a mesh that the link does not name, or that does not exist.",
    "The link's {1} are left out: they are for a mesh that the link does not name, or that does not exist.",
    enumerated(left),
  );
}

function shortened(entry: string): string {
  return entry.slice(0, entry.indexOf('=') + 1 + MOST_NAMED);
}

/** Whether an entry has percent signs that stand for no text. In a name or an address by hand they may stand for themselves. */
function isMalformed(text: string): boolean {
  if (!text.includes('%') || percentDecoded(text) !== text) return false;
  return !/^(name|model)=/.test(text) || /%[89a-f]/i.test(text);
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
function parseMesh(entries: URLSearchParams): MeshReference | Phrase | null {
  const [m, model] = [entries.get('m'), entries.get('model')];
  const [name, hash] = [entries.get('name') ?? '', entries.get('hash') ?? ''];
  if (model !== null) {
    // Who writes a link by hand leaves the address as it is.
    const address = addressIn(model.replaceAll(' ', '%20'));
    if (address) return { kind: 'address', address, path: name, hash };
    return t`The link's model=${model.slice(0, MOST_NAMED)} is no http or https address; the first preset is shown.`;
  }
  if (m === null) return null;
  return m === 'file' ? { kind: 'file', name, hash } : { kind: 'preset', id: m };
}
