import type { Session } from '../../session/session';
import type { Shown } from '../../session/prepare';
import type { Signal } from '../../state/signal';
import {
  HEADINGS,
  isRefined,
  LARGEST_CROWD,
  OF_HEAT,
  type Overlay,
  OVERLAYS,
  type SceneState,
} from '../../state/scene';
import { AUTOMATIC, UP, type Up, VERTEX_FIELD, type VertexField } from '../../wasm/contract';
import { available } from '../../session/overlays';
import { attribute, h, say, select } from '../dom';
import { labelled, radios, reason, slider, toggle } from '../widgets';
import { calmly } from './calm';
import { KEYS, withKey } from '../keys';
import { hasCosts, hasWalls } from '../../state/ground';
import { finePercent } from '../words';
import { tells } from '../../state/styles';
import { count, sentences, t, type Words } from '../../texts';

const OVERLAY_WORDS: Record<Overlay, Words> = {
  scenery: t('Inactive parts (scenery)'),
  joined: t('Surface in the place of points'),
  edges: t('Mesh edges'),
  boundary: t('Boundary edges'),
  contacts: t('Contacts'),
  operator: t('Operator edges'),
  isolines: t('Isolines'),
  cells: t('Cells'),
  curves: t('Distance from curves'),
  loops: t('Loops around handles'),
  loop: t('Loop through the sources'),
  bezier: t('Bézier curve of the sources'),
  carried: t('Carried from the sources'),
  heat: t('Heat gradient'),
  distance: t('Distance gradient'),
};
/** Of these there is one at a time. */
const ARROWS = ['heat', 'distance', 'carried'] as const satisfies readonly Overlay[];
type Arrows = (typeof ARROWS)[number] | 'none';

/** Those that other sections have. */
const ELSEWHERE: ReadonlySet<Overlay> = new Set(['cells', 'curves', 'loops', 'loop', 'bezier']);

const COLOR_BY_WORDS: Record<VertexField, Words> = {
  distance: t('distance'),
  heat: t('heat, log scale'),
  error: t('unrefined error'),
};

const UP_WORDS: Record<Up, string> = { y: '+Y', z: '+Z', x: '+X', '-y': '−Y', '-z': '−Z', '-x': '−X' };

/** Steps of the slider, which grows as the square: few walkers are chosen as finely as many. */
const CROWD_STEPS = 100;

/** Which field the surface is colored by, which overlays are drawn, the size of the crowd, and which axis points up. */
export function displaySection(session: Session, isLegendOn: Signal<boolean>): HTMLElement {
  const { scene } = session;
  const colorBy = select(t('Color by'), labelled(VERTEX_FIELD.names, COLOR_BY_WORDS), (value) =>
    scene.edit({ colorBy: value }),
  );
  const up = select<Up | typeof AUTOMATIC>(
    t('Up'),
    [[AUTOMATIC, t('automatic')], ...labelled(UP.names, UP_WORDS)],
    (value) => scene.edit({ up: value }),
  );
  attribute(up.element, 'title', t('The axis of the file that points up (U: the next one)'));
  const cameras = camerasControl(session);
  const lights = toggle(t('Lights of the file'), (on) => scene.edit({ lights: on ? 'file' : 'style' }));
  const legend = h('p', { class: 'quiet', role: 'status' });
  const without = (gone: readonly Overlay[]) => scene.state.overlays.filter((overlay) => !gone.includes(overlay));
  const overlays = OVERLAYS.filter((overlay) => !isArrows(overlay) && !ELSEWHERE.has(overlay)).map((overlay) => {
    const { element, show, bar } = toggle(OVERLAY_WORDS[overlay], (on) => {
      const rest = without([overlay]);
      scene.edit({ overlays: on ? [...rest, overlay] : rest });
    });
    return { overlay, element, show, bar };
  });
  const arrows = radios<Arrows>(
    t('Arrows'),
    [['none', t('No arrows')], ...labelled(ARROWS, OVERLAY_WORDS)],
    (chosen) => {
      const rest = without(ARROWS);
      scene.edit({ overlays: chosen === 'none' ? rest : [...rest, chosen] });
    },
  );
  const heading = slider({
    label: t('Heading'),
    min: HEADINGS[0],
    max: HEADINGS[1],
    step: 1,
    describe: (value) => `${Math.round(value)}°`,
    change: (value, gesture) => scene.edit({ heading: value }, gesture),
  });
  const crowd = slider({
    label: t('Crowd'),
    min: 0,
    max: CROWD_STEPS,
    step: 1,
    // A link may ask for a number between two steps.
    describe: () => (scene.state.crowd === 0 ? t('nobody') : count(scene.state.crowd)),
    change: (value, gesture) => scene.edit({ crowd: walkersAt(value) }, gesture),
  });
  const onStage = toggle(t('Legend'), (on) => (isLegendOn.value = on));
  attribute(
    onStage.element,
    'title',
    withKey(t('What the colors mean, a scale bar and the axes of the file'), KEYS.legend),
  );
  isLegendOn.watch(onStage.show);
  const showLegend = () => {
    say(legend, legendOf(session, scene.state));
    legend.hidden = legend.textContent === '';
  };
  const show = calmly(session, () => {
    const { colorBy: shown, overlays: drawn, method } = scene.state;
    colorBy.offer((field) => method === 'heat' || !OF_HEAT.colorBy.includes(field));
    colorBy.show(shown);
    up.show(scene.state.up);
    lights.show(scene.state.lights === 'file');
    lights.element.hidden = (session.shown.value?.opened.lights.length ?? 0) === 0;
    for (const { overlay, element, show: showToggle, bar } of overlays) {
      const why = session.shown.value && whyNothing(overlay, session.shown.value);
      // What is on at first can be switched on again.
      if (overlay === 'scenery') reason(element, why);
      else bar(why);
      element.hidden =
        (method !== 'heat' && OF_HEAT.overlays.includes(overlay)) ||
        (overlay === 'joined' && !session.shown.value?.opened.isCloud);
      showToggle(drawn.includes(overlay));
    }
    const { overlays: shownOverlays } = available(scene.state, method);
    arrows.offer((name) => method === 'heat' || name === 'none' || !OF_HEAT.overlays.includes(name));
    const isCarried = shownOverlays.includes('carried');
    arrows.show(isCarried ? 'carried' : (ARROWS.find((name) => shownOverlays.includes(name)) ?? 'none'));
    heading.show(scene.state.heading);
    heading.element.hidden = !isCarried;
    crowd.show(Math.round(CROWD_STEPS * Math.sqrt(scene.state.crowd / LARGEST_CROWD)));
    showLegend();
  });
  scene.subscribe(show);
  session.shown.watch((shown) => {
    show();
    const automatic = up.element.querySelector('option');
    if (shown && automatic) say(automatic, t`automatic (${UP_WORDS[shown.opened.upright]})`);
  });
  show();
  return h(
    'div',
    { class: 'stack' },
    colorBy.element,
    legend,
    onStage.element,
    ...overlays.map(({ element }) => element),
    arrows.element,
    heading.element,
    crowd.element,
    up.element,
    cameras,
    lights.element,
  );
}

