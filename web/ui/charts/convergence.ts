/** How the errors of heat and propagation fall with the edges, measured on the surface on screen when it is asked for. */
import type { OpenedMesh } from '../../protocol';
import type { Session } from '../../session/session';
import { measureConvergence } from '../../solver/convergence';
import { type Level, levelsOf, markdownOf, MOST_TRIANGLES, slopeOf, studied } from '../../state/convergence';
import { allSources } from '../../state/sources';
import { isSameUnit, type LengthUnit, MODEL, ofModel, told, unitOf } from '../../length';
import { h, say } from '../dom';
import { withUnit } from '../../state/measures';
import { fileNameOf, tenths } from '../words';
import { figure } from './figure';
import { markdownButton, measurement, measuring } from './measuring';
import type { Chart, Series } from './plot';
import { count, t, type Words } from '../../texts';

const TITLES = {
  heat: t('Error of heat'),
  propagation: t('Error of propagation'),
} as const;

export function convergenceStudy(session: Session): HTMLElement {
  const levels: Level[] = [];
  /** Whose levels they are. */
  let measured: OpenedMesh | null = null;
  const charts = h('div', { class: 'stack' });
  const unitNow = () => (measured ? unitOf(session.scene.state, measured) : MODEL);
  const draw = () => {
    const file = fileNameOf(session.shown.value);
    charts.replaceChildren(...chartsOf(levels, unitNow()).map((chart) => figure(chart, file)));
  };

  const measure = async (signal: AbortSignal) => {
    const { scene, shown } = session;
    const sources = allSources(scene.state);
    if (!shown.value || sources.length === 0) return t('Set a source first.');
    const { opened } = shown.value;
    const { surface, drawTransform } = opened;
    const steps = levelsOf(surface.triangles.length / 3);
    [levels.length, measured, progress.max, saving.hidden] = [0, opened, steps, true];
    charts.replaceChildren();
    await measureConvergence(
      studied(opened, sources),
      scene.state,
      signal,
      (done, triangles) => {
        progress.value = done;
        say(said, t`Measuring ${count(triangles)} triangles, ${done + 1} of ${steps}.`);
      },
      (level) => {
        // Drawn, the surface has another size.
        levels.push({ ...level, edge: ofModel(level.edge / drawTransform.scale) });
        draw();
      },
    );
    return t('Done. A slope of 1: half the edge, half the error.');
  };
  const ended = () => (saving.hidden = levels.length === 0);
  const { button, progress, said, cancel } = measuring({
    label: t('Measure convergence'),
    steps: t('Surfaces measured'),
    measure,
    ended,
  });
  const saving = h(
    'div',
    { class: 'saving', hidden: true },
    markdownButton(
      () => markdownOf(levels, unitNow()),
      said,
      t('The clipboard is not available. Save the charts as CSV.'),
    ),
  );
  const most = h('p', { class: 'quiet' }, t`At most ${count(MOST_TRIANGLES / 4)} triangles can be split.`);
  const element = measurement(
    t('Convergence'),
    t(
      'The errors of heat, without an exact region, and of propagation, both by the present settings: on this surface, and on the same one with each triangle split in four, up to twice.',
    ),
    most,
    button,
    progress,
    said,
    charts,
    saving,
  );
  const follow = () => {
    const opened = session.shown.value?.opened ?? null;
    element.hidden = !opened || opened.interior !== null;
    const canBeSplit = opened !== null && levelsOf(opened.surface.triangles.length / 3) > 1;
    [most.hidden, button.hidden] = [canBeSplit, !canBeSplit];
    if (opened !== measured) forget();
  };
  const forget = () => {
    if (!measured) return;
    cancel();
    [levels.length, measured, saving.hidden] = [0, null, true];
    charts.replaceChildren();
    say(said, '');
  };
  session.shown.watch(follow);
  session.scene.subscribe((state, previous) => {
    const { parameters, sources, sets } = state;
    if (parameters !== previous.parameters || sources !== previous.sources || sets !== previous.sets) forget();
    if (!isSameUnit(state, previous) && levels.length > 0) draw();
  });
  follow();
  return element;
}

function chartsOf(levels: readonly Level[], unit: LengthUnit): Chart[] {
  const xLabel = withUnit(t('Mean edge'), unit.symbol);
  return (['heat', 'propagation'] as const).flatMap((method) => {
    // Small surfaces may lie within the exact region, and no logarithm is that of an error of 0.
    const inexact = levels.filter((level) => level[method].mean > 0);
    if (inexact.length === 0) return [];
    const line = (name: Words, errorOf: (level: Level) => number): Series => {
      const slope = slopeOf(inexact, errorOf);
      const title = slope === null ? name : t`${name}, slope ${tenths(Math.round(10 * slope) / 10 || 0)}`;
      const [x, y] = [inexact.map(({ edge }) => told(edge, unit)), inexact.map((level) => 100 * errorOf(level))];
      return { name: title, kind: 'points', x, y };
    };
    const series = [line(t('Maximum'), (level) => level[method].max), line(t('Mean'), (level) => level[method].mean)];
    return [{ title: TITLES[method], xLabel, yLabel: t('Error (%)'), logarithmic: 'both' as const, series }];
  });
}
