/** Numbers and sentences as the page shows them. */
import type { BuildReport, DistanceField, Factoring, FieldError, OpenedMesh } from '../protocol';
import { MOST_SECONDS, type Phase } from '../solver/refiner';
import type { LengthUnit, SceneState } from '../state/scene';
import { partsOfFaces } from '../state/parts';
import type { SourceSet } from '../state/sources';
import { language, t } from '../texts';

/** What is wanted of a field. */
type Wish = Pick<SceneState, 'method' | 'pathKind'>;

const GROUPED = new Intl.NumberFormat(language, { maximumFractionDigits: 0 });
const THREE_DIGITS = new Intl.NumberFormat(language, { maximumSignificantDigits: 3, useGrouping: false });

const PLURALS = new Intl.PluralRules(language);

export function count(value: number): string {
  return GROUPED.format(value);
}

export function counted(value: number, noun: string, plural = `${noun}s`): string {
  return `${count(value)} ${t(PLURALS.select(value) === 'one' ? noun : plural)}`;
}

/** Of files about a mesh, without an ending. */
export function fileNameOf(shown: { opened: OpenedMesh } | null): string {
  return (shown?.opened.name ?? 'heatwalk').replace(/\.\w+$/, '');
}

/** With so many digits after the point. */
export function fixed(value: number, digits: number): string {
  const all = { minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false };
  return value.toLocaleString(language, all);
}

export function length(value: number): string {
  return THREE_DIGITS.format(value);
}

/** A length in the unit of the mesh. */
export function measure(value: number, unit: LengthUnit): string {
  return `${length(value * unit.scale)} ${unitWords(unit)}`;
}

/** A unit, and that it is assumed where it is. */
export function unitWords({ symbol, assumed }: LengthUnit): string {
  return `${symbol || t('units')}${assumed ? t(' (assumed)') : ''}`;
}

/** A volume in the unit of the mesh, cubed. */
export function volume(value: number, { symbol, assumed, scale }: LengthUnit): string {
  const told = length(value * scale ** 3);
  return symbol ? `${told} ${symbol}³${assumed ? t(' (assumed)') : ''}` : t`${told} cubic units`;
}

/** An area in the unit of the mesh, squared. */
export function area(value: number, { symbol, assumed, scale }: LengthUnit): string {
  const told = length(value * scale ** 2);
  return symbol ? `${told} ${symbol}²${assumed ? t(' (assumed)') : ''}` : t`${told} square units`;
}

export function percent(share: number): string {
  return `${Math.round(100 * share)} %`;
}

/** Rounded down: 100 % only where it is all. */
export function percentDown(share: number): string {
  return `${Math.floor(100 * share)} %`;
}

/** The least share that is told from 0, and that from which on one digit after the point says enough. */
const LEAST_SHARE = 1e-5;
const PLAIN_SHARE = 1e-3;

/** Errors are small: one digit after the point where the share is under 10 %, and more where that would be 0. */
export function finePercent(share: number): string {
  if (share >= 0.1) return percent(share);
  if (share >= PLAIN_SHARE || share === 0) return `${fixed(100 * share, 1)} %`;
  return share < LEAST_SHARE
    ? t('below 0.001 %')
    : `${(100 * share).toLocaleString(language, { maximumSignificantDigits: 1 })} %`;
}

export function milliseconds(value: number): string {
  return value < 10
    ? `${fixed(value, 1)} ms`
    : value < 10_000
      ? `${Math.round(value)} ms`
      : `${fixed(value / 1000, 1)} s`;
}

/** A time that is seldom a moment, of so many milliseconds. */
export function seconds(value: number): string {
  return `${fixed(value / 1000, value < 950 ? 2 : 1)} s`;
}

export function bytes(value: number): string {
  return t`${fixed(value / 2 ** 20, value < 10 * 2 ** 20 ? 1 : 0)} MiB`;
}

/** Share of exact vertices that is worth telling. */
const LEAST_EXACT = 0.01;

