import type { Session } from '../../session/session';
import {
  isRamp,
  LOOK_RANGES,
  lookGradient,
  LOOKS,
  MAPS,
  RAMP_NAMES,
  STYLES,
  SURROUNDINGS,
  WIDEST_LINE,
  type Finish,
  type Look,
  type MapName,
  type RampName,
} from '../../state/looks';
import { h, select, slider, toggle } from '../dom';
import { length, percent } from '../words';

const ONE_COLOUR = 'one colour';

/** What can be shown of a look, and shows it. */
interface Part {
  element: HTMLElement;
  show: (look: Look) => void;
}

/** Gallery of looks, then pattern, colours, materials and light. */
export function lookSection(session: Session): HTMLElement {
  const { scene } = session;
  const change = (part: Partial<Look>) => scene.set({ look: { ...scene.state.look, ...part } });
  const parts: Part[] = [
    gallery((look) => scene.set({ look })),
    pattern(session, change),
    colours(change),
    materials(() => scene.state.look, change),
    light(change),
  ];
  const show = () => {
    for (const part of parts) part.show(scene.state.look);
  };
  scene.subscribe((state, previous) => {
    if (state.look !== previous.look) show();
  });
  session.shown.watch((shown, previous) => {
    if (shown?.opened !== previous?.opened) show();
  });
  show();
  return h('div', { class: 'stack' }, ...parts.map(({ element }) => element));
}

type Change = (part: Partial<Look>) => void;

function gallery(choose: (look: Look) => void): Part {
  const element = h('div', { class: 'looks', role: 'group', 'aria-label': 'Looks' });
  const buttons = LOOKS.map((look) => {
    const swatch = h('span', { class: 'swatch' });
    swatch.style.background = lookGradient(look);
    const button = h('button', { class: 'look', onclick: () => choose(look) }, swatch, h('span', {}, look.name));
    element.append(button);
    return button;
  });
  return {
    element,
    show: ({ name }) =>
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(LOOKS[i].name === name))),
  };
}

function pattern(session: Session, change: Change): Part {
  let lines = false;
  const style = select(
    'Pattern',
    STYLES.map((name) => [name, name] as const),
    (value) => change({ style: value }),
  );
  const period = slider({
    label: 'Period',
    min: 0.005,
    max: 0.25,
    step: 0.005,
    describe: (value) => {
      const diameter = session.shown.value?.places.diameter;
      return diameter ? `${length(value * diameter)} units` : percent(value);
    },
    change: (value) => change({ period: value }),
  });
  const width = slider({
    label: 'Stripe width',
    min: 0,
    max: 1,
    step: 0.02,
    describe: (value) => (lines ? `${(value * WIDEST_LINE).toFixed(1)} px` : percent(value)),
    change: (value) => change({ width: value }),
  });
  const number = (
    label: string,
    key: 'offset' | 'sharpness' | 'relief' | 'flow',
    step: number,
    describe: (value: number) => string,
  ) => {
    const [min, max] = LOOK_RANGES[key];
    const { element, show } = slider({ label, min, max, step, describe, change: (value) => change({ [key]: value }) });
    return { key, element, show };
  };
  const offset = number('Offset', 'offset', 0.02, percent);
  const sharpness = number('Sharpness', 'sharpness', 0.05, percent);
  const relief = number('Relief', 'relief', 0.01, (value) => (value < 0 ? 'groove ' : '') + percent(Math.abs(value)));
  const flow = number('Flow', 'flow', 0.1, (value) => (value === 0 ? 'still' : `${value.toFixed(1)} / s`));
  const bandsOnly = [sharpness.element, relief.element];
  return {
    element: h(
      'div',
      { class: 'stack' },
      style.element,
      period.element,
      width.element,
      offset.element,
      ...bandsOnly,
      flow.element,
    ),
    show: (look) => {
      lines = look.style === 'lines';
      style.show(look.style);
      period.show(look.period);
      width.show(look.width);
      for (const { key, show } of [offset, sharpness, relief, flow]) show(look[key]);
      for (const element of bandsOnly) element.hidden = lines;
    },
  };
}

function colours(change: Change): Part {
  const surface = select<RampName>(
    'Surface',
    RAMP_NAMES.map((name) => [name, name] as const),
    (value) => change({ ramp: value }),
  );
  const colour = h('input', { type: 'color', oninput: () => change({ stripe: colour.value }) });
  const stripes = select<string>(
    'Stripes',
    [ONE_COLOUR, ...RAMP_NAMES].map((name) => [name, name] as const),
    (value) => change({ stripe: value === ONE_COLOUR ? colour.value : value }),
  );
  const own = h('label', { class: 'field' }, h('span', {}, 'Stripe colour'), colour);
  return {
    element: h('div', { class: 'stack' }, surface.element, stripes.element, own),
    show: ({ ramp, stripe }) => {
      surface.show(ramp);
      stripes.show(isRamp(stripe) ? stripe : ONE_COLOUR);
      own.hidden = isRamp(stripe);
      if (!isRamp(stripe)) colour.value = stripe;
    },
  };
}

const MAP_WORDS: Record<MapName, string> = {
  colour: 'Stripes have a colour',
  normal: 'Stripes have a relief',
  emission: 'Stripes glow',
  specular: 'Stripes shine on their own',
};

function materials(current: () => Look, change: Change): Part {
  const maps = MAPS.map((map) => {
    const { element, show } = toggle(MAP_WORDS[map], (on) => {
      const rest = current().maps.filter((other) => other !== map);
      change({ maps: on ? [...rest, map] : rest });
    });
    return { map, element, show };
  });
  const finish = (of: 'surface' | 'stripes', label: string, key: keyof Finish, max: number) => {
    const control = slider({
      label,
      min: 0,
      max,
      step: 0.02,
      describe: percent,
      change: (value) => change({ [of]: { ...current()[of], [key]: value } }),
    });
    return { element: control.element, show: (look: Look) => control.show(look[of][key]) };
  };
  const sliders = [
    finish('surface', 'Surface, metal', 'metalness', 1),
    finish('surface', 'Surface, roughness', 'roughness', 1),
    finish('surface', 'Surface, glow', 'glow', 3),
    finish('stripes', 'Stripes, metal', 'metalness', 1),
    finish('stripes', 'Stripes, roughness', 'roughness', 1),
    finish('stripes', 'Stripes, glow', 'glow', 3),
  ];
  return {
    element: h(
      'details',
      { class: 'more' },
      h('summary', {}, 'Material'),
      h('div', { class: 'stack' }, ...maps.map(({ element }) => element), ...sliders.map(({ element }) => element)),
    ),
    show: (look) => {
      for (const { map, show } of maps) show(look.maps.includes(map));
      for (const { show } of sliders) show(look);
    },
  };
}

function light(change: Change): Part {
  const around = select(
    'Light',
    SURROUNDINGS.map((name) => [name, name] as const),
    (value) => change({ surroundings: value }),
  );
  const [min, max] = LOOK_RANGES.light;
  const turned = slider({
    label: 'Turn the light',
    min,
    max,
    step: 5,
    describe: (value) => `${String(value)}°`,
    change: (value) => change({ light: value }),
  });
  return {
    element: h('div', { class: 'stack' }, around.element, turned.element),
    show: (look) => {
      around.show(look.surroundings);
      turned.show(look.light);
    },
  };
}
