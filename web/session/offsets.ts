/** Distance from the curves of the scene as wholes, with a sign: asks for it, and shows it in two colors. Loaded when it is first wanted. */
import type { CurveDistances, CurveWish, MeshPoint, OpenedMesh } from '../protocol';
import type { Answer } from '../solver/engine';
import { entry } from '../state/entry';
import { isWeighted } from '../state/ground';
import type { Places } from '../state/places';
import type { SceneState } from '../state/scene';
import { colourOfSide } from '../state/sides';
import { isClosed, isCurve, type SourceSet } from '../state/sources';
import { distance } from '../state/vector';
import { patchesOfTiles } from '../view/cells';
import { type Patches, RIM } from '../view/layers';
import { layPatches } from '../view/patches';
import { Beside } from './beside';
import { longestStep } from './curves';
import { type Asked as OnSurface, isMoving, isSameSurface, placesOf, surfaceOf } from './exact';
import type { Shown } from './prepare';
import { t, type Words } from '../texts';

const LINE = { colour: RIM, width: 1.4 } as const;

/** What they depend on. */
interface Asked extends OnSurface {
  sets: readonly SourceSet[];
  period: number;
  shown: Shown;
}

export class Offsets extends Beside<Asked, CurveDistances> {
  protected get wanted(): Asked | null | undefined {
    const { engine, shown, scene, pose, dragging } = this.session;
    const { value } = shown;
    if (!scene.state.overlays.includes('curves') || !engine || !value || isMoving(this.session)) return null;
    if (whyNone(value, scene.state)) return null;
    // While a curve is drawn, what was found before is shown.
    if (dragging) return undefined;
    const { sets, style } = scene.state;
    return { engine, question: value.answer.question, moment: pose.value, sets, period: style.period, shown: value };
  }

  protected isSame(one: Asked, other: Asked): boolean {
    return one.sets === other.sets && one.period === other.period && isSameSurface(one, other);
  }

  protected find(asked: Asked): Promise<CurveDistances> {
    return asked.engine.inTurn.curveDistances(wishOf(asked));
  }

  protected show(found: CurveDistances | null): void {
    const { view, shown, offsets } = this.session;
    const { opened, places } = shown.value ?? {};
    const patches = found && opened && places ? patchesOf(found, opened, places) : null;
    layPatches(view, 'sides', patches);
    view.setEdges('offsets', found ? [{ ...LINE, ends: found.ends }] : []);
    offsets.value = found;
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

function wishOf({ sets, period, shown: { opened, places }, ...asked }: Asked): CurveWish {
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

function patchesOf(found: CurveDistances, { surface, report }: OpenedMesh, places: Places): Patches {
  const colourOf = (side: number, first: number) => colourAt(found, side, first);
  return patchesOfTiles(surface, places.drawn, found, colourOf, places.drawnDiameter, report.boundaryLoops > 0);
}

/** At the corner of a part whose weights begin at `first`. */
function colourAt({ values, tiles, corners, range }: CurveDistances, side: number, first: number): number[] {
  const triangle = entry(tiles, 2 * Math.floor(first / 9) + 1);
  let value = 0;
  for (let k = 0; k < 3; k++) value += entry(corners, first + k) * entry(values, 3 * triangle + k);
  const [least, most] = range;
  return colourOfSide(side === 0, Math.abs(value) / Math.max(-least, most));
}