/** How large a mesh is. */
export function sizeWords({ report, interior }: OpenedMesh): string {
  return interior ? t`${count(interior.report.tetrahedra)} tetrahedra` : t`${count(report.faces)} triangles`;
}

/** What was done to the triangles of a file, in one sentence. */
export function openingSentence(opened: OpenedMesh, factoring: Factoring, unit: LengthUnit): string {
  const { name, report, interior } = opened;
  if (interior) {
    const { tetrahedra, components, remark } = interior.report;
    const told = t`${name}: ${counted(tetrahedra, 'tetrahedron', 'tetrahedra')}; ${counted(components, 'component')}.`;
    return remark ? `${told} ${remark}.` : told;
  }
  const done = repairs(report);
  const components = componentWords(report, factoring);
  const shape = `${components}, ${counted(report.boundaryLoops, 'boundary', 'boundaries')}`;
  const proxy = simplifiedSentence(opened, unit);
  const told =
    done.length > 0 && !proxy
      ? t`${name}: ${done.join(', ')}; ${shape}.`
      : t`${name}: ${counted(report.faces, 'triangle')}; ${shape}.`;
  return [told, joinedSentence(factoring), proxy].filter(Boolean).join(' ');
}

/** What may be joined otherwise than the surface is meant; null where nothing is. */
function joinedSentence({ crackPortals, crackGap, contactsComplete }: Factoring): string | null {
  const told: string[] = [];
  if (crackPortals > 0) {
    const places = counted(crackPortals, 'place', 'places');
    told.push(t`Paths cross gaps between boundaries, up to ${length(crackGap)} units wide, at ${places}.`);
  }
  if (!contactsComplete) {
    told.push(
      t(
        'Parts meet in more places than are looked at; those that meet elsewhere alone are not joined, and links may be wider than need be.',
      ),
    );
  }
  return told.length > 0 ? told.join(' ') : null;
}

/** That a simplified model is seen, of what, and how far it is off; null for a mesh as it is in its file. */
export function simplifiedSentence(opened: OpenedMesh, unit: LengthUnit): string | null {
  if (!opened.simplified) return null;
  const { triangles, error, diagonal } = opened.simplified;
  const off = t`${measure(error, unit)}, ${finePercent(error / diagonal)} of the diagonal`;
  return t`This is a simplified model of ${counted(triangles, 'triangle')}; it differs by about ${off}.`;
}

const NAMED = 4;

/** What a file was read without, or otherwise than it is written, and what keeps it from looking as it should; null if nothing. */
export function absentSentence({ name, missing, undecoded, warnings }: OpenedMesh): string | null {
  const sentences = warnings.map((warning) => t`${name}, ${placeWords(warning.place)}: ${warningWords(warning)}.`);
  if (missing.length === 1) sentences.push(t`${name} refers to ${listed(missing)}, which was not given.`);
  if (missing.length > 1) sentences.push(t`${name} refers to ${listed(missing)}, which were not given.`);
  if (undecoded.length > 0) sentences.push(t`The browser cannot show ${listed(undecoded)}.`);
  return sentences.length > 0 ? sentences.join(' ') : null;
}

/** What was left out, or taken otherwise than it is written. */
function warningWords({ code, count: number }: OpenedMesh['warnings'][number]): string {
  switch (code) {
    case 'lines-left-out':
      return t`${counted(number, 'point or line', 'points or lines')} left out`;
    case 'curves-left-out':
      return t`${counted(number, 'statement of a curve', 'statements of curves')} left out; save the model as polygons`;
    case 'volumes-left-out':
      return t`${counted(number, 'cell that fills space', 'cells that fill space')} left out`;
    case 'unknown-statements':
      return t`${counted(number, 'unknown statement')} left out`;
    case 'unjoined-lines':
      return t('a backslash ends a line; the next one begins a statement of its own and was not joined to it');
    case 'unended-facets':
      return counted(number, 'facet without endfacet', 'facets without endfacet');
    case 'no-end':
      return t('the end of the file is missing; it may be cut short');
    case 'trailing':
      return t('there is more behind the end; it was left out');
    case 'straightened':
      return t`${counted(number, 'curved cell')} made flat between the corners`;
    case 'crossed-polygons':
      return t`${counted(number, 'polygon crosses itself', 'polygons cross themselves')}; the triangles are a guess`;
    default:
      return code;
  }
}

