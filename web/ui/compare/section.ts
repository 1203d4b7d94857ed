/** The section of comparisons: with what, and the figures of both sides. */
import type { PathKind, DrawPath } from '../../protocol';
import type { Comparison } from '../../session/comparison';
import type { Session } from '../../session/session';
import { type Compared, differing, MIDDLE, settingsOf, STUDIED, type Studied } from '../../state/compared';
import { wantedOf } from '../../session/prepare';
import { type Answer, isSameField, type Question } from '../../solver/engine';
import { measureSides, RUNS, type Side } from '../../solver/sides';
import type { Times } from '../../state/report';
import { isMethodOf } from '../../state/inside';
import { isSameUnit, type LengthUnit, unitOf } from '../../length';
import { Failure } from '../../error';
import { entry } from '../../state/entry';
import type { Settings } from '../../state/settings';
import { BOUNDARY, LINEAR_SOLVER, METHOD, OPERATOR, type Parameters, WINDOWS } from '../../wasm/contract';
import { measuring } from '../charts/measuring';
import { h, say, select } from '../dom';
import { labelled, toggle } from '../widgets';
import { BOUNDARIES, METHODS, OPERATORS, SOLVERS, timeFactor } from '../settings';
import { measure, threeDigits } from '../../state/measures';
import { finePercent, milliseconds } from '../words';
import { difference } from './difference';
import { settingsWords } from './words';
import { count, listed, t, type Words } from '../../texts';

const CHOICES: Record<Studied, Words> = {
  'time-step': t('m = 1 and m = 1000'),
  solver: t('Cholesky and conjugate gradients, m = 100'),
  boundary: t('Neumann and Dirichlet'),
  exact: t('Heat and exact'),
  automatic: t('Heat and automatic'),
};
const INTRODUCTION = t(
  'Two settings on one model: the settings of the section Solver on the left, others on the right.',
);

