import type { Factoring } from '../../protocol';
import type { Engine } from '../../solver/engine';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import { isMethodOf } from '../../state/inside';
import { isSameUnit, type LengthUnit, unitOf } from '../../length';
import { hasWalls } from '../../state/ground';
import { measure } from '../../state/measures';
import { type Bridge, mayBeJoined } from '../../state/scene';
import {
  AUTOMATIC,
  BOUNDARY,
  EXACT_RADIUS_EDGES,
  LINEAR_SOLVER,
  METHOD,
  type Method,
  MULTI_SOURCE,
  OPERATOR,
  type Parameters,
  PATH_KIND,
  type PathKind,
  WINDOWS,
} from '../../wasm/contract';
import { refiningSentence } from '../accuracy';
import { h, say, select } from '../dom';
import { automaticSlider, labelled, reason, toggle } from '../widgets';
import { calmly } from './calm';
import { BOUNDARIES, METHODS, MULTI_SOURCES, OPERATORS, SOLVERS, timeFactor } from '../settings';
import { groupWords } from '../words';
import { count, some, t, type Words } from '../../texts';

const METHOD_HINTS: Record<Method, Words> = {
  auto: t('Propagation at once, then refined to exact unless ground has costs. Nothing is factored.'),
  propagation: t('By a few windows of each half-edge; never below the exact distance. Nothing is factored.'),
  heat: t('Smooth distances from matrices that are factored once; refined to exact unless ground has costs.'),
  exact: t('Propagation at once, then always refined to exact. Nothing is factored.'),
};
/** Inside of tetrahedra there are two. */
const INSIDE_HINT = t(
  'By waves through the tetrahedra: exact where a straight line leads to a source. Nothing is factored.',
);
const PATHS: Record<PathKind, Words> = {
  descent: t('Steepest descent'),
  straight: t('Straightened'),
  exact: t('Shortest, exact'),
};
/** Any other distance is given by the link. */
const BRIDGES: readonly (readonly [Bridge, Words])[] = [
  ['auto', t('Touching or near')],
  [0, t('Touching')],
  ['off', t('None')],
];

