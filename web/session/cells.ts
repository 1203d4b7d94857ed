/** What is nearest to each source: asks for it, and shows it as colors with borders. Loaded when it is first wanted. */
import type { CellWish, ExactSurface, FoundCells, Moment, OpenedMesh, Source, SpreadWish } from '../protocol';
import { Cancelled, WorkerLost } from '../solver/remote';
import { type Answer, isSameMoment } from '../solver/engine';
import { hasCosts, openCost, isWeighted } from '../state/ground';
import { entry } from '../state/entry';
import type { SceneState } from '../state/scene';
import { allSources, withOffset } from '../state/sources';
import type { Vector } from '../state/vector';
import { colouredCells } from '../view/cells';
import { RIM } from '../view/layers';
import { layPatches } from '../view/patches';
import { type Asked as OnSurface, isSameSurface, placesOf, surfaceOf } from './exact';
import type { Session } from './session';
import { t, type Words } from '../texts';

const BORDER = { colour: RIM, width: 2 } as const;
const FIRST = Float64Array.of(1, 0, 0);

/** What cells depend on. */
interface Asked extends OnSurface {
  question: Answer['question'];
  /** The pose that is shown. */
  moment: Moment | null;
}

export class Cells {
  readonly #session: Session;
  #asked: Asked | null = null;
  #finding: Promise<void> = Promise.resolve();
  #question = 0;

  constructor(session: Session) {
    this.#session = session;
  }

  /** Shows what the scene wants by now. Resolves when it is shown, or something else is wanted. */
  follow(): Promise<void> {
    const { engine, shown, scene, pose, animator, paused, cells } = this.#session;
    const isMoving = animator.plays && !paused.value;
    const isWanted = scene.state.overlays.includes('cells') && !isMoving;
    const { value } = shown;
    if (!engine || !value || !isWanted || value.answer.question.quick || whyNoCells(value, scene.state)) {
      this.#clear();
      return Promise.resolve();
    }
    const { opened, answer } = value;
    // Another answer is on its way.
    if (allSources(scene.state) !== answer.question.sources) return this.#finding;
    const asked = { engine, question: answer.question, moment: pose.value };
    if (this.#asked && isSame(this.#asked, asked)) return this.#finding;
    if (this.#asked && !isSameSurface(this.#asked, asked)) this.#clear();
    else if (cells.value) cells.value = { ...cells.value, outdated: true };
    this.#asked = asked;
    this.#question += 1;
    const wish = wishOf(opened, answer.question, scene.state);
    this.#finding = this.#find(asked, { ...wish, ...surfaceOf(opened, asked), question: this.#question });
    return this.#finding;
  }

  async #find(asked: Asked, wish: CellWish): Promise<void> {
    try {
      for (;;) {
        const found = await asked.engine.inTurn.cells(wish);
        if (this.#asked !== asked) return;
        if (found) return this.#show(found);
      }
    } catch (error) {
      if (this.#asked !== asked) return;
      this.#clear();
      if (!(error instanceof Cancelled || error instanceof WorkerLost)) this.#session.fail(error);
    }
  }

  #show(found: FoundCells): void {
    const { view, shown, cells } = this.#session;
    if (!shown.value) return;
    const { opened, places } = shown.value;
    const isOpen = opened.report.boundaryLoops > 0;
    layPatches(view, 'cells', colouredCells(opened.surface, places.drawn, found, places.drawnDiameter, isOpen));
    view.setEdges('cells', [{ ...BORDER, ends: found.ends }]);
    cells.value = found;
  }

  #clear(): void {
    if (!this.#asked) return;
    this.#asked = null;
    const { view, cells } = this.#session;
    layPatches(view, 'cells', null);
    view.setEdges('cells', []);
    cells.value = null;
  }
}

/** Why there are no cells to show; null: there are. */
export function whyNoCells(
  { opened, answer }: { opened: OpenedMesh; answer: Answer },
  { sources, sets }: Pick<SceneState, 'sources' | 'sets'>,
): Words | null {
  if (opened.interior) return t('Cells are on surfaces alone.');
  if (sources.length + sets.length < 2) return t('Cells are of two sources or more.');
  if (isWeighted(answer.question.ground)) return t('Where costs differ no distance is exact, and cells are not known.');
  return null;
}

/**
 * Sources in the stead of the single ones: so many, each as far from those before as can be; these moved once to the middles of their
 * cells; or the one place that is their mean. Null where there is no surface to ask.
 */
export async function otherSources(session: Session, wanted: SpreadWish['wanted']): Promise<readonly Source[] | null> {
  const { engine, shown, scene } = session;
  if (!engine || !shown.value) return null;
  const { opened, answer } = shown.value;
  const asked = { engine, question: answer.question };
  const { sources } = scene.state;
  const places = sources.length > 0 ? placesOf(opened, sources) : { triangles: Uint32Array.of(0), weights: FIRST };
  const numbers = await engine.inTurn.spread({ ...surfaceOf(opened, asked), places, wanted });
  if (session.engine !== engine || scene.state.sources !== sources) return null;
  return Array.from({ length: numbers.length / 4 }, (_, index) => {
    const face = entry(numbers, 4 * index);
    const weights: Vector = [1, 2, 3].map((k) => entry(numbers, 4 * index + k)) as unknown as Vector;
    const corner = weights.indexOf(1);
    const place = corner < 0 ? { face, weights } : { vertex: vertexOf(opened, 3 * face + corner) };
    return withOffset(place, wanted === 'middles' ? (sources[index]?.offset ?? 0) : 0);
  });
}

function vertexOf({ surface: { triangles }, inputVertices }: OpenedMesh, corner: number): number {
  return entry(inputVertices, entry(triangles, corner));
}

function isSame(one: Asked, other: Asked): boolean {
  const areSame = one.question.sources === other.question.sources && isSameMoment(one.moment, other.moment);
  return areSame && isSameSurface(one, other);
}

function wishOf(
  opened: OpenedMesh,
  { ground, sources }: Answer['question'],
  { sources: single, sets }: SceneState,
): Omit<CellWish, 'question' | keyof ExactSurface> {
  const places = placesOf(opened, sources);
  const cost = hasCosts(ground) ? openCost(ground) : 1;
  const ofSets = sets.flatMap(({ points }, set) => points.map(() => single.length + set));
  return {
    places,
    initial: Float64Array.from(sources, ({ offset = 0 }) => offset / cost),
    cells: Uint32Array.from([...single.keys(), ...ofSets]),
    count: single.length + sets.length,
  };
}