export function compareSection(session: Session, comparison: Comparison): HTMLElement {
  const { scene } = session;
  const put = (compared: Compared | null, gesture: object | null = null) => scene.edit({ compared }, gesture);
  const change = (part: Partial<Settings>, gesture: object | null = null) => {
    const { compared } = scene.state;
    if (compared) put({ ...compared, ...part }, gesture);
  };
  const changeHeat = (part: Partial<Parameters>, gesture: object | null = null) => {
    const { compared } = scene.state;
    if (compared) change({ parameters: { ...compared.parameters, ...part } }, gesture);
  };

  /** The scene's own settings before a comparison of the report, and those that came with it. */
  let former: { own: Settings; studied: Settings } | null = null;
  /** Whether it goes on as it began. */
  const isAsStudied = ({ studied }: { studied: Settings }) =>
    scene.state.compared !== null && differing(scene.state, studied).length === 0;
  const studied = Object.entries(STUDIED).map(([name, [left, right]]) => ({
    name: name as Studied,
    element: button(CHOICES[name as Studied], () => {
      const own = former && isAsStudied(former) ? former.own : settingsOf(scene.state);
      former = { own, studied: left };
      scene.edit({ ...left, compared: { ...right, split: scene.state.compared?.split ?? MIDDLE } });
    }),
  }));
  const begin = button(t('Other settings'), () => put({ ...settingsOf(scene.state), split: MIDDLE }));
  const swap = button(t('Swap sides'), () => {
    const { compared } = scene.state;
    if (!compared) return;
    const own = settingsOf(scene.state);
    scene.edit({ ...settingsOf(compared), compared: { ...own, split: compared.split } });
  });
  const end = button(t('Stop comparing'), () => {
    scene.edit({ ...(former && isAsStudied(former) ? former.own : {}), compared: null });
    former = null;
  });

  const method = select(t('Method'), labelled(METHOD.names, METHODS), (value) => change({ method: value }));
  const windows = select(
    t('Windows'),
    WINDOWS.map((number) => [number, count(number)] as const),
    (value) => change({ windows: value }),
  );
  const refine = toggle(t('Refine to exact'), (on) => change({ refine: on }));
  const factor = timeFactor((timeStep, gesture) => changeHeat({ timeStep }, gesture));
  const boundary = select(t('Boundary'), labelled(BOUNDARY.names, BOUNDARIES), (value) =>
    changeHeat({ boundary: value }),
  );
  const operator = select(t('Operator'), labelled(OPERATOR.names, OPERATORS), (value) =>
    changeHeat({ operator: value }),
  );
  const solver = select(t('Linear solver'), labelled(LINEAR_SOLVER.names, SOLVERS), (value) =>
    changeHeat({ solver: value }),
  );
  const status = h('p', { class: 'quiet' });
  /** What both sides took, and for what; null until it is measured. */
  let times: { of: readonly [Times, Times]; questions: readonly [Question, Question] } | null = null;
  const sides = (): readonly [Side, Side] | null => {
    const { compared, ...own } = scene.state;
    const [left, right] = [session.shown.value?.answer, comparison.answer.value];
    if (!compared || !left || !right) return null;
    return [
      { wanted: wantedOf(scene.state), question: left.question },
      { wanted: wantedOf({ ...own, ...settingsOf(compared), compared }), question: right.question },
    ];
  };
  const timing = measuring({
    label: t('Measure times'),
    steps: t('Runs of both sides'),
    measure: async (signal) => {
      const { request } = session;
      const both = sides();
      if (!request || !both) throw new Failure(t('There is nothing to compare yet.'));
      times = null;
      timing.progress.max = RUNS;
      const of = await measureSides(request.load, both, signal, (done) => (timing.progress.value = done));
      times = { of, questions: [both[0].question, both[1].question] };
      return t('Each in a worker of its own, after a first run of both; solving is the median of five.');
    },
    ended: () => show(),
  });
  const figures = h('table', { class: 'compare-figures' });
  const settings = [method, windows, refine, factor, boundary, operator, solver];
  const side = h(
    'fieldset',
    { class: 'stack' },
    h('legend', {}, t('Right side')),
    ...settings.map(({ element }) => element),
  );

  const show = () => {
    const { compared } = scene.state;
    const { shown } = session;
    const isInside = (shown.value?.opened.interior ?? null) !== null;
    for (const { name, element } of studied) element.hidden = name === (isInside ? 'exact' : 'automatic');
    begin.hidden = compared !== null;
    for (const each of [swap, end]) each.hidden = compared === null;
    say(status, comparison.working.value ? t('Working on the right side…') : '');
    status.hidden = status.textContent === '';
    const isByHeat = compared?.method === 'heat';
    side.hidden = figures.hidden = compared === null;
    const asked = sides();
    const isTimed = asked?.every(({ question }, at) => times && isSame(entry(times.questions, at), question));
    if (times && !isTimed) {
      times = null;
      say(timing.said, '');
    }
    if (!asked) timing.cancel();
    for (const each of [timing.button, timing.said]) each.hidden = !asked;
    if (!compared) return;
    windows.element.hidden = isByHeat || isInside;
    refine.element.hidden = isInside || !(isByHeat || compared.method === 'auto');
    for (const { element } of [factor, boundary, operator, solver]) element.hidden = !isByHeat;
    operator.element.hidden ||= isInside;
    method.offer((name) => isMethodOf(name, isInside));
    const { timeStep } = compared.parameters;
    method.show(compared.method);
    windows.show(compared.windows);
    refine.show(compared.refine);
    factor.show(timeStep, comparison.answer.value?.field?.timeFactor ?? 1);
    boundary.show(compared.parameters.boundary);
    operator.show(compared.parameters.operator);
    solver.show(compared.parameters.solver);
    if (shown.value) figures.replaceChildren(...table(unitOf(scene.state, shown.value.opened)));
  };

  const table = (unit: LengthUnit): HTMLElement[] => {
    const { compared, ...own } = scene.state;
    const [left, right] = [session.shown.value?.answer, comparison.answer.value];
    if (!compared || !left) return [];
    const keys = differing(own, compared);
    const both = (tell: (answer: NonNullable<typeof left>) => Words) => [left, right].map((one) => one && tell(one));
    const rows: Row[] = [
      ...factors(left, right),
      ...timed(times?.of ?? null),
      [t('Maximum distance'), ...both(({ field }) => (field ? measure(field.maxDistance, unit) : '–'))],
      [t('Path'), ...both(({ path, pathKind }) => pathWords(path, pathKind, unit))],
    ];
    const apart = left.field && right?.field ? difference(left.field, right.field) : null;
    const head = h(
      'tr',
      {},
      h('td'),
      ...[own, compared].map((one) => h('th', { scope: 'col' }, settingsWords(one, keys))),
    );
    return [
      h('thead', {}, head),
      h(
        'tbody',
        {},
        ...rows.map(([name, ...cells]) =>
          h('tr', {}, h('th', { scope: 'row' }, name), ...cells.map((cell) => h('td', {}, cell ?? '–'))),
        ),
        differenceRow(t('Mean difference'), apart?.mean),
        differenceRow(t('Largest difference'), apart?.most),
      ),
    ];
  };

  scene.subscribe((state, previous) => {
    const isOther = settingsDiffer(state, previous) || state.compared !== previous.compared;
    if (isOther || !isSameUnit(state, previous)) show();
  });
  session.shown.watch(show);
  comparison.answer.watch(show);
  comparison.working.watch(show);
  return h(
    'div',
    { class: 'stack' },
    h('p', { class: 'quiet' }, INTRODUCTION),
    ...studied.map(({ element }) => element),
    begin,
    side,
    status,
    figures,
    timing.button,
    timing.progress,
    timing.said,
    swap,
    end,
  );
}

function isSame(measured: Question, asked: Question): boolean {
  return measured.method === asked.method && isSameField(measured, asked);
}

/** A name, and what stands for each side. */
type Row = [Words, ...(Words | null | undefined)[]];

/** The m of t = m h² that heat has flown for. */
function factors(left: Answer, right: Answer | null): Row[] {
  const row = [left, right].map((answer) => answer?.field?.timeFactor ?? null);
  const isByHeat = row.some((factor) => factor !== null);
  return isByHeat ? [[t('Time factor m'), ...row.map((factor) => (factor === null ? null : threeDigits(factor)))]] : [];
}

function timed(times: readonly [Times, Times] | null): Row[] {
  if (!times) return [];
  return [
    [t('Factor'), ...times.map(({ precompute }) => timeOf(precompute))],
    [t('Solve'), ...times.map(({ solve }) => milliseconds(solve))],
  ];
}

function button(text: Words, click: () => void): HTMLElement {
  return h('button', { class: 'wide', onclick: click }, text);
}

function settingsDiffer(one: Settings, other: Settings): boolean {
  return (
    one.method !== other.method ||
    one.windows !== other.windows ||
    one.parameters !== other.parameters ||
    one.refine !== other.refine
  );
}

function timeOf(ms: number): Words {
  return ms > 0 ? milliseconds(ms) : '–';
}

function pathWords(path: DrawPath | null, kind: PathKind, unit: LengthUnit): Words {
  if (!path) return '–';
  const words = measure(path.length, unit);
  return kind === 'exact' ? listed(words, t('exact')) : words;
}

function differenceRow(name: Words, share: number | undefined): HTMLElement {
  const words = share === undefined ? '–' : share === 0 ? threeDigits(0) : finePercent(share);
  return h('tr', {}, h('th', { scope: 'row' }, name), h('td', { colspan: 2 }, words));
}
