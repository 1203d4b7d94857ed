/** Charts of the field that is shown: loaded when their section is first expanded. */
import '../../style/charts.css';
import type { Convergence as Residuals, MeshPoint } from '../../protocol';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import type { MeasuredTape } from '../../session/tapes';
import { isSameField, type Question } from '../../solver/engine';
import type { Places } from '../../state/places';
import { distributionOf, errorsByDistance } from '../../state/distribution';
import { type LengthUnit, unitOf } from '../../state/scene';
import { legsOf } from '../../state/tapes';
import { h } from '../dom';
import { arcsOf, pointsOf, positionsOf } from '../measure/curves';
import { percent } from '../words';
import { type CutSurface, straightCut } from './cut';
import { convergenceStudy } from './convergence';
import { figure } from './figure';
import type { Chart, Series } from './plot';
import { table1 } from './table1';
import { t } from '../../texts';

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
      const errors = engine && answer.field?.error ? await engine.errors() : null;
      const isSurface = engine && !opened.interior;
      const walk = isSurface && answer.path ? await engine.pathProfile() : null;
      const tapes = this.#tapes();
      const neighbors = isSurface && tapes.length > 0 ? await engine.neighbors() : null;
      if (wish !== this.#wish) return;
      const unit = unitOf(scene.state, opened);
      const { charts, notes } = chartsOf(shown.value, tapes, { errors, walk, neighbors }, unit);
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
      this.#compared = { question, convergence: await engine.convergence() };
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
function residualChart(title: string, iterated: Float64Array, factored: number): Chart {
  const x = Array.from(iterated, (_, step) => step);
  const series: Series[] = [
    { name: t('Conjugate gradients'), kind: 'line', x, y: iterated },
    { name: t('Cholesky'), kind: 'line', x, y: x.map(() => factored) },
  ];
  return { title, xLabel: t('Steps'), yLabel: t('Residual'), logarithmic: 'up', series };
}

/** What the worker was asked for; null where there is none. */
interface Fetched {
  errors: Float32Array | null;
  walk: Float64Array | null;
  /** The triangles beside each, where there are tapes: see `SolverApi.neighbors`. */
  neighbors: Uint32Array | null;
}

/** What can be drawn, and sentences for what cannot. */
function chartsOf(
  { opened, places, answer }: Shown,
  tapes: readonly MeasuredTape[],
  { errors, walk, neighbors }: Fetched,
  unit: LengthUnit,
): { charts: Chart[]; notes: string[] } {
  const { field, question } = answer;
  if (!field) return { charts: [], notes: [t('Set a source to see how distance is distributed.')] };
  const { scale, symbol } = unit;
  const inUnit = (name: string) => (symbol ? `${name} (${symbol})` : name);
  const xLabel = inUnit(t('Distance'));
  const positions = question.moment ? places.positions : opened.surface.positions;
  const { triangles } = opened.surface;
  const { edges, below, unreached } = distributionOf({ ...field, positions, triangles }, BINS);
  const told = edges.map((edge) => edge * scale);
  const shares = below.map((share) => 100 * share);
  const bars = shares.slice(1).map((share, index) => share - shares[index]);
  const area = t('Area (%)');
  const charts: Chart[] = [
    { title: t('Area by distance'), xLabel, yLabel: area, series: [{ name: area, kind: 'bars', x: told, y: bars }] },
    {
      title: t('Area within a distance'),
      xLabel,
      yLabel: area,
      series: [{ name: area, kind: 'line', x: told, y: shares }],
    },
  ];
  const notes: string[] = [];
  if (unreached > 0) notes.push(t`No source reaches ${percent(unreached)} of the area, which is left out.`);
  if (walk) {
    const [x, y] = [0, 1].map((column) =>
      Array.from({ length: walk.length / 2 }, (_, i) => scale * walk[2 * i + column]),
    );
    const series = [{ name: xLabel, kind: 'line' as const, x, y }];
    charts.push({ title: t('Distance along the path'), xLabel: inUnit(t('Along the path')), yLabel: xLabel, series });
  }
  const valueAt = (point: MeshPoint) => places.valueAt(point, field);
  const along = (title: string, length: string, profile: { x: number[]; y: number[] } | null) => {
    if (!profile) return;
    const series = [{ name: xLabel, kind: 'line' as const, ...profile }];
    charts.push({ title, xLabel: inUnit(length), yLabel: xLabel, series });
  };
  tapes.forEach((tape, index) => {
    const mesh = neighbors && { surface: opened.surface, neighbors };
    const stretch = scale / opened.drawTransform.scale;
    along(t`Distance along tape ${index + 1}`, t('Along the tape'), profileOf(tape, places, valueAt, scale));
    const cut = mesh && cutOf(tape, mesh, places, valueAt, { stretch, scale });
    along(t`Straight cut of tape ${index + 1}`, t('Along the cut'), cut);
  });
  if (tapes.length === 0) notes.push(t('Lay a tape (M) to see the distance along it.'));
  if (errors && !field.byCorner) {
    const { distance, mean, most } = errorsByDistance(errors, field.distance, BINS);
    const x = distance.map((value) => value * scale);
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

/** Distance over the length along a tape; null while its paths are not known, and inside of tetrahedra. */
function profileOf(
  { legs }: MeasuredTape,
  places: Places,
  valueAt: (point: MeshPoint) => number,
  scale: number,
): { x: number[]; y: number[] } | null {
  if (legs.length === 0) return null;
  const [x, y]: [number[], number[]] = [[], []];
  let before = 0;
  for (const { leg } of legs) {
    if (!leg || !('triangles' in leg)) return null;
    const points = pointsOf(leg);
    const arcs = arcsOf(positionsOf(points, places));
    const stretch = leg.length / (arcs[arcs.length - 1] || 1);
    points.forEach((point, i) => {
      x.push(scale * (before + stretch * arcs[i]));
      y.push(scale * valueAt(point));
    });
    before += leg.length;
  }
  return y.every(Number.isFinite) ? { x, y } : null;
}

/** Distance over the length along straight cuts from place to place of a tape; null where they do not lead there. */
function cutOf(
  { tape }: MeasuredTape,
  mesh: CutSurface,
  places: Places,
  valueAt: (point: MeshPoint) => number,
  { stretch, scale }: { stretch: number; scale: number },
): { x: number[]; y: number[] } | null {
  const [x, y]: [number[], number[]] = [[], []];
  let before = 0;
  for (const [from, to] of legsOf(tape)) {
    const cut = straightCut(mesh, places, from, to);
    if (!cut) return null;
    x.push(...cut.arcs.map((arc) => before + stretch * arc));
    y.push(...cut.points.map((point) => scale * valueAt(point)));
    before = x[x.length - 1];
  }
  return x.length > 0 && y.every(Number.isFinite) ? { x, y } : null;
}
