/** Charts of the field that is shown: loaded when their section is first expanded. */
import '../../style/charts.css';
import type { MeshPoint } from '../../protocol';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import type { MeasuredTape } from '../../session/tapes';
import type { Places } from '../../state/places';
import { distributionOf, errorsByDistance } from '../../state/distribution';
import { type LengthUnit, unitOf } from '../../state/scene';
import { save } from '../../view/picture';
import { h } from '../dom';
import { arcsOf, pointsOf, positionsOf } from '../measure/curves';
import { percent } from '../words';
import { type Chart, csvOf, plot, svgFile, THEMED } from './plot';

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

  constructor(session: Session, tapes: () => readonly MeasuredTape[]) {
    this.#session = session;
    this.#tapes = tapes;
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
    try {
      const errors = engine && answer.field?.error ? await engine.errors() : null;
      if (wish !== this.#wish) return;
      const unit = unitOf(scene.state, opened);
      const { charts, notes } = chartsOf(shown.value, this.#tapes(), errors, unit);
      const name = opened.name.replace(/\.\w+$/, '');
      this.element.replaceChildren(
        ...charts.map((chart) => figure(chart, name)),
        ...notes.map((note) => h('p', { class: 'quiet' }, note)),
      );
    } catch (error) {
      this.#session.fail(error);
    }
  }
}

/** What can be drawn, and sentences for what cannot. */
function chartsOf(
  { opened, places, answer }: Shown,
  tapes: readonly MeasuredTape[],
  errors: Float32Array | null,
  unit: LengthUnit,
): { charts: Chart[]; notes: string[] } {
  const { field, question } = answer;
  if (!field) return { charts: [], notes: ['Set a source to see how distance is distributed.'] };
  const { scale, symbol } = unit;
  const inUnit = (name: string) => (symbol ? `${name} (${symbol})` : name);
  const xLabel = inUnit('Distance');
  const positions = question.moment ? places.positions : opened.surface.positions;
  const { triangles } = opened.surface;
  const { edges, below, unreached } = distributionOf({ ...field, positions, triangles }, BINS);
  const told = edges.map((edge) => edge * scale);
  const shares = below.map((share) => 100 * share);
  const bars = shares.slice(1).map((share, index) => share - shares[index]);
  const area = 'Area (%)';
  const charts: Chart[] = [
    { title: 'Area by distance', xLabel, yLabel: area, series: [{ name: area, kind: 'bars', x: told, y: bars }] },
    {
      title: 'Area within a distance',
      xLabel,
      yLabel: area,
      series: [{ name: area, kind: 'line', x: told, y: shares }],
    },
  ];
  const notes: string[] = [];
  if (unreached > 0) notes.push(`No source reaches ${percent(unreached)} of the area, which is left out.`);
  tapes.forEach((tape, index) => {
    const profile = profileOf(tape, places, (point) => places.valueAt(point, field), scale);
    if (!profile) return;
    const series = [{ name: xLabel, kind: 'line' as const, ...profile }];
    charts.push({
      title: `Distance along tape ${index + 1}`,
      xLabel: inUnit('Along the tape'),
      yLabel: xLabel,
      series,
    });
  });
  if (tapes.length === 0) notes.push('Lay a tape (M) to see the distance along it.');
  if (errors && !field.byCorner) {
    const { distance, mean, most } = errorsByDistance(errors, field.distance, BINS);
    const x = distance.map((value) => value * scale);
    const inPercent = (values: readonly number[]) => values.map((value) => 100 * value);
    const series = [
      { name: 'Maximum', kind: 'line' as const, x, y: inPercent(most) },
      { name: 'Mean', kind: 'line' as const, x, y: inPercent(mean) },
    ];
    charts.push({ title: 'Error before refinement', xLabel, yLabel: 'Error (%)', series });
  } else notes.push('The error is known once all distances have been made exact from another method.');
  return { charts, notes };
}

/** Distance over the length along a tape; null while its paths are not known. */
function profileOf(
  { legs }: MeasuredTape,
  places: Places,
  valueAt: (point: MeshPoint) => number,
  scale: number,
): { x: number[]; y: number[] } | null {
  if (legs.length === 0 || legs.some(({ leg }) => !leg)) return null;
  const [x, y]: [number[], number[]] = [[], []];
  let before = 0;
  for (const { leg } of legs) {
    if (!leg) return null;
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

/** A chart with the buttons that save it. */
function figure(chart: Chart, name: string): HTMLElement {
  const file = `${name} ${chart.title.toLowerCase()}`;
  const button = (kind: 'SVG' | 'CSV', blob: () => Blob) =>
    h(
      'button',
      {
        class: 'small',
        'aria-label': `Save ${chart.title} as ${kind}`,
        onclick: () => save(blob(), `${file}.${kind.toLowerCase()}`),
      },
      kind,
    );
  return h(
    'figure',
    { class: 'chart' },
    plot(chart, THEMED),
    h(
      'div',
      {},
      button('SVG', () => svgFile(chart)),
      button('CSV', () => new Blob([csvOf(chart)], { type: 'text/csv' })),
    ),
  );
}
