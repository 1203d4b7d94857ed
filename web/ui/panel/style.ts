import type { Session } from '../../session/session';
import {
  BLENDS,
  isRamp,
  STYLE_RANGES,
  styleGradient,
  STYLES,
  MAPS,
  RAMP_NAMES,
  PATTERNS,
  SURROUNDINGS,
  WIDEST_LINE,
  type Blend,
  type Finish,
  type Style,
  type MapName,
  type RampName,
} from '../../state/styles';
import { isSameUnit, ofModel, unitOf } from '../../length';
import { h, select } from '../dom';
import { labelled, reason, slider, toggle } from '../widgets';
import { measure } from '../../state/measures';
import { percent, tenths } from '../words';
import { t, type Words } from '../../texts';

const SINGLE_COLOR = 'single color';
const OF_FILE = "the file's materials";

/** A group of controls that shows a style. */
interface Part {
  element: HTMLElement;
  show: (style: Style) => void;
}

/** Gallery of preset styles, then pattern, colors, materials and lighting. */
export function styleSection(session: Session): HTMLElement {
  const { scene } = session;
  const change: Change = (part, gesture = null) => scene.edit({ style: { ...scene.state.style, ...part } }, gesture);
  const parts: Part[] = [
    gallery((style) => scene.edit({ style })),
    patternControls(session, change),
    colours(session, change),
    materials(() => scene.state.style, change),
    light(change),
  ];
  const show = () => {
    for (const part of parts) part.show(scene.state.style);
  };
  scene.subscribe((state, previous) => {
    if (state.style !== previous.style || !isSameUnit(state, previous)) show();
  });
  session.shown.watch((shown, previous) => {
    if (shown?.opened !== previous?.opened) show();
  });
  show();
  return h('div', { class: 'stack' }, ...parts.map(({ element }) => element));
}

type Change = (part: Partial<Style>, gesture?: object | null) => void;

function gallery(choose: (style: Style) => void): Part {
  const element = h('div', { class: 'styles', role: 'group', 'aria-label': t('Preset styles') });
  const buttons = STYLES.map((preset) => {
    const swatch = h('span', { class: 'swatch' });
    swatch.style.background = styleGradient(preset);
    const button = h(
      'button',
      { class: 'style', onclick: () => choose(preset) },
      swatch,
      h('span', {}, t(preset.name)),
    );
    element.append(button);
    return button;
  });
  return {
    element,
    show: ({ name }) =>
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(STYLES[i]?.name === name))),
  };
}

function patternControls(session: Session, change: Change): Part {
  let lines = false;
  const pattern = select(
    t('Pattern'),
    PATTERNS.map((name) => [name, t(name)] as const),
    (value) => change({ pattern: value }),
  );
  const period = slider({
    label: t('Period'),
    min: 0.005,
    max: 0.25,
    step: 0.005,
    describe: (value) => {
      const shown = session.shown.value;
      return shown?.places.diameter
        ? measure(ofModel(value * shown.places.diameter), unitOf(session.scene.state, shown.opened))
        : percent(value);
    },
    change: (value, gesture) => change({ period: value }, gesture),
  });
  const width = slider({
    label: t('Stripe width'),
    min: 0,
    max: 1,
    step: 0.02,
    describe: (value) => (lines ? t`${tenths(value * WIDEST_LINE)} px` : percent(value)),
    change: (value, gesture) => change({ width: value }, gesture),
  });
  const number = (
    label: Words,
    key: 'offset' | 'sharpness' | 'relief' | 'flow',
    step: number,
    describe: (value: number) => Words,
  ) => {
    const [min, max] = STYLE_RANGES[key];
    const { element, show } = slider({
      label,
      min,
      max,
      step,
      describe,
      change: (value, gesture) => change({ [key]: value }, gesture),
    });
    return { key, element, show };
  };
  const offset = number(t('Offset'), 'offset', 0.02, percent);
  const sharpness = number(t('Sharpness'), 'sharpness', 0.05, percent);
  const relief = number(t('Relief'), 'relief', 0.01, (value) =>
    value < 0 ? t`groove ${percent(-value)}` : percent(value),
  );
  const flow = number(t('Flow'), 'flow', 0.1, (value) => (value === 0 ? t('still') : t`${tenths(value)} / s`));
  const bandsOnly = [sharpness.element, relief.element];
  const patterned = [period.element, width.element, offset.element, flow.element];
  return {
    element: h(
      'div',
      { class: 'stack' },
      pattern.element,
      period.element,
      width.element,
      offset.element,
      ...bandsOnly,
      flow.element,
    ),
    show: (style) => {
      lines = style.pattern === 'lines';
      pattern.show(style.pattern);
      period.show(style.period);
      width.show(style.width);
      for (const { key, show } of [offset, sharpness, relief, flow]) show(style[key]);
      for (const element of bandsOnly) element.hidden = style.pattern !== 'bands';
      for (const element of patterned) element.hidden = style.pattern === 'none';
    },
  };
}

