/** Arrows of a direction at the sources that is carried over the surface. Loaded when they are first wanted. */
import type { DirectionWish, Source } from '../protocol';
import { rightAt } from '../state/decalframe';
import { allSources } from '../state/sources';
import { Failure } from '../error';
import { Beside } from './beside';
import { type Asked as OnSurface, isMoving, isSameSurface, placesOf, surfaceOf } from './exact';
import type { Shown } from './prepare';
import type { Session } from './session';
import { t } from '../texts';

/** From the right side of an image to upright, degrees. */
const UPRIGHT = 90;

interface Asked extends OnSurface {
  shown: Shown;
  sources: readonly Source[];
  heading: number;
}

export class Directions extends Beside<Asked, Float32Array> {
  protected get wanted(): Asked | null | undefined {
    const { engine, shown, scene, pose, dragging } = this.session;
    const { value } = shown;
    const { overlays, sources, heading } = scene.state;
    if (!overlays.includes('carried') || !engine || !value || isMoving(this.session)) return null;
    if (value.opened.interior || sources.length === 0) return null;
    const { question } = value.answer;
    if (dragging || allSources(scene.state) !== question.sources) return undefined;
    return { engine, question, moment: pose.value, shown: value, sources, heading };
  }

  protected isSame(one: Asked, other: Asked): boolean {
    return one.sources === other.sources && one.heading === other.heading && isSameSurface(one, other);
  }

  protected find(asked: Asked): Promise<Float32Array> {
    return asked.engine.inTurn.carried(wishOf(asked));
  }

  protected show(found: Float32Array | null): void {
    const { view, scene } = this.session;
    // Other arrows are shown by others.
    if (found || scene.state.overlays.includes('carried')) view.setArrows(found ?? new Float32Array());
  }
}

/** The log map of the first source, with u along the heading of the scene. */
export function logMapWish({ engine, shown, scene, pose }: Session): DirectionWish {
  const { sources, heading } = scene.state;
  const [first] = sources;
  if (!engine || !shown.value || !first) throw new Failure(t('There is no source yet. Place one on the surface.'));
  const { question } = shown.value.answer;
  return wishOf({ engine, question, moment: pose.value, shown: shown.value, sources: [first], heading });
}

/** The heading of a scene at each of some sources. */
function wishOf({ shown: { opened, places }, sources, heading, ...asked }: Asked): DirectionWish {
  const directions = sources.flatMap((source) => {
    const normal = places.at(source)?.normal;
    if (!normal) throw new Failure(t('A source is on no triangle.'));
    return rightAt(normal, heading + UPRIGHT);
  });
  return {
    ...surfaceOf(opened, asked),
    places: placesOf(opened, sources),
    directions: Float64Array.from(directions),
  };
}
