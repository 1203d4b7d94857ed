/** Adds sets of sources as gestures, text and files ask for it. Fetched with the first of these. */
import { Failure } from '../error';
import type { MeshPoint, Source } from '../protocol';
import { addSet, addSource, replaceSet, selectedSet } from '../state/edit';
import { type Row, rowsOf } from '../state/list';
import { scaled, type Vector } from '../state/vector';
import type { Scene } from '../state/history';
import { headOf, MODEL, ofModel, typed, unitOf } from '../length';
import { measure } from '../state/measures';
import {
  allSources,
  type Corner,
  indexOf,
  MOST_POINTS,
  MOST_SETS,
  onceEach,
  placesOf,
  type SetShape,
  type SourceSet,
  withOffset,
} from '../state/sources';
import { atVertices, lineThrough, type Mesh, outlined, pointsOf } from './found';
import { drawnPlace, filePlace, nearestPlace } from './nearest';
import { boundaryNear, partOf } from './outlines';
import type { Session } from './session';
import { count, counted, t, type Words } from '../texts';

/** As a share of the diagonal: what is no farther away is there. */
const ROUNDING = 1e-6;
/** As a share of the diameter: what was measured on a model is nearer to it. */
const FAR = 0.1;

/** Letters of the name of a list. */
const LONGEST_NAME = 60;

/**
 * Goes on with the line that is selected to the vertex nearest to a place, closes it at its first vertex, and ends it at its last. Where
 * none is selected, a line begins there, or, `fromLast`, at the last source, which it replaces.
 */
export async function extendLine(session: Session, point: MeshPoint, fromLast: boolean): Promise<void> {
  const { scene } = session;
  const mesh = meshOf(session);
  if (!mesh) return;
  const to = mesh.places.nearestVertex(point);
  const line = selectedSet(scene);
  if (line?.shape.kind === 'line' && !line.shape.closed) {
    const { corners } = line.shape;
    if (to === corners.at(-1)) scene.set({ selected: -1 });
    else if (to === corners[0] && corners.length > 1) await closeLine(session, line);
    else await growLine(session, mesh, line, corners, to);
    return;
  }
  const { sources } = scene.state;
  const last = fromLast ? sources.at(-1) : undefined;
  const from = last && mesh.places.nearestVertex(last);
  if (!last || from === undefined || from === to) {
    // A line of one vertex asks nothing but whether the mesh has lines at all.
    await mesh.engine.queries.line(to, to);
    addSet(scene, { shape: { kind: 'line', corners: [to], closed: false }, points: [{ vertex: to }], offset: 0 });
    return;
  }
  const corners = [from, to];
  const points = atVertices(await lineThrough(mesh.engine, corners, false));
  const now = scene.state;
  if (mesh.engine !== session.engine || now.sources.at(-1) !== last) return;
  const set: SourceSet = { shape: { kind: 'line', corners, closed: false }, points, offset: last.offset ?? 0 };
  const rest = now.sources.slice(0, -1);
  scene.edit({ sources: rest, sets: [...now.sets, set], selected: rest.length + now.sets.length });
}

async function growLine(
  session: Session,
  { engine }: Mesh,
  line: SourceSet,
  corners: readonly number[],
  to: number,
): Promise<void> {
  const more = await engine.queries.line(corners.at(-1) ?? to, to);
  if (engine !== session.engine || !session.scene.state.sets.includes(line)) return;
  const points = [...line.points, ...atVertices([...more.subarray(1)])];
  replaceSet(session.scene, line, {
    ...line,
    shape: { kind: 'line', corners: [...corners, to], closed: false },
    points,
  });
}

/**
 * Leads a line along edges through the vertex nearest to a place in the stead of one of its corners. The corner as it is then; null where
 * the line is gone meanwhile.
 */
export async function moveCorner(
  session: Session,
  corner: Corner,
  point: MeshPoint,
  gesture: object,
): Promise<Corner | null> {
  const mesh = meshOf(session);
  const { set, place } = corner;
  const { shape } = set;
  if (!mesh || shape.kind !== 'line') return null;
  const vertex = mesh.places.nearestVertex(point);
  // Corners that meet would be one.
  if (shape.corners.includes(vertex)) return corner;
  const moved = { ...shape, corners: shape.corners.with(place, vertex) };
  const points = await pointsOf(mesh, moved, []);
  if (mesh.engine !== session.engine || !session.scene.state.sets.includes(set)) return null;
  const line: SourceSet = { ...set, shape: moved, points };
  replaceSet(session.scene, set, line, gesture);
  return { set: line, place, vertex };
}

/** Closes a line along edges or a stroke, and ends it. */
export async function closeLine(session: Session, set: SourceSet): Promise<void> {
  const mesh = meshOf(session);
  const { shape } = set;
  if (!mesh || !('closed' in shape)) return;
  const closed = { ...shape, closed: true };
  const points = await pointsOf(mesh, closed, set.points);
  if (mesh.engine !== session.engine || !session.scene.state.sets.includes(set)) return;
  replaceSet(session.scene, set, { ...set, shape: closed, points });
  session.scene.set({ selected: -1 });
}

/** Adds the boundary loop that is nearest to a place. */
export async function addBoundary(session: Session, point: MeshPoint): Promise<void> {
  await addFound(session, async (mesh) => {
    const place = mesh.places.at(point)?.position;
    const on = await outlined(mesh);
    const vertex = place
      ? boundaryNear({ ...on, surface: { ...on.surface, positions: mesh.places.positions } }, place)
      : null;
    if (vertex === null) throw new Failure(t('This surface is closed: it has no boundary that could be a source.'));
    return { kind: 'boundary', vertex };
  });
}

