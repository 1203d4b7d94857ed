/** What settings are chosen by, but for lists: sliders, switches and radio buttons, of which the first picture needs none. */
import { attribute, type Choice, h, say } from './dom';
import { t, type Words } from '../texts';

export interface SliderOptions {
  label: Words;
  min: number;
  max: number;
  step: number;
  /** In words, beside the slider. */
  describe: (value: number) => Words;
  /** Each drag is a gesture of its own, and so is each key. */
  change: (value: number, gesture: object) => void;
}

export interface Control {
  element: HTMLElement;
  show: (value: number) => void;
}

export function slider({ label, min, max, step, describe, change }: SliderOptions): Control {
  // The slider says its value itself.
  const output = h('span', { class: 'value', 'aria-hidden': 'true' });
  let gesture = {};
  const input = h('input', {
    type: 'range',
    min,
    max,
    step,
    'aria-label': label,
    oninput: () => {
      show(input.valueAsNumber);
      change(input.valueAsNumber, gesture);
    },
    onchange: () => {
      gesture = {};
    },
  });
  const show = (value: number) => {
    if (input.valueAsNumber !== value) input.valueAsNumber = value;
    say(output, describe(value));
    attribute(input, 'aria-valuetext', describe(value));
  };
  return { element: h('div', { class: 'field' }, h('span', { 'aria-hidden': 'true' }, label), output, input), show };
}

/** Says below a setting why changing it shows nothing now; null: it does show. */
export function reason(field: HTMLElement, why: Words | null): void {
  let told = field.querySelector('small');
  if (!told) field.append((told = h('small', { class: 'quiet' })));
  say(told, why);
  told.hidden = why === null;
}

/** Names with what is said of each, as `select` takes them. */
export function labelled<T extends string>(
  names: readonly T[],
  labels: Readonly<Record<T, Words>>,
): (readonly [T, Words])[] {
  return names.map((name) => [name, labels[name]]);
}

export function toggle(
  label: Words,
  change: (on: boolean) => void,
): {
  element: HTMLElement;
  show: (on: boolean) => void;
  /** Why it would show nothing, switched on; null: it would. What is on can be switched off all the same. */
  bar: (why: Words | null) => void;
} {
  const input = h('input', { type: 'checkbox', role: 'switch', onchange: () => change(input.checked) });
  const element = h('label', { class: 'field' }, h('span', {}, label), input);
  let isBarred = false;
  return {
    element,
    show: (on) => {
      input.checked = on;
      input.disabled = isBarred && !on;
    },
    bar: (why) => {
      isBarred = why !== null;
      input.disabled = isBarred && !input.checked;
      reason(element, why);
    },
  };
}

/** Choices that exclude each other, as radio buttons in a group of that name. */
export function radios<T extends string>(
  label: Words,
  choices: readonly (readonly [T, Words])[],
  change: (value: T) => void,
): Choice<T> {
  const name = `radios-${++groups}`;
  const options = choices.map(([value, text]) => {
    const input = h('input', { type: 'radio', name, onchange: () => change(value) });
    return { value, input, element: h('label', { class: 'field' }, h('span', {}, text), input) };
  });
  return {
    element: h('fieldset', { class: 'radios' }, h('legend', {}, label), ...options.map(({ element }) => element)),
    show: (shown) => options.forEach(({ value, input }) => (input.checked = value === shown)),
    offer: (isOffered) => options.forEach(({ value, element }) => (element.hidden = !isOffered(value))),
  };
}

/** Groups of radio buttons so far. */
let groups = 0;

export interface AutomaticSliderOptions extends Omit<SliderOptions, 'change' | 'describe'> {
  describe: (value: number, automatic: boolean) => Words;
  change: (value: number | 'auto', gesture: object) => void;
}

export interface AutomaticControl {
  element: HTMLElement;
  /** `chosen` is what "auto" comes to. */
  show: (value: number | 'auto', chosen: number) => void;
}

/** A slider with a button that leaves the choice to the solver; to take hold of the slider takes the choice back. */
export function automaticSlider({ change, describe, ...options }: AutomaticSliderOptions): AutomaticControl {
  let automatic = false;
  let taken = options.min;
  const { element, show } = slider({ ...options, describe: (value) => describe(value, automatic), change });
  const button = h(
    'button',
    {
      class: 'small',
      'aria-label': t`Auto: ${options.label}`,
      title: t('Let the solver choose'),
      onclick: () => change(automatic ? taken : 'auto', {}),
    },
    t('Auto'),
  );
  element.classList.add('automatic');
  element.querySelector('.value')?.after(button);
  return {
    element,
    show: (value, chosen) => {
      automatic = value === 'auto';
      taken = value === 'auto' ? chosen : value;
      button.setAttribute('aria-pressed', String(automatic));
      show(taken);
    },
  };
}
