/** What a file does not say of itself, unit and upward axis, to be corrected by a tap. Fetched when such a file is opened. */
import { isKnown, ownUnitOf, SHOWN_UNITS } from '../../length';
import type { Session } from '../../session/session';
import { measure } from '../../state/measures';
import { AUTOMATIC, type Up } from '../../wasm/contract';
import { h, say } from '../dom';
import { t, type Words } from '../../texts';

const AXES: readonly (readonly [Up, string])[] = [
  ['y', 'Y'],
  ['z', 'Z'],
];

/** One for all files: "2.84 m across? mm cm m km in ft · up Y Z"; what is taken for right is pressed. */
export function question({ scene, shown }: Session): HTMLElement {
  const length = h('span', { class: 'quiet' });
  const units = SHOWN_UNITS.map((unit) =>
    choice(unit, t`The lengths in the file are in ${unit}`, () => scene.edit({ unit, scale: 1 })),
  );
  const axes = AXES.map(([up, name]) => choice(name, t`${name} points up`, () => scene.edit({ up })));
  const show = () => {
    if (!shown.value) return;
    const { opened, places } = shown.value;
    const { state } = scene;
    const size = measure(places.diameter, { ...ownUnitOf(state, opened), assumed: false });
    say(length, isKnown(ownUnitOf(state, opened)) ? t`${size} across?` : t('In which unit?'));
    units.forEach((button, index) =>
      button.setAttribute('aria-pressed', String(ownUnitOf(state, opened).symbol === SHOWN_UNITS[index])),
    );
    const wanted = state.up === AUTOMATIC ? opened.upright : state.up;
    axes.forEach((button, index) => button.setAttribute('aria-pressed', String(AXES[index]?.[0] === wanted)));
  };
  shown.watch(show);
  scene.subscribe(show);
  return h(
    'div',
    { class: 'questions' },
    group(t('Unit of the file'), length, units),
    group(t('Axis that points up'), h('span', { class: 'quiet' }, t('Up')), axes),
  );
}

function choice(name: Words, title: Words, choose: () => void): HTMLElement {
  return h('button', { class: 'small', title, onclick: choose }, name);
}

function group(name: Words, label: HTMLElement, buttons: readonly HTMLElement[]): HTMLElement {
  return h('div', { class: 'question', role: 'group', 'aria-label': name }, label, ...buttons);
}
