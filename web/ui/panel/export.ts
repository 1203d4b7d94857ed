import { Failure, sentenceOf } from '../../error';
import type { CurveFile, DistanceFile, InnerDistanceFile, Isolines, SavedCurves } from '../../protocol';
import { pathFile, towardEye, trackPoints, tracksFile } from '../../session/export';
import { isolineWish } from '../../session/isolines';
import type { Engine } from '../../solver/engine';
import type { Session } from '../../session/session';
import { commandLines, type Measured, pythonLines } from '../../state/reproduce';
import type { MeshReference, Overlay } from '../../state/scene';
import { isolinesText, parseIsolines, withinReach } from '../../state/isolines';
import { rustLines } from '../../state/rust';
import { vectorsIn } from '../../state/vector';
import { inModel, isKnown, isSameUnit, type LengthUnit, MODEL, told, toldArea, unitOf, unitOfFile } from '../../length';
import { save } from '../../view/picture';
import { copy } from '../clipboard';
import { h, say, select } from '../dom';
import { reason } from '../widgets';
import { measure as lengthWords, threeDigits, unitWords, withUnit } from '../../state/measures';
import { fileNameOf } from '../words';
import { counted, enumerated, listed, plainNumbers, sentences, t, type Words } from '../../texts';

type Curve = readonly [CurveFile['kind'], Words];
/** First what comes at true scale into other programs. */
const CURVES: readonly [Curve, ...Curve[]] = [
  ['dxf', t('Curves, DXF')],
  ['obj', t('Curves, OBJ')],
  ['svg', t('Curves as seen, SVG')],
  ['pdf', t('Curves as seen, PDF')],
  ['csv', t('Curves, CSV')],
  ['glb', t('Curves, GLB')],
  ['strips.obj', t('Strips, OBJ')],
  ['unrolled.svg', t('Strips unrolled, SVG')],
  ['unrolled.dxf', t('Strips unrolled, DXF')],
  ['unrolled.pdf', t('Strips unrolled, PDF')],
];
/** The surface as it is painted, which the page writes by itself. */
const STRIPES = 'stripes.glb';
const OF_SURFACES = t('This is for surfaces, not for the inside of tetrahedra.');
/** Strips that are named one by one. */
const MOST_NAMED = 5;
const LOG_MAP = 'log-map.csv';
const DISTANCES: readonly (readonly [DistanceFile | typeof STRIPES | typeof LOG_MAP, Words])[] = [
  ['csv', 'CSV'],
  [LOG_MAP, t('Log map of the first source, CSV')],
  ['npy', 'NumPy'],
  ['ply', t('PLY, double')],
  ['glb', t('GLB with materials')],
  ['weights.ply', t('PLY, vertex colors')],
  [STRIPES, t('GLB with the stripes')],
];
const INNER_DISTANCES: readonly (readonly [InnerDistanceFile | typeof STRIPES, Words])[] = [
  ['csv', 'CSV'],
  ['vtu', t('VTU, tetrahedra')],
  ['msh', t('Gmsh, tetrahedra')],
  [STRIPES, t('GLB with the stripes')],
];
const PATHS = [
  ['csv', 'CSV'],
  ['obj', 'OBJ'],
  ['glb', 'GLB'],
] as const;
const LINES = [
  ['command', t('Command line')],
  ['python', 'Python'],
  ['rust', 'Rust'],
] as const;
const TEXT_OF = { command: commandLines, python: pythonLines, rust: rustLines };

/** Isolines in numbers, and files of curves, distances and paths. */
export function exportSection(session: Session): HTMLElement {
  const said = h('p', { class: 'quiet', role: 'status' });
  session.shown.watch((shown, previous) => {
    if (shown?.answer !== previous?.answer) say(said, '');
  });
  /** Disables a button while its work is under way, and tells why it failed. */
  const action: Action = (name, title, work) => {
    // It changes nothing, so that the search may do it at once.
    const button = h('button', { class: 'wide', title, 'data-done-by-search': true }, name);
    button.addEventListener('click', () => {
      button.disabled = true;
      // Told where it was asked for: the section is longer than a window.
      button.after(said);
      say(said, '');
      void Promise.resolve()
        .then(work)
        .then((words) => say(said, words ?? null))
        .catch((error: unknown) => say(said, sentenceOf(error)))
        .finally(() => (button.disabled = false));
    });
    return button;
  };
  return h(
    'div',
    { class: 'stack' },
    ofSurfaces(session, curveControls(session, action)),
    ...distanceControls(session, action),
    ...pathControls(session, action),
    ofSurfaces(session, trackControls(session, action)),
    ...reproduceControls(session, action),
    said,
  );
}

