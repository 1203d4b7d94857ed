/** Numbers and sentences as the page shows them. */
import type { BuildReport, DistanceField, Factoring, OpenedMesh } from '../protocol';
import { entry } from '../state/entry';
import { inUnit, isKnown, type LengthUnit, type ModelLength, told } from '../length';
import { measure } from '../state/measures';
import { partsOfFaces } from '../state/parts';
import type { SourceSet } from '../state/sources';
import { count, counted, enumerated, listed, numbers, retold, sentences, some, t, type Words } from '../texts';

/** What is said to who has a mouse, and to who has fingers. */
export function byHand<T>(mouse: T, touch: T): T {
  return matchMedia('(pointer: coarse)').matches ? touch : mouse;
}

/** Of files about a mesh, without an ending. */
export function fileNameOf(shown: { opened: OpenedMesh } | null): string {
  return (shown?.opened.name ?? 'heatwalk').replace(/\.\w+$/, '');
}

function decimals(digits: number): (value: number) => Words {
  return numbers({ minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false });
}

const whole = decimals(0);
export const tenths = decimals(1);
export const hundredths = decimals(2);
export const thousandths = decimals(3);
const oneDigit = numbers({ maximumSignificantDigits: 1 });

export function percent(share: number): Words {
  return t`${whole(100 * share)} %`;
}

/** Rounded down: 100 % only where it is all. */
export function percentDown(share: number): Words {
  return percent(Math.floor(100 * share) / 100);
}

/** The least share that is written as other than "below", and that from which on one digit after the point is enough. */
const LEAST_SHARE = 1e-5;
const PLAIN_SHARE = 1e-3;

/** Errors are small: one digit after the point where the share is under 10 %, and more where that would be 0. */
export function finePercent(share: number): Words {
  if (share >= 0.1) return percent(share);
  if (share >= PLAIN_SHARE || share === 0) return t`${tenths(100 * share)} %`;
  return share < LEAST_SHARE ? t('below 0.001 %') : t`${oneDigit(100 * share)} %`;
}

export function milliseconds(value: number): Words {
  if (value >= 10_000) return t`${tenths(value / 1000)} s`;
  return t`${value < 10 ? tenths(value) : whole(value)} ms`;
}

/** A time that is seldom a moment, of as many milliseconds. */
export function seconds(value: number): Words {
  return t`${(value < 950 ? hundredths : tenths)(value / 1000)} s`;
}

export function bytes(value: number): Words {
  return t`${(value < 10 * 2 ** 20 ? tenths : whole)(value / 2 ** 20)} MiB`;
}

/** On the flat, by Tobler's hiking function: 6 exp(−3.5 · 0.05). */
const HIKER_KM_PER_HOUR = 6 * Math.exp(-3.5 * 0.05);

/** How long a hiker takes for what costs as much as a length of flat ground; null where no unit says how long that is. */
export function hikingWords(cost: ModelLength, unit: LengthUnit): Words | null {
  if (!isKnown(unit)) return null;
  const minutes = Math.round((60 * told(cost, inUnit(unit, 'km'))) / HIKER_KM_PER_HOUR);
  const hours = Math.floor(minutes / 60);
  return hours === 0 ? t`${minutes} min` : t`${hours} h ${minutes % 60} min`;
}

/** Share of exact vertices that is worth telling. */
export const LEAST_EXACT = 0.01;

/** How large a mesh is. */
export function sizeWords({ report, interior, isCloud }: OpenedMesh): Words {
  if (isCloud) return counted(report.inputVertices, '{0} point', '{0} points');
  return interior ? tetrahedraWords(interior.report) : trianglesWords(report.faces);
}

export function tetrahedraWords({ tetrahedra }: { tetrahedra: number }): Words {
  return counted(tetrahedra, '{0} tetrahedron', '{0} tetrahedra');
}

export function trianglesWords(triangles: number): Words {
  return counted(triangles, '{0} triangle', '{0} triangles');
}

export function verticesWords(vertices: number): Words {
  return counted(vertices, '{0} vertex', '{0} vertices');
}

function componentsWords(components: number): Words {
  return counted(components, '{0} component', '{0} components');
}

/** What is opened, in the sentence that a person wants: "Dragon, 46,540 triangles, in one piece."; and what may be otherwise than it is meant. */
export function openingSentence(title: Words, opened: OpenedMesh, factoring: Factoring, unit: LengthUnit): Words {
  const { report, interior } = opened;
  const pieces = piecesOf(interior?.report ?? report, factoring);
  const what = counted(pieces, '{1}, {2}, in one piece.', '{1}, {2}, in {0} pieces.', title, sizeWords(opened));
  if (interior) return what;
  return sentences(what, ...joinedSentences(factoring, unit), simplifiedSentence(opened, unit));
}

/** Components, of which those that are joined are one. */
function piecesOf({ components }: { components: number }, { contacts, links, groups }: Factoring): number {
  return contacts + links > 0 ? groups : components;
}

/** What was done to what is opened, and what it consists of: a line each. */
export function openingDetails({ report, interior }: OpenedMesh, factoring: Factoring, unit: LengthUnit): Words[] {
  if (interior) {
    const { components, remark } = interior.report;
    return [componentsWords(components), ...(remark ? [retold(remark)] : [])];
  }
  const loops = counted(report.boundaryLoops, '{0} boundary', '{0} boundaries');
  return [listed(...joints(report, factoring), loops), ...repairs(report, unit)];
}

