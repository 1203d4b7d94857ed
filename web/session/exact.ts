/** The surface on which the worker finds what is beside the field by exact distances: cells, images. */
import { Failure } from '../error';
import type { ExactSurface, MeshPoint, Moment, OpenedMesh, TrianglePlaces } from '../protocol';
import { type Answer, type Engine, isSameMoment } from '../solver/engine';
import { entry } from '../state/entry';
import { mayBeJoined } from '../state/scene';
import type { Session } from './session';
import { t } from '../texts';

/** What such a surface depends on. */
export interface Asked {
  engine: Engine;
  question: Pick<Answer['question'], 'bridge' | 'links' | 'ground'>;
  /** The pose that is shown, in which it is measured. */
  moment: Moment | null;
}

/** Whether the model moves by itself: what is found in one pose is not that of the next. */
export function isMoving({ animator, paused }: Session): boolean {
  return animator.plays && !paused.value;
}

/** The surface that was asked last. */
let numbered: { asked: Asked; number: number } | undefined;

export function surfaceOf(opened: OpenedMesh, asked: Asked): ExactSurface {
  if (!numbered || !isSameSurface(numbered.asked, asked)) numbered = { asked, number: (numbered?.number ?? 0) + 1 };
  const { bridge, links } = asked.question;
  const isJoined = mayBeJoined(opened);
  return { surface: numbered.number, bridge: isJoined ? String(bridge) : 'off', links: isJoined ? links : 0 };
}

export function isSameSurface({ engine, question, moment }: Asked, other: Asked): boolean {
  return (
    engine === other.engine &&
    isSameMoment(moment, other.moment) &&
    question.bridge === other.question.bridge &&
    question.links === other.question.links &&
    question.ground === other.question.ground
  );
}

/** Places as weights of corners of drawn triangles. */
export function placesOf({ surface, inputVertices, report }: OpenedMesh, places: readonly MeshPoint[]): TrianglePlaces {
  const cornerOf = new Int32Array(report.inputVertices).fill(-1);
  surface.triangles.forEach((drawn, corner) => (cornerOf[entry(inputVertices, drawn)] = corner));
  const found = { triangles: new Uint32Array(places.length), weights: new Float64Array(3 * places.length) };
  places.forEach((place, index) => {
    if ('face' in place) {
      found.triangles[index] = place.face;
      found.weights.set(place.weights, 3 * index);
      return;
    }
    const corner = 'vertex' in place ? (cornerOf[place.vertex] ?? -1) : -1;
    if (corner < 0) throw new Failure(t('A source is on no triangle.'));
    found.triangles[index] = Math.floor(corner / 3);
    found.weights[3 * index + (corner % 3)] = 1;
  });
  return found;
}