/** @throws where the scene would have more than it may. */
function addWhole(scene: Scene, set: SourceSet): void {
  const { sets } = scene.state;
  const places = sets.reduce((sum, other) => sum + placesOf(other), placesOf(set));
  if (places > MOST_POINTS)
    throw new Failure(t`With these there are ${count(places)} sources; up to ${count(MOST_POINTS)} are taken.`);
  if (sets.length >= MOST_SETS)
    throw new Failure(t`A scene takes ${count(MOST_SETS)} sets of sources; remove one first.`);
  addSet(scene, set);
}

/** Adds all vertices of the part that a place is on; of the component, where the file has one part. */
export async function addPart(session: Session, point: MeshPoint): Promise<void> {
  await addFound(session, async (mesh) => {
    const part = 'face' in point ? partOf(await outlined(mesh), point.face) : null;
    return part === null ? { kind: 'component', vertex: mesh.places.nearestVertex(point) } : { kind: 'part', part };
  });
}

async function addFound(session: Session, shapeOn: (mesh: Mesh) => Promise<SetShape>): Promise<void> {
  const mesh = meshOf(session);
  if (!mesh) return;
  const shape = await shapeOn(mesh);
  const points = await pointsOf(mesh, shape, []);
  if (mesh.engine === session.engine) addWhole(session.scene, { shape, points, offset: 0 });
}

/** A list of sources that can be added. */
export interface PlacedList {
  count: number;
  /** How far the farthest of them is from where it was given. */
  away: Words;
  /** Whether that is too far to be meant: see `FAR`. */
  isFar: boolean;
  /** Adds them; of which one alone is a single source. What was added, in a sentence. */
  add: () => Words;
}

/**
 * A list of sources on the mesh on screen.
 *
 * @throws where a row is none, with its line.
 */
export function placeList(session: Session, name: Words, text: string): PlacedList {
  const mesh = meshOf(session);
  if (!mesh) throw new Failure(t('There is no mesh yet.'));
  const { scene } = session;
  const { opened, places } = mesh;
  const unit = unitOf(scene.state, opened);
  const placed = rowsOf(name, text, unit).map((row) => placedOf(row, mesh));
  const farthest = placed.reduce((most, { away }) => Math.max(most, away), 0) / opened.drawTransform.scale;
  const away = measure(ofModel(farthest), unit);
  const isAway = farthest > ROUNDING * places.diameter;
  const add = () => {
    const [first, ...others] = placed;
    if (first && others.length === 0) {
      if (!addSource(scene, first.source)) return t('This place is a source already.');
      return isAway ? t`Added, ${away} away from there.` : t('Added.');
    }
    const points = inOrder(placed.map(({ source }) => source));
    const short = String(name)
      .replaceAll(/\p{Surrogate}/gu, '')
      .slice(0, LONGEST_NAME);
    addWhole(scene, { shape: { kind: 'list', name: short }, points, offset: 0 });
    const isByPlace = placed.some(({ row }) => 'coordinates' in row.place);
    return isByPlace
      ? counted(
          points.length,
          '{0} source added, at most {1} away from where it was given.',
          '{0} sources added, at most {1} away from where they were given.',
          away,
        )
      : counted(points.length, '{0} source added.', '{0} sources added.');
  };
  return { count: placed.length, away, isFar: farthest > FAR * places.diameter, add };
}

/**
 * The same, added. What was added, in a sentence.
 *
 * @throws where a row is none, with its line, and nothing is changed.
 */
export function addList(session: Session, name: Words, text: string): Words {
  return placeList(session, name, text).add();
}

interface Placed {
  row: Row;
  source: Source;
  /** From where it was given, as it is drawn. */
  away: number;
}

function placedOf(row: Row, { opened, places }: Mesh): Placed {
  const { place, offset, at } = row;
  if ('vertex' in place) {
    if (!places.has(place)) {
      const { inputVertices } = opened.report;
      const isThere = place.vertex < inputVertices;
      throw new Failure(
        isThere
          ? t`${at}: no triangle has vertex ${place.vertex}.`
          : t`${at}: there is no vertex ${place.vertex}; the mesh has ${count(inputVertices)}, counted from 0.`,
      );
    }
    return { row, source: withOffset(place, offset), away: 0 };
  }
  const point = drawnPlace(place.coordinates, opened.drawTransform);
  const nearest = nearestPlace(opened.surface, opened.inputVertices, point);
  return { row, source: withOffset(nearest.point, offset), away: nearest.away };
}

/** By index, which is short in a link. */
function inOrder(sources: readonly Source[]): Source[] {
  return onceEach(sources).toSorted((a, b) => indexOf(a) - indexOf(b));
}

/** All sources as rows that `addList` takes: by vertex where all are vertices, else by their coordinates. The head says the unit. */
export function tableOf({ scene, shown }: Session): string {
  const sources = allSources(scene.state);
  const unit = shown.value ? unitOf(scene.state, shown.value.opened) : MODEL;
  const isByVertex = sources.every((source) => 'vertex' in source);
  const rows = sources.map((source) => {
    const mesh = shown.value;
    const start = typed(ofModel(source.offset ?? 0), unit);
    if (isByVertex && 'vertex' in source) return `${source.vertex},${start}`;
    const place: Vector = mesh?.places.at(source)?.position ?? [0, 0, 0];
    return mesh ? [...scaled(filePlace(place, mesh.opened.drawTransform), unit.scale), start].join() : '';
  });
  return [
    isByVertex ? `vertex,${headOf(['offset'], unit)}` : headOf(['x', 'y', 'z', 'offset'], unit),
    ...rows,
    '',
  ].join('\n');
}

function meshOf({ engine, shown }: Session): Mesh | null {
  return engine && shown.value ? { engine, opened: shown.value.opened, places: shown.value.places } : null;
}