/** Controls that are of no use inside of tetrahedra, and say so there. */
function ofSurfaces(session: Session, controls: readonly HTMLElement[]): HTMLElement {
  const group = h('fieldset', { class: 'stack' }, ...controls);
  const show = () => {
    const isInside = Boolean(session.shown.value?.opened.interior);
    group.disabled = isInside;
    reason(group, isInside ? OF_SURFACES : null);
  };
  session.shown.watch(show);
  show();
  return group;
}

type Action = (name: Words, title: Words, work: () => Promise<Words | void> | Words | void) => HTMLElement;

/** The engine where there is a field. */
function asked(session: Session): Engine {
  if (!session.engine || !session.shown.value?.answer.field)
    throw new Failure(t('There are no distances yet. Place a source on the surface.'));
  return session.engine;
}

/** The same where that is on a surface. */
function measured(session: Session): Engine {
  if (session.shown.value?.opened.interior) throw new Failure(OF_SURFACES);
  return asked(session);
}

/** The unit in which lengths are shown. */
function shownUnit({ scene, shown }: Session): LengthUnit {
  return shown.value ? unitOf(scene.state, shown.value.opened) : MODEL;
}

function curveControls(session: Session, action: Action): HTMLElement[] {
  const at = h('input', { type: 'text', inputMode: 'decimal', placeholder: t('as the stripes'), id: 'isolines-at' });
  const name = h('span');
  const table = h('div', { class: 'scroll' });
  /** What is typed in a row is one step of undo. */
  const typing = {};
  const wish = () => {
    // The typed text, not the scene, says what cannot be read.
    parseIsolines(plainNumbers(at.value), shownUnit(session));
    const largest = session.shown.value?.answer.field?.maxDistance ?? inModel(0, MODEL);
    return withinReach(isolineWish(session), largest, shownUnit(session));
  };
  const problem = h('p', { class: 'quiet', role: 'status', hidden: true });
  const tell = (words: Words | null) => {
    problem.hidden = words === null;
    say(problem, words ?? '');
    at.ariaInvalid = words === null ? null : 'true';
  };
  at.addEventListener('change', () => {
    try {
      parseIsolines(plainNumbers(at.value), shownUnit(session));
    } catch (error) {
      tell(sentenceOf(error));
    }
  });
  at.addEventListener('input', () => {
    tell(null);
    try {
      const isolines = parseIsolines(plainNumbers(at.value), shownUnit(session));
      const { overlays } = session.scene.state;
      // Who asks for some wants to see them.
      const shown: readonly Overlay[] = overlays.includes('isolines') ? overlays : [...overlays, 'isolines'];
      session.scene.edit(isolines ? { isolines, overlays: shown } : { isolines }, typing);
    } catch {
      // It may be half typed.
    }
  });
  const show = () => {
    if (document.activeElement !== at)
      at.value = isolinesText(session.scene.state.isolines, shownUnit(session)).replaceAll(',', ';');
    say(name, withUnit(t('Isolines at'), shownUnit(session).symbol));
  };
  session.scene.subscribe((state, previous) => {
    if (state.isolines !== previous.isolines) show();
    if (!isSameUnit(state, previous)) convert();
  });
  const convert = () => {
    table.replaceChildren();
    show();
  };
  show();
  const measure = async () => {
    table.replaceChildren();
    const isolines = await measured(session).queries.isolines(wish());
    table.replaceChildren(tableOf(isolines, shownUnit(session)));
    return isolines.isTrue
      ? t('Curves follow the exact distance, their lengths to about a thousandth.')
      : t('Curves are straight within triangles: short of the true ones, the more the larger the triangles are.');
  };
  let [kind] = CURVES[0];
  const file = select(t('File'), CURVES, (value) => (kind = value));
  const saveFile = async () => {
    const unit = unitOfFile(kind, shownUnit(session));
    if (kind.endsWith('pdf') && !isKnown(unit))
      throw new Failure(
        t('A PDF is at true scale, and nothing says what the lengths are in. Choose it by "Correct unit".'),
      );
    const wanted = { kind, towardEye: towardEye(session.view.camera), unit };
    const saved = await measured(session).queries.curveFile(wish(), wanted);
    save(new Blob([saved.bytes]), `${fileNameOf(session.shown.value)}.isolines.${kind}`);
    return saved.leftOut.length > 0 ? leftOutWords(session, saved, unit) : undefined;
  };
  session.shown.watch((shown, previous) => {
    if (shown?.answer.field !== previous?.answer.field) table.replaceChildren();
    if (shown?.opened !== previous?.opened) {
      show();
      tell(null);
    }
  });
  return [
    h(
      'label',
      { class: 'field', title: t('A spacing, or values with commas between them; empty: the period of the stripes') },
      name,
      at,
    ),
    problem,
    action(t('Measure isolines'), t('Length of each isoline, and the area that is nearer'), measure),
    table,
    file.element,
    action(t('Save isolines'), t('Curves of equal distance, or the surface cut along them'), saveFile),
  ];
}

