import { lookGradient, LOOKS, RAMP_NAMES, type Look, type RampName } from '../looks';
import type { Session } from '../session';
import { length, percent } from '../words';
import { h, select, slider } from './dom';

/** Gallery of looks, then period, width and colours. */
export function lookSection(session: Session): HTMLElement {
  const { scene } = session;
  const change = (part: Partial<Look>) => scene.set({ look: { ...scene.state.look, ...part } });
  const gallery = h('div', { class: 'looks', role: 'group', 'aria-label': 'Looks' });
  const buttons = LOOKS.map((look) => {
    const swatch = h('span', { class: 'swatch' });
    swatch.style.background = lookGradient(look);
    const button = h('button', { class: 'look', onclick: () => scene.set({ look }) }, swatch, h('span', {}, look.name));
    gallery.append(button);
    return button;
  });
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
    describe: percent,
    change: (value) => change({ width: value }),
  });
  const ramp = select<RampName>(
    'Ramp',
    RAMP_NAMES.map((name) => [name, name] as const),
    (value) => change({ ramp: value }),
  );
  const stripe = h('input', { type: 'color', oninput: () => change({ stripe: stripe.value }) });

  const show = () => {
    const { look } = scene.state;
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(LOOKS[i].name === look.name)));
    period.show(look.period);
    width.show(look.width);
    ramp.show(look.ramp);
    stripe.value = look.stripe;
  };
  scene.subscribe((state, previous) => {
    if (state.look !== previous.look) show();
  });
  session.shown.watch((shown, previous) => {
    if (shown?.opened !== previous?.opened) show();
  });
  show();
  return h(
    'div',
    { class: 'stack' },
    gallery,
    period.element,
    width.element,
    ramp.element,
    h('label', { class: 'field' }, h('span', {}, 'Stripe colour'), stripe),
  );
}