function colours(session: Session, change: Change): Part {
  const surface = select<RampName | typeof OF_FILE>(
    t('Surface'),
    ([OF_FILE, ...RAMP_NAMES] as const).map((name) => [name, t(name)] as const),
    (value) => change(value === OF_FILE ? { surfaceOf: 'file' } : { surfaceOf: 'style', ramp: value }),
  );
  const blend = select(t('Stripes lie'), labelled(BLENDS, BLEND_WORDS), (value) => change({ blend: value }));
  /** What is tried out until the color is chosen. */
  let trying = {};
  const colour = h('input', {
    type: 'color',
    oninput: () => change({ stripe: colour.value }, trying),
    onchange: () => {
      trying = {};
    },
  });
  const stripes = select<string>(
    t('Stripes'),
    [SINGLE_COLOR, ...RAMP_NAMES].map((name) => [name, t(name)] as const),
    (value) => change({ stripe: value === SINGLE_COLOR ? colour.value : value }),
  );
  const own = h('label', { class: 'field' }, h('span', {}, t('Stripe color')), colour);
  return {
    element: h('div', { class: 'stack' }, surface.element, blend.element, stripes.element, own),
    show: ({ pattern, surfaceOf, blend: chosen, ramp, stripe }) => {
      reason(stripes.element, pattern === 'none' ? NO_STRIPES : null);
      const hasMaterials = Boolean(session.shown.value?.opened.appearance);
      const isOfFile = surfaceOf === 'file' && hasMaterials;
      surface.show(isOfFile ? OF_FILE : ramp);
      surface.offer((value) => value !== OF_FILE || hasMaterials);
      blend.show(chosen);
      blend.element.hidden = !isOfFile;
      stripes.show(isRamp(stripe) ? stripe : SINGLE_COLOR);
      own.hidden = isRamp(stripe);
      if (!isRamp(stripe)) colour.value = stripe;
    },
  };
}

const NO_STRIPES = t('There are no stripes.');

const BLEND_WORDS: Record<Blend, Words> = {
  contrast: t('over, standing out'),
  over: t('over the materials'),
  multiply: t('multiplied with them'),
};

const MAP_WORDS: Record<MapName, Words> = {
  colour: t('Color'),
  normal: t('Normal'),
  emission: t('Emission'),
  specular: t('Specular (separate stripe material)'),
};

function materials(current: () => Style, change: Change): Part {
  const maps = MAPS.map((map) => {
    const { element, show } = toggle(MAP_WORDS[map], (on) => {
      const rest = current().maps.filter((other) => other !== map);
      change({ maps: on ? [...rest, map] : rest });
    });
    return { map, element, show };
  });
  const finish = (of: 'surface' | 'stripes', label: Words, key: keyof Finish, max: number) => {
    const control = slider({
      label,
      min: 0,
      max,
      step: 0.02,
      describe: percent,
      change: (value, gesture) => change({ [of]: { ...current()[of], [key]: value } }, gesture),
    });
    return { element: control.element, show: (style: Style) => control.show(style[of][key]) };
  };
  const sliders = [
    finish('surface', t('Surface metalness'), 'metalness', 1),
    finish('surface', t('Surface roughness'), 'roughness', 1),
    finish('surface', t('Surface emission'), 'glow', 3),
    finish('stripes', t('Stripe metalness'), 'metalness', 1),
    finish('stripes', t('Stripe roughness'), 'roughness', 1),
    finish('stripes', t('Stripe emission'), 'glow', 3),
  ];
  return {
    element: h(
      'details',
      { class: 'more' },
      h('summary', {}, t('Material')),
      h(
        'div',
        { class: 'stack' },
        h('p', { class: 'quiet' }, t('Stripes change:')),
        ...maps.map(({ element }) => element),
        ...sliders.map(({ element }) => element),
      ),
    ),
    show: (style) => {
      for (const { map, element, show } of maps) {
        show(style.maps.includes(map));
        reason(element, whyNothing(map, style));
      }
      for (const { show } of sliders) show(style);
    },
  };
}

/** Why a map of the stripes shows nothing; null: it shows something. */
function whyNothing(map: MapName, { pattern, relief, surface, stripes }: Style): Words | null {
  const isSame = (key: keyof Finish) => surface[key] === stripes[key];
  if (pattern === 'none') return NO_STRIPES;
  if (map === 'normal' && (pattern !== 'bands' || relief === 0)) return t('The stripes have no relief.');
  if (map === 'emission' && isSame('glow')) return t('Stripes and surface glow alike.');
  if (map === 'specular' && isSame('metalness') && isSame('roughness')) return t('Stripes and surface shine alike.');
  return null;
}

function light(change: Change): Part {
  const around = select(
    t('Lighting'),
    SURROUNDINGS.map((name) => [name, t(name)] as const),
    (value) => change({ surroundings: value }),
  );
  const [min, max] = STYLE_RANGES.light;
  const rotation = slider({
    label: t('Rotate lighting'),
    min,
    max,
    step: 5,
    describe: (value) => `${String(value)}°`,
    change: (value, gesture) => change({ light: value }, gesture),
  });
  return {
    element: h('div', { class: 'stack' }, around.element, rotation.element),
    show: (style) => {
      around.show(style.surroundings);
      rotation.show(style.light);
    },
  };
}