/** Strips that are not in a file, and what to do about it. */
function leftOutWords(session: Session, { leftOut, flatSpacing }: SavedCurves, unit: LengthUnit): Words {
  let { assumed } = shownUnit(session);
  const length = (value: number) => {
    const words = lengthWords(inModel(value, unit), { ...shownUnit(session), assumed });
    // Once is enough.
    assumed = false;
    return words;
  };
  const words = leftOut.map(([from, to]) => {
    if (from === null) return t`below ${length(to ?? 0)}`;
    return to === null ? t`beyond ${length(from)}` : t`from ${length(from)} to ${length(to)}`;
  });
  const more = words.length - MOST_NAMED;
  const named = more > 0 ? [...words.slice(0, MOST_NAMED), counted(more, '{0} more', '{0} more')] : words;
  return sentences(
    t`Left out, since they are curved: the strips ${enumerated(named)}.`,
    flatSpacing === null
      ? t('Narrower strips hold fewer vertices; only one that holds no curved vertex is flat.')
      : t`A spacing of ${length(flatSpacing)} makes all of them flat.`,
  );
}

function cells(tag: 'th' | 'td', words: readonly Words[]): HTMLElement {
  return h('tr', {}, ...words.map((word) => h(tag, {}, word)));
}

function tableOf({ rows }: Isolines, unit: LengthUnit): HTMLElement {
  const isolines = counted(rows.length, '{0} isoline', '{0} isolines');
  return h(
    'table',
    { class: 'rows' },
    h('caption', { class: 'quiet' }, listed(isolines, unit.symbol ? unitWords(unit) : null)),
    h('thead', {}, cells('th', [t('Distance'), t('Length'), t('Area nearer'), t('Closed')])),
    h(
      'tbody',
      {},
      ...rows.map(({ value, length, area, curves, closed }) =>
        cells('td', [
          threeDigits(told(value, unit)),
          threeDigits(told(length, unit)),
          threeDigits(toldArea(area, unit)),
          t`${closed} of ${curves}`,
        ]),
      ),
    ),
  );
}

function distanceControls(session: Session, action: Action): HTMLElement[] {
  let kind: DistanceFile | typeof STRIPES | typeof LOG_MAP = 'csv';
  let innerKind: InnerDistanceFile | typeof STRIPES = 'csv';
  const file = select(t('Distances'), DISTANCES, (value) => (kind = value));
  const innerFile = select(t('Distances'), INNER_DISTANCES, (value) => (innerKind = value));
  const isInside = () => Boolean(session.shown.value?.opened.interior);
  const show = () => ([file.element.hidden, innerFile.element.hidden] = [isInside(), !isInside()]);
  session.shown.watch(show);
  show();
  const work = async () => {
    const engine = asked(session);
    const unit = shownUnit(session);
    if (kind === LOG_MAP && !isInside()) {
      const wish = (await import('../../session/directions')).logMapWish(session);
      save(new Blob([await engine.queries.logMapFile(wish, unit)]), `${fileNameOf(session.shown.value)}.${LOG_MAP}`);
      return;
    }
    const bytes = isInside()
      ? innerKind !== STRIPES && (await engine.queries.innerDistanceFile(innerKind, unit))
      : kind !== STRIPES && kind !== LOG_MAP && (await engine.queries.distanceFile(kind, unitOfFile(kind, unit)));
    if (!bytes) return saveStripes(session, unit);
    save(new Blob([bytes]), `${fileNameOf(session.shown.value)}.distances.${isInside() ? innerKind : kind}`);
    const { clips, parts } = session.shown.value?.opened ?? { clips: [], parts: [] };
    if (kind === 'glb' && !isInside() && clips.length + parts.length > 1)
      return t('The file has one mesh, in the pose that is shown, without names of parts, bones and animations.');
  };
  const title = t('One for each vertex of the file, in the unit that is shown; GLB files are in meters');
  return [file.element, innerFile.element, action(t('Save distances'), title, work)];
}

async function saveStripes(session: Session, unit: LengthUnit): Promise<Words | void> {
  const { stripesGlb } = await import('../../session/stripes');
  const { painted, shown } = session;
  if (!painted || !shown.value) throw new Failure(t('There are no distances yet.'));
  const { name, appearance, drawTransform } = shown.value.opened;
  const file = stripesGlb(painted, drawTransform, unitOfFile('glb', unit), name);
  save(new Blob([file]), `${fileNameOf(shown.value)}.${STRIPES}`);
  if (appearance && painted.style.surfaceOf === 'file')
    return t('The stripes are on the colors of the style, without the materials of the file.');
}