/** Why an overlay shows nothing; null: it shows something. */
function whyNothing(overlay: Overlay, { opened, answer }: Shown): Words | null {
  const { report, interior, scenery } = opened;
  const { contacts, links } = answer.factoring;
  if (overlay === 'scenery' && scenery.length === 0) return t('All parts are active.');
  if (overlay === 'joined' && !opened.surface.discs)
    return t('So many points are drawn as the surface that joins them.');
  if (overlay === 'boundary' && report.boundaryLoops === 0 && !hasWalls(answer.question.ground))
    return t('The surface is closed.');
  if (overlay === 'contacts' && contacts + links === 0) return t('Nothing touches or is linked.');
  if (overlay === 'isolines' && interior) return t('Isolines are on surfaces alone.');
  return null;
}

function isArrows(overlay: Overlay): boolean {
  return ARROWS.some((name) => name === overlay);
}

/** Where a file has cameras, goes to one of them. */
function camerasControl(session: Session): HTMLElement {
  const views = h('select', {
    onchange: () => {
      const camera = session.shown.value?.opened.cameras[views.selectedIndex - 1];
      views.selectedIndex = 0;
      if (!camera) return;
      const { view, scene } = session;
      view.camera = [...camera.view];
      scene.set({ camera: view.camera });
    },
  });
  const element = h('label', { class: 'field' }, h('span', {}, t('Cameras of the file')), views);
  session.shown.watch((shown, previous) => {
    if (shown && shown !== previous && shown.opened === previous?.opened) return;
    const cameras = shown?.opened.cameras ?? [];
    element.hidden = cameras.length === 0;
    views.replaceChildren(h('option', {}, t('Go to…')), ...cameras.map(({ name }) => h('option', {}, name)));
  });
  return element;
}

function walkersAt(step: number): number {
  return Math.round(LARGEST_CROWD * (step / CROWD_STEPS) ** 2);
}

function whyNoError({ scene, shown }: Session): Words {
  if (shown.value && hasCosts(shown.value.answer.question.ground))
    return t('Where costs differ no distance is exact, and the error is not known.');
  return isRefined(scene.state)
    ? t('The error is known once all distances are exact.')
    : t('The error is known once all distances are exact: switch "Refine to exact" on, by the heat method.');
}

function legendOf(session: Session, { colorBy, method, style }: SceneState): Words {
  const error = session.shown.value?.answer.field?.error;
  if (method !== 'heat' && OF_HEAT.colorBy.includes(colorBy))
    return t('Only the heat method has heat; distance is shown.');
  if (colorBy === 'distance') return '';
  if (colorBy === 'error' && !error) return whyNoError(session);
  const scale =
    colorBy === 'heat' || !error
      ? t('Log scale, from the hottest vertex to the coldest.')
      : t`Relative error: mean ${finePercent(error.mean)}; the color scale ends at the maximum, ${finePercent(error.max)}.`;
  // That a choice of colors changes nothing is to be known where it is made.
  return sentences(
    scale,
    tells(style) ? null : t('Its colors are those of viridis: those of the style do not tell values apart.'),
  );
}
