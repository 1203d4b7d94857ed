/** What is nearest to each source: asks for it, and shows it as colors with borders. Loaded when it is first wanted. */
import type { CellWish, ExactSurface, FoundCells, OpenedMesh, Source, SpreadWish } from '../protocol';
import type { Answer } from '../solver/engine';
import { hasCosts, openCost, isWeighted } from '../state/ground';
import { entry } from '../state/entry';
import type { SceneState } from '../state/scene';
import { allSources, withOffset } from '../state/sources';
import type { Vector } from '../state/vector';
import { colouredCells } from '../view/cells';
import { RIM } from '../view/layers';
import { layPatches } from '../view/patches';
import { Beside } from './beside';
import { type Asked as OnSurface, isMoving, isSameSurface, placesOf, surfaceOf } from './exact';
import type { Shown } from './prepare';
import type { Session } from './session';
import { t, type Words } from '../texts';

const BORDER = { colour: RIM, width: 2 } as const;
const FIRST = Float64Array.of(1, 0, 0);

/** What cells depend on. */
interface Asked extends OnSurface {
  question: Answer['question'];
  shown: Shown;
}

export class Cells extends Beside<Asked, FoundCells> {
  #question = 0;

  protected get wanted(): Asked | null | undefined {
    const { engine, shown, scene, pose } = this.session;
    const { value } = shown;
    if (!scene.state.overlays.includes('cells') || !engine || !value || isMoving(this.session)) return null;
    const { question } = value.answer;
    if (question.quick || whyNoCells(value, scene.state)) return null;
    // Another answer is on its way.
    if (allSources(scene.state) !== question.sources) return undefined;
    return { engine, question, moment: pose.value, shown: value };
  }

  protected isSame(one: Asked, other: Asked): boolean {
    return one.question.sources === other.question.sources && isSameSurface(one, other);
  }

  protected async find(asked: Asked, isWanted: () => boolean): Promise<FoundCells | null> {
    const { opened } = asked.shown;
    const wish = wishOf(opened, asked.question, this.session.scene.state);
    this.#question += 1;
    const whole = { ...wish, ...surfaceOf(opened, asked), question: this.#question };
    while (isWanted()) {
      const found = await asked.engine.inTurn.cells(whole);
      if (found) return found;
    }
    return null;
  }

  protected show(found: FoundCells | null): void {
    const { view, shown, cells } = this.session;
    const { opened, places } = shown.value ?? {};
    const patches =
      found && opened && places
        ? colouredCells(opened.surface, places.drawn, found, places.drawnDiameter, opened.report.boundaryLoops > 0)
        : null;
    layPatches(view, 'cells', patches);
    view.setEdges('cells', found ? [{ ...BORDER, ends: found.ends }] : []);
    cells.value = found;
  }

  protected override outdate(): void {
    const { cells } = this.session;
    if (cells.value) cells.value = { ...cells.value, outdated: true };
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
  const { engine, shown, scene, pose } = session;
  if (!engine || !shown.value) return null;
  const { opened, answer } = shown.value;
  const asked = { engine, question: answer.question, moment: pose.value };
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
