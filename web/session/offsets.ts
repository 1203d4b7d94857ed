/** Distance from the curves of the scene as wholes, with a sign: asks for it, and shows it in two colors. Loaded when it is first wanted. */
import type { CurveDistances, CurveWish, MeshPoint, OpenedMesh } from '../protocol';
import type { Answer, Engine } from '../solver/engine';
import { Cancelled, WorkerLost } from '../solver/remote';
import { entry } from '../state/entry';
import { isWeighted } from '../state/ground';
import type { Places } from '../state/places';
import type { SceneState } from '../state/scene';
import { colourOfSide } from '../state/sides';
import { isClosed, isCurve, type SourceSet } from '../state/sources';
import { distance } from '../state/vector';
import { patchesOfTiles } from '../view/cells';
import { RIM } from '../view/layers';
import { layPatches } from '../view/patches';
import { longestStep } from './curves';
import { isSameSurface, placesOf, surfaceOf } from './exact';
import type { Shown } from './prepare';
import type { Session } from './session';
import { t, type Words } from '../texts';

const LINE = { colour: RIM, width: 1.4 } as const;

/** What they depend on. */
interface Asked {
  engine: Engine;
  question: Answer['question'];
  sets: readonly SourceSet[];
  period: number;
}

export class Offsets {
  readonly #session: Session;
  #asked: Asked | null = null;
  #finding: Promise<void> = Promise.resolve();

  constructor(session: Session) {
    this.#session = session;
  }

  /** Shows what the scene wants by now. Resolves when it is shown, or something else is wanted. */
  follow(): Promise<void> {
    const { engine, shown, scene, animator, paused, dragging } = this.#session;
    const { value } = shown;
    const isMoving = animator.plays && !paused.value;
    if (!scene.state.overlays.includes('curves') || !engine || !value || isMoving || whyNone(value, scene.state)) {
      this.#clear();
      return Promise.resolve();
    }
    const { question } = value.answer;
    const asked = { engine, question, sets: scene.state.sets, period: scene.state.style.period };
    if (this.#asked && isSame(this.#asked, asked)) return this.#finding;
    if (this.#asked && !isSameSurface(this.#asked, asked)) this.#clear();
    // While a curve is drawn, what was found before is shown.
    if (dragging) return this.#finding;
    this.#asked = asked;
    this.#finding = this.#find(asked, value);
    return this.#finding;
  }

  async #find(asked: Asked, value: Shown): Promise<void> {
    try {
      const found = await asked.engine.inTurn.curveDistances(wishOf(value, asked));
      if (this.#asked === asked) this.#show(found);
    } catch (error) {
      if (this.#asked !== asked) return;
      this.#clear();
      // It is not asked again until something changes.
      this.#asked = asked;
      if (!(error instanceof Cancelled || error instanceof WorkerLost)) this.#session.fail(error);
    }
  }

  #show(found: CurveDistances): void {
    const { view, shown, offsets } = this.#session;
    if (!shown.value) return;
    const { opened, places } = shown.value;
    const isOpen = opened.report.boundaryLoops > 0;
    const colourOf = (side: number, first: number) => colourAt(found, side, first);
    const patches = patchesOfTiles(opened.surface, places.drawn, found, colourOf, places.drawnDiameter, isOpen);
    layPatches(view, 'sides', patches);
    view.setEdges('offsets', [{ ...LINE, ends: found.ends }]);
    offsets.value = found;
  }

  #clear(): void {
    if (!this.#asked) return;
    this.#asked = null;
    const { view, offsets } = this.#session;
    layPatches(view, 'sides', null);
    view.setEdges('offsets', []);
    offsets.value = null;
  }
}

/** Why there is no distance from curves to show; null: there is. */
export function whyNone(
  { opened, answer }: { opened: OpenedMesh; answer: Answer },
  { sets }: Pick<SceneState, 'sets'>,
): Words | null {
  if (opened.interior) return t('Curves are on surfaces alone.');
  if (!sets.some(isCurve)) return t('There is no curve yet: draw a line or a stroke, or choose a boundary.');
  if (isWeighted(answer.question.ground)) return t('Where costs differ no distance from curves is known.');
  return null;
}

function isSame(one: Asked, other: Asked): boolean {
  return one.sets === other.sets && one.period === other.period && isSameSurface(one, other);
}

function wishOf({ opened, places }: Shown, { sets, period, ...asked }: Asked): CurveWish {
  const curves = curvesOf(sets, places);
  return {
    ...surfaceOf(opened, asked),
    counts: Uint32Array.from(curves, ({ points }) => points.length),
    closed: Uint8Array.from(curves, ({ closed }) => (closed ? 1 : 0)),
    places: placesOf(
      opened,
      curves.flatMap(({ points }) => points),
    ),
    period,
  };
}

/** The curves of sets, strokes in pieces where the pen was lifted. */
function curvesOf(sets: readonly SourceSet[], places: Places): { points: readonly MeshPoint[]; closed: boolean }[] {
  return sets.filter(isCurve).flatMap((set) => {
    const longest = longestStep(set, places);
    const isJoined = (from: MeshPoint, to: MeshPoint) => {
      const [a, b] = [places.at(from)?.position, places.at(to)?.position];
      return a !== undefined && b !== undefined && distance(a, b) < longest;
    };
    const pieces: MeshPoint[][] = [[]];
    set.points.forEach((point, index) => {
      if (index > 0 && !isJoined(entry(set.points, index - 1), point)) pieces.push([]);
      pieces.at(-1)?.push(point);
    });
    const ends = [entry(set.points, set.points.length - 1), entry(set.points, 0)] as const;
    const closed = pieces.length === 1 && isClosed(set) && isJoined(...ends);
    return pieces.filter(({ length }) => length > 1).map((points) => ({ points, closed }));
  });
}

/** At the corner of a part whose weights begin at `first`. */
function colourAt({ values, tiles, corners, range }: CurveDistances, side: number, first: number): number[] {
  const triangle = entry(tiles, 2 * Math.floor(first / 9) + 1);
  let value = 0;
  for (let k = 0; k < 3; k++) value += entry(corners, first + k) * entry(values, 3 * triangle + k);
  const [least, most] = range;
  return colourOfSide(side === 0, Math.abs(value) / Math.max(-least, most));
}
