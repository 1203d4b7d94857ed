/** Charts of the field that is shown: loaded when their section is first expanded. */
import '../../style/charts.css';
import type { Convergence as Residuals, MeshPoint } from '../../protocol';
import type { Shown } from '../../session/prepare';
import { exactDistances } from '../../session/distances';
import type { Session } from '../../session/session';
import type { MeasuredTape } from '../../session/tapes';
import { isSameField, type Question } from '../../solver/engine';
import type { Places } from '../../state/places';
import { hasCosts } from '../../state/ground';
import { distributionOf, errorsByDistance } from '../../state/distribution';
import { type LengthUnit, type ModelLength, ofModel, told, unitOf } from '../../length';
import { legsOf } from '../../state/tapes';
import { h } from '../dom';
import { vectorsIn } from '../../state/vector';
import { arcsOf, pointsOf, positionsOf } from '../measure/curves';
import { withUnit } from '../../state/measures';
import { percent } from '../words';
import { type CutSurface, straightCut } from './cut';
import { convergenceStudy } from './convergence';
import { figure } from './figure';
import type { Chart, Series } from './plot';
import { table1 } from './table1';
import { t, type Words } from '../../texts';
import { entry } from '../../state/entry';

const BINS = 40;
/** Fields follow one another faster than charts are read. */
const PAUSE_MS = 250;

export class Charts {
  readonly element = h('div', { class: 'stack' });
  readonly #session: Session;
  readonly #tapes: () => readonly MeasuredTape[];
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Counts what was asked for: what comes late is dropped. */
  #wish = 0;
  readonly #charts = h('div', { class: 'stack' });
  readonly #compare = h('button', { class: 'wide' }, t('Compare linear solvers'));
  /** Residuals of both linear solvers, and of which question. */
  #compared: { question: Question; convergence: Residuals } | null = null;

