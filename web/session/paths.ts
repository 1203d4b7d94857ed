/** Curves of paths on the surface: asks for them, and shows them. Loaded when they are first wanted. */
import type { FoundPaths, PathCurves, Source } from '../protocol';
import { allSources } from '../state/sources';
import { rimmed } from '../view/layers';
import { Beside } from './beside';
import { type Asked as OnSurface, isMoving, isSameSurface, placesOf, surfaceOf } from './exact';
import type { Shown } from './prepare';
import type { Session } from './session';

const LINE = { colour: '#ff8a00', width: 3 } as const;
/** How many sources they need. */
export const LEAST: Readonly<Record<PathCurves, number>> = { loops: 0, loop: 1, bezier: 2 };
const NONE: readonly Source[] = [];

interface Asked extends OnSurface {
  shown: Shown;
  sources: readonly Source[];
}

export class Paths extends Beside<Asked, FoundPaths> {
  readonly #kind: PathCurves;

  constructor(session: Session, kind: PathCurves) {
    super(session);
    this.#kind = kind;
  }

  protected get wanted(): Asked | null | undefined {
    const { engine, shown, scene, pose, dragging } = this.session;
    const { value } = shown;
    if (!scene.state.overlays.includes(this.#kind) || !engine || !value || isMoving(this.session)) return null;
    if (value.opened.interior) return null;
    const { question } = value.answer;
    const asked = { engine, question, moment: pose.value, shown: value };
    if (LEAST[this.#kind] === 0) return { ...asked, sources: NONE };
    const { sources } = scene.state;
    if (sources.length < LEAST[this.#kind]) return null;
    // While a source is dragged, what was found before is shown.
    if (dragging || allSources(scene.state) !== question.sources) return undefined;
    return { ...asked, sources };
  }

  protected isSame(one: Asked, other: Asked): boolean {
    return one.sources === other.sources && isSameSurface(one, other);
  }

  protected find(asked: Asked): Promise<FoundPaths> {
    const { opened } = asked.shown;
    const places = placesOf(opened, asked.sources);
    return asked.engine.inTurn.pathCurves({ ...surfaceOf(opened, asked), kind: this.#kind, places });
  }

  protected show(found: FoundPaths | null): void {
    const { view, paths } = this.session;
    view.setEdges(this.#kind, found ? rimmed({ ...LINE, ends: found.ends }, 0.5) : []);
    paths[this.#kind].value = found;
  }
}