/** What may be joined otherwise than the surface is meant. */
function joinedSentences({ crackPortals, crackGap, contactsComplete }: Factoring, unit: LengthUnit): (Words | null)[] {
  return [
    some(
      crackPortals,
      'Paths cross gaps between boundaries, up to {1} wide, at {0} place.',
      'Paths cross gaps between boundaries, up to {1} wide, at {0} places.',
      measure(crackGap, unit),
    ),
    contactsComplete
      ? null
      : t(
          'Parts meet in more places than are looked at; those that meet elsewhere alone are not joined, and links may be wider than need be.',
        ),
  ];
}

/** That a simplified model is seen, of what, and how far it is off; null for a mesh as it is in its file. */
export function simplifiedSentence(opened: OpenedMesh, unit: LengthUnit): Words | null {
  if (!opened.simplified) return null;
  const { triangles, error, diagonal } = opened.simplified;
  return t`This is a simplified model of ${trianglesWords(triangles)}; it differs by about ${measure(error, unit)}, ${finePercent(error / diagonal)} of the diagonal.`;
}

/** How many components there are, and how they are joined: "55 components, 93 contacts, one group". */
function joints({ components }: BuildReport, { groups, contacts, links }: Factoring): (Words | null)[] {
  return [
    componentsWords(components),
    some(contacts, '{0} contact', '{0} contacts'),
    some(links, '{0} link', '{0} links'),
    contacts + links > 0 ? groupWords(groups) : null,
  ];
}

export function groupWords(groups: number): Words {
  return counted(groups, 'one group', '{0} groups');
}

function repairs(report: BuildReport, unit: LengthUnit): Words[] {
  const { crackVertices, weldedVertices, crackWidth } = report;
  return [
    some(weldedVertices - crackVertices, 'welded {0} seam vertex', 'welded {0} seam vertices'),
    some(
      crackVertices,
      'welded {0} crack vertex within {1}',
      'welded {0} crack vertices within {1}',
      measure(crackWidth, unit),
    ),
    some(report.unreferencedVertices, 'removed {0} unreferenced vertex', 'removed {0} unreferenced vertices'),
    some(report.degenerateFaces, 'removed {0} degenerate triangle', 'removed {0} degenerate triangles'),
    some(report.duplicateFaces, 'removed {0} duplicate triangle', 'removed {0} duplicate triangles'),
    some(report.flippedFaces, 'flipped {0} triangle', 'flipped {0} triangles'),
    some(report.nonManifoldEdges, 'cut along {0} non-manifold edge', 'cut along {0} non-manifold edges'),
  ].filter((each) => each !== null);
}

/** How a field was found and how much of it is exact, in as few words as the heading has space for. */
export function exactnessWords(field: DistanceField): Words {
  const { exactBelow, exactShare, windows, inner, timeFactor } = field;
  if (exactBelow === Infinity) return t('exact');
  if (inner && timeFactor === undefined) return t`waves, ${percentDown(exactShare)} straight`;
  const isExact = exactShare >= LEAST_EXACT;
  if (windows === undefined) return isExact ? t`heat method, ${percentDown(exactShare)} exact` : t('heat method');
  return isExact ? t`propagation, ${percentDown(exactShare)} exact` : t('propagation');
}

/** What a set is, with how many places it has. */
export function setName({ shape, points }: SourceSet, opened?: OpenedMesh): Words {
  const places = points.length;
  switch (shape.kind) {
    case 'line':
      return shape.closed
        ? counted(places, 'Closed line of {0} vertex', 'Closed line of {0} vertices')
        : counted(places, 'Line of {0} vertex', 'Line of {0} vertices');
    case 'stroke':
      return shape.closed
        ? counted(places, 'Closed curve of {0} point', 'Closed curve of {0} points')
        : counted(places, 'Stroke of {0} point', 'Stroke of {0} points');
    case 'boundary':
      return counted(places, 'Boundary of {0} vertex', 'Boundary of {0} vertices');
    case 'component':
      return counted(places, 'Component of {0} vertex', 'Component of {0} vertices');
    case 'part':
      return t`${opened?.parts[shape.part]?.name || t`Part ${shape.part + 1}`}, ${verticesWords(places)}`;
    case 'list':
      return t`${shape.name}: ${count(places)}`;
  }
}

/** The parts that no source reaches; null if there are none. */
export function unreachedSentence(opened: OpenedMesh, field: DistanceField): Words | null {
  const { unreachableVertices } = field;
  if (unreachableVertices === 0) return null;
  const all = (opened.interior?.report ?? opened.report).vertices;
  const share = t`${verticesWords(unreachableVertices)} of ${count(all)}`;
  if (field.byCorner && opened.report.components === 1) {
    return t`Walls cut off what is drawn hatched (${share}). Open a gate, or add a source there.`;
  }
  const names = unreachedParts(opened, field);
  if (names.length === 0) {
    return counted(
      unreachableVertices,
      '{1} is not connected to any source and is drawn hatched. Add a source there, or link it.',
      '{1} are not connected to any source and are drawn hatched. Add a source there, or link them.',
      share,
    );
  }
  return counted(
    names.length,
    '{1} ({2}) is not connected to any source and is drawn hatched. Add a source there, or link it.',
    '{1} ({2}) are not connected to any source and are drawn hatched. Add a source there, or link them.',
    enumerated(names),
    share,
  );
}

/** Those that no source reaches; none where triangles of the file were removed, which leaves them unknown. */
function unreachedParts(opened: OpenedMesh, { distance, byCorner }: DistanceField): string[] {
  const { parts, active, surface } = opened;
  const partOfFace = active.length < 2 ? null : partsOfFaces(opened);
  if (!partOfFace) return [];
  const reached = new Set<number>();
  surface.triangles.forEach((vertex, corner) => {
    if (entry(distance, byCorner ? corner : vertex) < Infinity) reached.add(entry(partOfFace, Math.floor(corner / 3)));
  });
  return active.filter((part) => !reached.has(part)).map((part) => entry(parts, part).name);
}