function pathControls(session: Session, action: Action): HTMLElement[] {
  let kind: (typeof PATHS)[number][0] = 'csv';
  const file = select(t('Path'), PATHS, (value) => (kind = value));
  const work = () => {
    const path = session.shown.value?.answer.path;
    if (!path) throw new Failure(t('There is no path. Place a walker on the surface.'));
    const points = vectorsIn(path.places);
    save(new Blob([pathFile(kind, points, shownUnit(session))]), `${fileNameOf(session.shown.value)}.path.${kind}`);
  };
  return [
    file.element,
    action(t('Save path'), t('The points of the path, in the unit that is shown; GLB files are in meters'), work),
  ];
}

function trackControls(session: Session, action: Action): HTMLElement[] {
  let kind: (typeof PATHS)[number][0] = 'csv';
  const file = select(t('Tracks'), PATHS, (value) => (kind = value));
  const work = async () => {
    const tracks = trackPoints(await measured(session).queries.crowdTracks());
    if (tracks.length === 0) throw new Failure(t('There is no crowd. Choose how many walk in the section Display.'));
    save(new Blob([tracksFile(kind, tracks, shownUnit(session))]), `${fileNameOf(session.shown.value)}.tracks.${kind}`);
  };
  const title = t(
    'The ways of the crowd to the sources, from where each walker is, in the unit that is shown; GLB files are in meters',
  );
  return [file.element, action(t('Save tracks'), title, work)];
}

function reproduceControls(session: Session, action: Action): HTMLElement[] {
  let kind: (typeof LINES)[number][0] = 'command';
  const lines = select(t('Reproduce by'), LINES, (value) => (kind = value));
  const field = h('textarea', {
    readOnly: true,
    rows: 3,
    hidden: true,
    'aria-label': t('Lines that reproduce the distances'),
  });
  const work = async () => {
    field.value = TEXT_OF[kind](await measuredBy(session));
    field.hidden = false;
    if (await copy(field.value)) return t('Copied.');
    field.select();
    return t('The clipboard is not available. Copy the lines from the field.');
  };
  // They would be of distances before.
  session.shown.watch((shown, previous) => {
    if (shown?.answer !== previous?.answer) field.hidden = true;
  });
  return [lines.element, action(t('Copy lines'), t('Lines that give the present distances again'), work), field];
}

async function measuredBy(session: Session): Promise<Measured> {
  asked(session);
  const { shown, scene, request } = session;
  const { opened, answer } = shown.value ?? {};
  if (!opened || !answer?.field || !request) throw new Failure(t('There are no distances yet.'));
  const [mesh, origin] = await namedAs(session, scene.state.mesh);
  const present = { state: scene.state, mesh, origin, opened, field: answer.field, unit: shownUnit(session) };
  return origin && scene.state.mesh.kind === 'preset' ? inShownUnit(present) : present;
}

/** The same on a mesh that was saved in the unit that is shown. */
function inShownUnit(ofModel: Measured): Measured {
  const { state, unit } = ofModel;
  const { scale } = unit;
  const offset = <P extends { offset?: number }>(point: P): P =>
    point.offset === undefined ? point : { ...point, offset: scale * point.offset };
  const sources = state.sources.map(offset);
  const sets = state.sets.map((set) => ({ ...offset(set), points: set.points.map(offset) }));
  const bridge = typeof state.bridge === 'number' ? scale * state.bridge : state.bridge;
  return { ...ofModel, state: { ...state, sources, sets, bridge }, unit: { ...unit, scale: 1 } };
}

/** What a program can open that a mesh is in, and how to come by it; null where that is clear. */
async function namedAs(
  { request, shown }: Session,
  mesh: MeshReference,
): Promise<[mesh: string, origin: Words | null]> {
  const { name = '', interior = null } = shown.value?.opened ?? {};
  if (mesh.kind === 'file') return [name, null];
  if (mesh.kind === 'address') return [name, t`${name} is from ${mesh.address}.`];
  const input = await request?.load();
  if (input?.kind === 'shape' || input?.kind === 'tetrahedra') return [`shape:${input.shape}`, null];
  const [ending, kind] = interior ? ['msh', t('Gmsh, tetrahedra')] : ['ply', t('PLY, double')];
  const file = `${fileNameOf(shown.value)}.distances.${ending}`;
  return [file, t`"Save distances" as "${kind}" on the page writes ${file}, which these lines open.`];
}