/** A place in a file; the names of elements are those of its format. */
function placeWords(place: string): string {
  const line = /^line (\d+)$/.exec(place);
  return line ? t`line ${line[1]}` : place;
}

/** Names, of many the first ones. */
function listed(names: readonly string[]): string {
  const rest = names.length - NAMED;
  const shown =
    rest > 0 ? [...names.slice(0, NAMED), t`${count(rest)} more`] : names.map((name) => name || t('an image'));
  return shown.length === 1 ? shown[0] : t`${shown.slice(0, -1).join(', ')} and ${shown.at(-1) ?? ''}`;
}

/** How many components there are, and how they are joined: "55 components, 93 contacts, one group". */
function componentWords({ components }: BuildReport, { groups, contacts, links }: Factoring): string {
  const joined = [];
  if (contacts > 0) joined.push(counted(contacts, 'contact'));
  if (links > 0) joined.push(counted(links, 'link'));
  if (joined.length > 0) joined.push(groupWords(groups));
  return [counted(components, 'component'), ...joined].join(', ');
}

function groupWords(groups: number): string {
  return groups === 1 ? t('one group') : counted(groups, 'group');
}

/** How many links there are between groups and how far they reach; null without any. */
export function linksSentence({ groups, links, linkedGap }: Factoring): string | null {
  if (links === 0) return null;
  const over = links === 1 ? t('a gap of') : t('gaps of up to');
  return t`${counted(links, 'link')} over ${over} ${length(linkedGap)} units; ${groupWords(groups)}.`;
}

function repairs(report: BuildReport): string[] {
  const done: string[] = [];
  const say = (verb: string, value: number, noun: string, plural?: string) => {
    if (value > 0) done.push(`${verb} ${counted(value, noun, plural)}`);
  };
  say(t('welded'), report.weldedVertices - report.crackVertices, 'seam vertex', 'seam vertices');
  if (report.crackVertices > 0) {
    const cracks = counted(report.crackVertices, 'crack vertex', 'crack vertices');
    done.push(t`welded ${cracks} within ${report.crackWidth.toPrecision(2)} units`);
  }
  say(t('removed'), report.unreferencedVertices, 'unreferenced vertex', 'unreferenced vertices');
  say(t('removed'), report.degenerateFaces, 'degenerate triangle');
  say(t('removed'), report.duplicateFaces, 'duplicate triangle');
  say(t('flipped'), report.flippedFaces, 'triangle');
  say(t('cut along'), report.nonManifoldEdges, 'non-manifold edge');
  return done;
}

/** What was solved, as people say it. */
function methodWords({ windows, inner, timeFactor }: DistanceField): string {
  if (inner && timeFactor === undefined) return t('waves through the tetrahedra');
  return windows === undefined ? t('the heat method') : t`propagation with ${counted(windows, 'window')}`;
}

/** How a field was found and how much of it is exact, in as few words as the heading has room for. */
export function exactnessWords(field: DistanceField): string {
  const { exactBelow, exactShare, windows, inner, timeFactor } = field;
  if (exactBelow === Infinity) return t('exact');
  if (inner && timeFactor === undefined) return t`waves, ${percentDown(exactShare)} straight`;
  const method = windows === undefined ? t('heat method') : t('propagation');
  return exactShare >= LEAST_EXACT ? t`${method}, ${percentDown(exactShare)} exact` : method;
}