  constructor(session: Session, tapes: () => readonly MeasuredTape[]) {
    this.#session = session;
    this.#tapes = tapes;
    this.#compare.addEventListener('click', () => void this.#compareSolvers());
    this.element.append(this.#charts, this.#compare, convergenceStudy(session), table1());
  }

  /** Draws what is shown now, soon. */
  update(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#draw(), PAUSE_MS);
  }

  async #draw(): Promise<void> {
    const wish = ++this.#wish;
    const { shown, scene, engine } = this.#session;
    if (!shown.value) return;
    const { answer, opened } = shown.value;
    this.#compare.hidden = !answer.field || answer.question.method !== 'heat' || opened.interior !== null;
    try {
      const errors = engine && answer.field?.error ? await engine.queries.errors() : null;
      const isSurface = engine && !opened.interior;
      const walk = isSurface && answer.path ? await engine.queries.pathProfile() : null;
      const tapes = this.#tapes();
      const neighbors = isSurface && tapes.length > 0 ? await engine.queries.neighbors() : null;
      if (wish !== this.#wish) return;
      const unit = unitOf(scene.state, opened);
      const lines = opened.interior ? [] : linesOf(shown.value, tapes, neighbors, unit);
      const distances = await distancesOf(this.#session, lines);
      if (wish !== this.#wish) return;
      const { charts, notes } = chartsOf(shown.value, { errors, walk, lines, distances }, unit);
      if (answer.field && tapes.length === 0) notes.push(t('Lay a tape (M) to see the distance along it.'));
      const { question, convergence } = this.#compared ?? {};
      if (convergence && question && isSameField(question, answer.question))
        charts.push(...residualCharts(convergence));
      const name = opened.name.replace(/\.\w+$/, '');
      this.#charts.replaceChildren(
        ...charts.map((chart) => figure(chart, name)),
        ...notes.map((note) => h('p', { class: 'quiet' }, note)),
      );
    } catch (error) {
      this.#session.fail(error);
    }
  }

  async #compareSolvers(): Promise<void> {
    const { shown, engine } = this.#session;
    const question = shown.value?.answer.question;
    if (!engine || !question) return;
    this.#compare.disabled = true;
    try {
      this.#compared = { question, convergence: await engine.inTurn.convergence() };
      this.update();
    } catch (error) {
      this.#session.fail(error);
    } finally {
      this.#compare.disabled = false;
    }
  }
}

/** Residuals of both systems of the heat method. */
function residualCharts({ heat, poisson, heatFactored, poissonFactored }: Residuals): Chart[] {
  return [
    residualChart(t('Heat system'), heat, heatFactored),
    residualChart(t('Poisson system'), poisson, poissonFactored),
  ];
}

/** Over the steps of conjugate gradients, with that of the one Cholesky solve beside them. */
function residualChart(title: Words, iterated: Float64Array, factored: number): Chart {
  const x = Array.from(iterated, (_, step) => step);
  const series: Series[] = [
    { name: t('Conjugate gradients'), kind: 'line', x, y: iterated },
    { name: t('Cholesky'), kind: 'line', x, y: x.map(() => factored) },
  ];
  return { title, xLabel: t('Steps'), yLabel: t('Residual'), logarithmic: 'up', series };
}

/** Places, and how far along a line each is, in the unit shown. */
interface Profile {
  x: number[];
  points: MeshPoint[];
}

/** A line along which distance is drawn; `length` names the way along it. */
interface Line extends Profile {
  title: Words;
  length: Words;
}

/** What the worker was asked for; null where there is none. */
interface Fetched {
  errors: Float32Array | null;
  walk: Float64Array | null;
  lines: readonly Line[];
  /** Exact distances along the lines, as far as they are known. */
  distances: ReadonlyMap<MeshPoint, ModelLength>;
}

/** What can be drawn, and sentences for what cannot. */
function chartsOf(
  { opened, places, answer }: Shown,
  { errors, walk, lines, distances }: Fetched,
  unit: LengthUnit,
): { charts: Chart[]; notes: Words[] } {
  const { field, path, question } = answer;
  if (!field) return { charts: [], notes: [t('Set a source to see how distance is distributed.')] };
  const inUnit = (name: Words) => withUnit(name, unit.symbol);
  const isCost = hasCosts(question.ground);
  const xLabel = inUnit(isCost ? t('Least cost') : t('Distance'));
  const positions = question.moment ? places.positions : opened.surface.positions;
  const { triangles } = opened.surface;
  const { edges, below, unreached } = distributionOf({ ...field, positions, triangles }, BINS);
  const bounds = edges.map((edge) => told(ofModel(edge), unit));
  const shares = below.map((share) => 100 * share);
  const bars = shares.slice(1).map((share, index) => share - entry(shares, index));
  const area = t('Area (%)');
  const charts: Chart[] = [
    {
      title: isCost ? t('Area by least cost') : t('Area by distance'),
      xLabel,
      yLabel: area,
      series: [{ name: area, kind: 'bars', x: bounds, y: bars }],
    },
    {
      title: isCost ? t('Area within a cost') : t('Area within a distance'),
      xLabel,
      yLabel: area,
      series: [{ name: area, kind: 'line', x: bounds, y: shares }],
    },
  ];
  const notes: Words[] = [];
  if (unreached > 0) notes.push(t`No source reaches ${percent(unreached)} of the area, which is left out.`);
  if (walk) {
    const column = (of: number) =>
      Array.from(
        walk.filter((_, i) => i % 2 === of),
        (value) => told(ofModel(value), unit),
      );
    const series = [{ name: xLabel, kind: 'line' as const, x: column(0), y: column(1) }];
    charts.push({
      title: isCost ? t('Least cost along the path') : t('Distance along the path'),
      xLabel: inUnit(t('Along the path')),
      yLabel: xLabel,
      series,
    });
  }
  if (path && opened.isTerrain) {
    const track = vectorsIn(path.places);
    const inFile = (length: number) => told(ofModel(length), unit);
    charts.push({
      title: t('Height along the path'),
      xLabel: inUnit(t('Along the path')),
      yLabel: inUnit(t('Height')),
      series: [
        {
          name: t('Height'),
          kind: 'line',
          x: arcsOf(track).map(inFile),
          y: track.map(([, , height]) => inFile(height)),
        },
      ],
    });
  }
  for (const { title, length, x, points } of lines) {
    const y = points.map((point) => told(distances.get(point) ?? places.valueAt(point, field), unit));
    if (!y.every(Number.isFinite)) continue;
    charts.push({ title, xLabel: inUnit(length), yLabel: xLabel, series: [{ name: xLabel, kind: 'line', x, y }] });
  }
  if (errors && !field.byCorner) {
    const { distance, mean, most } = errorsByDistance(errors, field.distance, BINS);
    const x = distance.map((value) => told(ofModel(value), unit));
    const series = [
      { name: t('Maximum'), kind: 'line' as const, x, y: inPercent(most) },
      { name: t('Mean'), kind: 'line' as const, x, y: inPercent(mean) },
    ];
    charts.push({ title: t('Error before refinement'), xLabel, yLabel: t('Error (%)'), series });
  } else notes.push(t('The error is known once all distances have been made exact from another method.'));
  return { charts, notes };
}

function inPercent(shares: readonly number[]): number[] {
  return shares.map((share) => 100 * share);
}

/** Along tapes, and along straight cuts from place to place of each. */
function linesOf(
  { opened, places }: Shown,
  tapes: readonly MeasuredTape[],
  neighbors: Uint32Array | null,
  unit: LengthUnit,
): Line[] {
  const mesh = neighbors && { surface: opened.surface, neighbors };
  const stretch = told(ofModel(1 / opened.drawTransform.scale), unit);
  return tapes.flatMap((tape, index) => {
    const along = profileOf(tape, places, unit);
    const cut = mesh && cutOf(tape, mesh, places, stretch);
    return [
      ...(along ? [{ title: t`Distance along tape ${index + 1}`, length: t('Along the tape'), ...along }] : []),
      ...(cut ? [{ title: t`Straight cut of tape ${index + 1}`, length: t('Along the cut'), ...cut }] : []),
    ];
  });
}

/** Exact distances of the places of lines that lie in faces; none where these are not known. */
async function distancesOf(session: Session, lines: readonly Line[]): Promise<Map<MeshPoint, ModelLength>> {
  const points = lines.flatMap((line) => line.points);
  const distances = points.length > 0 ? await exactDistances(session, points) : null;
  return new Map(distances ? points.map((point, index) => [point, entry(distances, index)]) : []);
}

/** Places over the length along a tape; null while its paths are not known, and inside of tetrahedra. */
function profileOf({ legs }: MeasuredTape, places: Places, unit: LengthUnit): Profile | null {
  if (legs.length === 0) return null;
  const [x, points]: [number[], MeshPoint[]] = [[], []];
  let before = 0;
  for (const { leg } of legs) {
    if (!leg || !('triangles' in leg)) return null;
    const passed = pointsOf(leg);
    const arcs = arcsOf(positionsOf(passed, places));
    const stretch = leg.length / (arcs[arcs.length - 1] || 1);
    x.push(...arcs.map((arc) => told(ofModel(before + stretch * arc), unit)));
    points.push(...passed);
    before += leg.length;
  }
  return { x, points };
}

/** Places over the length along straight cuts from place to place of a tape; null where they do not lead there. */
function cutOf({ tape }: MeasuredTape, mesh: CutSurface, places: Places, stretch: number): Profile | null {
  const [x, points]: [number[], MeshPoint[]] = [[], []];
  let before = 0;
  for (const [from, to] of legsOf(tape)) {
    const cut = straightCut(mesh, places, from, to);
    if (!cut) return null;
    x.push(...cut.arcs.map((arc) => before + stretch * arc));
    points.push(...cut.points);
    before = x.at(-1) ?? before;
  }
  return x.length > 0 ? { x, points } : null;
}