/** Method, exactness and path first, then the settings of the method; the less common ones are collapsed. */
export function solverSection(session: Session): HTMLElement {
  const { scene } = session;
  /** The radius in mean edges that the solver chose last. */
  let chosenNear = 0;
  const change = (part: Partial<Parameters>, gesture: object | null = null) =>
    scene.edit({ parameters: { ...scene.state.parameters, ...part } }, gesture);
  const method = select(t('Method'), labelled(METHOD.names, METHODS), (value) => scene.edit({ method: value }));
  const hint = quiet('');
  const refine = toggle(t('Refine to exact'), (on) => scene.edit({ refine: on }));
  const path = select(t('Path'), labelled(PATH_KIND.names, PATHS), (value) => scene.edit({ pathKind: value }));
  const factor = timeFactor((timeStep, gesture) => change({ timeStep }, gesture));
  const boundary = select(t('Boundary'), labelled(BOUNDARY.names, BOUNDARIES), (value) => change({ boundary: value }));
  const [nearest, farthest] = EXACT_RADIUS_EDGES;
  const near = automaticSlider({
    label: t('Exact region'),
    min: nearest,
    max: farthest,
    step: 1,
    describe: (value, automatic) => (value === 0 ? t('off') : automatic ? t`≈ ${value} edges` : t`${value} edges`),
    change: (value, gesture) => change({ exactRadius: value }, gesture),
  });
  const multi = select(t('Multi-source'), labelled(MULTI_SOURCE.names, MULTI_SOURCES), (value) =>
    change({ sources: value }),
  );
  const operator = select(t('Operator'), labelled(OPERATOR.names, OPERATORS), (value) => change({ operator: value }));
  const solver = select(t('Linear solver'), labelled(LINEAR_SOLVER.names, SOLVERS), (value) =>
    change({ solver: value }),
  );
  const windows = select(
    t('Windows'),
    WINDOWS.map((number) => [number, count(number)] as const),
    (value) => scene.edit({ windows: value }),
  );
  const bridge = select(t('Join components'), BRIDGES, (value) => scene.edit({ bridge: value }));
  const linked = quiet('');
  const unlink = h(
    'button',
    { class: 'small', title: t('Takes away all links between groups'), onclick: () => scene.edit({ links: 0 }) },
    t('Unlink'),
  );
  const links = h('div', { class: 'linking' }, linked, unlink);
  const ofHeat = [
    factor.element,
    quiet(t('Heat flows for t = m h², where h is the mean edge length. A larger m gives a smoother distance.')),
    boundary.element,
  ];
  const moreOfHeat = [
    near.element,
    quiet(t('Radius around the sources in which distances are exact at once, in mean edge lengths.')),
    multi.element,
    operator.element,
    solver.element,
  ];
  const moreOfWindows = [
    windows.element,
    quiet(t('Windows that each half-edge keeps. More are nearer to the exact distance, and slower.')),
  ];

  /** Whether the operators of a mesh are the same, once that is known: to find out takes as long as to build one. */
  let compared: { engine: Engine; agree: boolean } | null = null;
  const compareOperators = (engine: Engine) => {
    if (compared?.engine === engine) return;
    const asked = { engine, agree: false };
    compared = asked;
    engine.queries.operatorsAgree().then(
      (agree) => {
        asked.agree = agree;
        if (agree && compared === asked) show();
      },
      // A worker that has ended is told of where it answers.
      () => undefined,
    );
  };

  const show = calmly(session, () => {
    const { parameters, ...state } = scene.state;
    const isByHeat = state.method === 'heat';
    for (const element of [...ofHeat, ...moreOfHeat]) element.hidden = !isByHeat;
    const isInside = (session.shown.value?.opened.interior ?? null) !== null;
    for (const element of moreOfWindows) element.hidden = isByHeat || isInside;
    method.offer((name) => isMethodOf(name, isInside));
    method.show(state.method);
    say(hint, isInside && !isByHeat ? INSIDE_HINT : METHOD_HINTS[state.method]);
    windows.show(state.windows);
    refine.element.hidden = isInside || !(isByHeat || state.method === 'auto');
    path.element.hidden = isInside;
    operator.element.hidden = !isByHeat || isInside;
    refine.show(state.refine);
    path.show(state.pathKind);
    reason(
      path.element,
      isPathExact(session.shown.value) ? t('Distances are exact, so the straightened path is too.') : null,
    );
    const opened = session.shown.value?.opened;
    bridge.element.hidden = !opened || !mayBeJoined(opened);
    bridge.show(state.bridge);
    const { shown } = session;
    const linksNow =
      shown.value && linksSentence(shown.value.answer.factoring, unitOf(scene.state, shown.value.opened));
    say(linked, linksNow);
    links.hidden = linked.textContent === '';
    factor.show(parameters.timeStep, session.shown.value?.answer.field?.timeFactor ?? 1);
    boundary.show(parameters.boundary);
    const isClosed = !isInside && opened?.report.boundaryLoops === 0 && !hasWalls(state.ground);
    reason(boundary.element, isClosed ? t('The surface is closed: all of these are the same.') : null);
    near.show(parameters.exactRadius, chosenNear);
    multi.show(parameters.sources);
    const isAlone = shown.value?.answer.question.sources.length === 1;
    reason(multi.element, isAlone ? t('There is one source.') : null);
    operator.show(parameters.operator);
    // The field of the logarithm is of the Delaunay triangulation alone.
    const isByLogarithm =
      parameters.timeStep === AUTOMATIC && parameters.solver === 'cholesky' && parameters.boundary === 'neumann';
    const isFactored = isByHeat && !isInside && session.engine?.isFactored === true;
    if (session.engine && isFactored && !isByLogarithm) compareOperators(session.engine);
    const isSame = isFactored && !isByLogarithm && compared?.agree === true;
    reason(
      operator.element,
      isSame ? t('All triangles are Delaunay, and none is thin: all of these are the same.') : null,
    );
    solver.show(parameters.solver);
  });
  scene.subscribe((state, previous) => {
    if (
      state.method !== previous.method ||
      state.windows !== previous.windows ||
      state.bridge !== previous.bridge ||
      state.parameters !== previous.parameters ||
      state.pathKind !== previous.pathKind ||
      state.refine !== previous.refine ||
      !isSameUnit(state, previous)
    )
      show();
  });
  session.shown.watch((shown, previous) => {
    const field = shown?.answer.field;
    if (!shown || !field || field === previous?.answer.field) return;
    // What refinement has reached since is not what was chosen, nor what windows reach.
    if (field.refineMs === 0 && field.windows === undefined) {
      const edges = Math.round(field.exactBelow / shown.opened.meanEdge);
      chosenNear = Math.min(Math.max(edges, nearest), farthest);
    }
    show();
  });
  show();

  return h(
    'div',
    { class: 'stack' },
    method.element,
    hint,
    refine.element,
    refiningStatus(session),
    path.element,
    bridge.element,
    links,
    ...ofHeat,
    h(
      'details',
      { class: 'more' },
      h('summary', {}, t('More solver settings')),
      h('div', { class: 'stack' }, ...moreOfHeat, ...moreOfWindows),
    ),
  );
}

/** Whether the straightened path is the shortest one. */
function isPathExact(shown: Shown | null): boolean {
  return shown?.answer.pathKind === 'exact' && shown.answer.question.pathKind === 'straight';
}

function quiet(text: Words): HTMLElement {
  return h('p', { class: 'quiet' }, text);
}

/** How the distance was found and how exact it is, in a sentence. The page announces it once it has come to rest. */
function refiningStatus(session: Session): HTMLElement {
  const status = h('p', { class: 'quiet', role: 'status', 'aria-live': 'off' });
  const show = () => {
    const { phase } = session.refiner;
    const { scene, shown } = session;
    const { answer, opened } = shown.value ?? {};
    const sentence =
      opened && answer?.field
        ? refiningSentence(phase.value, answer.field, scene.state, unitOf(scene.state, opened))
        : '';
    say(status, sentence);
  };
  session.shown.watch(show);
  session.refiner.phase.watch(show);
  session.scene.subscribe((state, previous) => {
    if (!isSameUnit(state, previous)) show();
  });
  return status;
}

/** How many links there are between groups and how far they reach; null without any. */
function linksSentence({ groups, links, linkedGap }: Factoring, unit: LengthUnit): Words | null {
  return some(
    links,
    '{0} link over a gap of {1}; {2}.',
    '{0} links over gaps of up to {1}; {2}.',
    measure(linkedGap, unit),
    groupWords(groups),
  );
}
