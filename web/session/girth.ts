/** Measures the curves in which the plane of the scene cuts the surface, as fast as they are asked for. */
import type { DrawTransform, Plane } from '../protocol';
import { type ModelLength, ofModel } from '../length';
import { type CutPlane, directionOf, middleOf } from '../state/inside';
import type { Box } from '../state/places';
import { Signal, until } from '../state/signal';
import { distance, dot, type Vector, vectorAt } from '../state/vector';
import { filePlace } from './nearest';
import type { Session } from './session';

/** A curve as it is drawn, with its length. */
export interface Loop {
  points: readonly Vector[];
  closed: boolean;
  length: ModelLength;
}

/** The plane in the axes of the file; `box` is around the mesh as it is drawn. */
export function planeOf(plane: CutPlane, box: Box, transform: DrawTransform): Plane {
  const normal = filePlace(directionOf(plane), { ...transform, center: [0, 0, 0], scale: 1 });
  return { normal, offset: ofModel(dot(normal, filePlace(middleOf(plane, box), transform))) };
}

/** The curves of segments that follow each other where they belong to one, the longest closed one first; `scale`: a unit as it is drawn. */
export function loopsOf(ends: Float32Array, scale: number): Loop[] {
  const curves: Vector[][] = [];
  for (let segment = 0; segment < ends.length / 6; segment++) {
    const [start, end] = [vectorAt(ends, 2 * segment), vectorAt(ends, 2 * segment + 1)];
    const curve = curves.at(-1);
    const last = curve?.at(-1);
    // A closed one does not go on.
    const goesOn = last && isSame(last, start) && !(curve && curve.length > 1 && isSame(last, curve[0]));
    if (goesOn) curve?.push(end);
    else curves.push([start, end]);
  }
  const loops = curves.map((points) => {
    const drawn = points.reduce((sum, point, index) => sum + distance(points[index - 1] ?? point, point), 0);
    return { points, closed: isSame(points[0], points.at(-1)), length: ofModel<1>(drawn / scale) };
  });
  return loops.toSorted((one, other) => Number(other.closed) - Number(one.closed) || other.length - one.length);
}

function isSame(one: Vector | undefined, other: Vector | undefined): boolean {
  return one !== undefined && other !== undefined && one.every((value, axis) => value === other[axis]);
}

export class Girths {
  /** The curves, the girth first; null where none are wanted, or of tetrahedra. */
  readonly loops = new Signal<readonly Loop[] | null>(null);
  readonly #session: Session;
  /** What was measured last was asked for by these. */
  #asked: readonly unknown[] = [];
  #isBusy = false;

  constructor(session: Session) {
    this.#session = session;
    session.scene.subscribe((state, previous) => {
      if (state.girth !== previous.girth) void this.#follow();
    });
    session.shown.watch(() => void this.#follow());
    void this.#follow();
  }

  /** The plane that is wanted, in the axes of the file; null for none. */
  get plane(): Plane | null {
    const { scene, shown } = this.#session;
    const { girth } = scene.state;
    if (!girth || !shown.value || shown.value.opened.interior) return null;
    return planeOf(girth, shown.value.places.box, shown.value.opened.drawTransform);
  }

  /** Resolves when what is wanted is measured. */
  async settled(): Promise<void> {
    await until(() => !this.#isBusy, this.loops);
  }

  async #follow(): Promise<void> {
    if (this.#isBusy) return;
    this.#isBusy = true;
    for (let wish = this.#wish(); !isEqual(wish, this.#asked); wish = this.#wish()) {
      this.#asked = wish;
      const { plane } = this;
      const { engine, shown } = this.#session;
      const scale = shown.value?.opened.drawTransform.scale ?? 1;
      try {
        this.loops.value = plane && engine ? loopsOf(await engine.queries.girth(plane), scale) : null;
      } catch (error) {
        // Another worker is asked again.
        if (isEqual(wish, this.#wish())) this.#session.fail(error);
      }
    }
    this.#isBusy = false;
    this.loops.value = this.loops.value && [...this.loops.value];
  }

  /** What the curves depend on. */
  #wish(): readonly unknown[] {
    const { scene, shown, engine } = this.#session;
    return [scene.state.girth, shown.value?.opened, engine];
  }
}

function isEqual(one: readonly unknown[], other: readonly unknown[]): boolean {
  return one.length === other.length && one.every((value, index) => value === other[index]);
}