/** How a field was found, and how far it is exact, in a sentence. */
export function fieldSentence(field: DistanceField): string {
  const { exactBelow, exactShare, windows, error, inner, timeFactor } = field;
  if (inner && timeFactor === undefined) {
    const straight = t`Straight lines lead from ${percentDown(exactShare)} of the vertices to a source: these are exact`;
    return exactBelow === Infinity
      ? t('Exact: straight lines lead from everywhere to a source.')
      : t`By waves. ${straight}.`;
  }
  if (exactBelow === Infinity)
    return error ? t`Exact. Error of ${methodWords(field)}: ${errorWords(error)}.` : t('Exact.');
  const beyond = windows === undefined ? '' : t(', an upper bound beyond');
  const exact =
    exactShare >= LEAST_EXACT
      ? t`: exact below ${length(exactBelow)} units (${percentDown(exactShare)} of vertices)${beyond}`
      : '';
  return t`By ${methodWords(field)}${exact}.`;
}

export function errorWords({ mean, max }: FieldError): string {
  return t`mean ${finePercent(mean)}, maximum ${finePercent(max)}`;
}

/** What a set is, with how many places it has. */
export function setName({ shape, points }: SourceSet, opened?: OpenedMesh): string {
  const vertices = counted(points.length, 'vertex', 'vertices');
  switch (shape.kind) {
    case 'line':
      return t`${shape.closed ? t('Closed line') : t('Line')} of ${vertices}`;
    case 'stroke':
      return t`${shape.closed ? t('Closed curve') : t('Stroke')} of ${counted(points.length, 'point')}`;
    case 'boundary':
      return t`Boundary of ${vertices}`;
    case 'component':
      return t`Component of ${vertices}`;
    case 'part':
      return `${opened?.parts.at(shape.part)?.name || t`Part ${shape.part + 1}`}, ${vertices}`;
    case 'list':
      return t`${shape.name}: ${count(points.length)}`;
  }
}

/** What is shown, and the state of refinement or the reason why it ended. */
export function refiningSentence(phase: Phase, field: DistanceField, { method, pathKind }: Wish): string {
  const soFar = fieldSentence(field);
  switch (phase) {
    case 'memory': {
      const instead = pathKind === 'exact' ? t(' The path is straightened where no exact one was found.') : '';
      return t`${soFar} Refinement stopped because memory ran out.${instead}`;
    }
    case 'late':
      return t`${soFar} Refinement stopped after ${MOST_SECONDS} seconds.`;
    case 'stuck':
      return t`${soFar} Refinement stopped because it made no progress.`;
    case 'off':
      return method === 'propagation' ? soFar : t`${soFar} Refinement is off.`;
    case 'inside':
      return soFar;
    case 'costs':
      return t`${soFar} Where costs differ, windows and paths are refracted and nothing is exact.`;
    case 'exact':
    case 'solving':
    case 'resting':
    case 'refining':
    case 'hidden':
    case 'failed':
    case 'idle':
      return soFar;
  }
}

/** The parts that no source reaches; null if there are none. */
export function unreachedSentence(opened: OpenedMesh, field: DistanceField): string | null {
  const { unreachableVertices } = field;
  if (unreachableVertices === 0) return null;
  const all = (opened.interior?.report ?? opened.report).vertices;
  const share = t`${counted(unreachableVertices, 'vertex', 'vertices')} of ${count(all)}`;
  if (field.byCorner && opened.report.components === 1) {
    return t`Walls cut off what is drawn hatched (${share}). Open a gate, or add a source there.`;
  }
  const names = unreachedParts(opened, field);
  const what = names.length > 0 ? `${names.join(', ')} (${share})` : t`A component (${share})`;
  return t`${what} is not connected to any source and is drawn hatched. Add a source there, or link it.`;
}

/** Those that no source reaches; none where triangles of the file were removed, for then they cannot be told. */
function unreachedParts(opened: OpenedMesh, { distance, byCorner }: DistanceField): string[] {
  const { parts, active, surface } = opened;
  const partOfFace = active.length < 2 ? null : partsOfFaces(opened);
  if (!partOfFace) return [];
  const reached = new Set<number>();
  surface.triangles.forEach((vertex, corner) => {
    if (distance[byCorner ? corner : vertex] < Infinity) reached.add(partOfFace[Math.floor(corner / 3)]);
  });
  return active.filter((part) => !reached.has(part)).map((part) => parts[part].name);
}
