/** What the lengths in the file are, and in which unit they are shown. */
import type { Session } from '../../session/session';
import {
  convertible,
  isKnown,
  isSameUnit,
  ofModel,
  ownUnitOf,
  SHOWN_UNITS,
  type ShownUnit,
  type UnitChoice,
  unitOf,
  UNITS,
} from '../../length';
import { measure } from '../../state/measures';
import { AUTOMATIC } from '../../wasm/contract';
import { attribute, h, say, select } from '../dom';
import { sentences, t, type Words } from '../../texts';

/** Lengths are not converted: shown in the unit that they have. */
const OWN = 'own';

/** Two commands: one corrects the size of the model, the other converts the numbers. */
export function unitControls({ scene, shown }: Session): HTMLElement[] {
  const corrections: [UnitChoice, Words][] = [
    [AUTOMATIC, t('automatic')],
    ...UNITS.map((name): [UnitChoice, Words] => [name, name === 'none' ? t('no unit') : name]),
  ];
  const ofFile = () => shown.value?.opened ?? { unit: '', unitAssumed: false };
  const correct = select(t('Correct unit'), corrections, (unit) =>
    scene.edit(convertible({ ...scene.state, unit, scale: 1 }, ofFile())),
  );
  attribute(
    correct.element,
    'title',
    t('Says what the lengths in the file are: numbers stay, and the size of the model changes'),
  );
  const conversions: [ShownUnit | typeof OWN, Words][] = [
    [OWN, t('unit of the file')],
    ...SHOWN_UNITS.map((name): [ShownUnit, Words] => [name, name]),
  ];
  const convert = select(t('Convert to'), conversions, (name) => scene.edit({ shownUnit: name === OWN ? null : name }));
  const [automatic, own] = [correct, convert].map(({ element }) => element.querySelector('option'));
  const size = h('p', { class: 'quiet' });

  const show = () => {
    const { state } = scene;
    const opened = ofFile();
    const before = ownUnitOf({ ...state, unit: AUTOMATIC, scale: 1 }, opened);
    const told = ownUnitOf(state, opened);
    correct.show(state.unit);
    convert.show(state.shownUnit ?? OWN);
    const { symbol, assumed } = before;
    if (automatic)
      say(automatic, symbol ? (assumed ? t`${symbol} (assumed)` : t`${symbol} (of the file)`) : t('automatic (none)'));
    if (own) say(own, told.symbol ? t`${told.symbol} (not converted)` : t('not converted'));
    convert.offer((name) => name === OWN || isKnown(told));
    attribute(
      convert.element,
      'title',
      isKnown(told)
        ? t('The size of the model stays, and all numbers change; files are saved in this unit too')
        : t('Say first what the lengths in the file are'),
    );
    const [diameter, unit] = [shown.value?.places.diameter, unitOf(state, opened)];
    const one = state.scale === 1 ? null : t`A unit of the file is ${measure(ofModel(1), unit)}.`;
    say(size, diameter === undefined ? null : sentences(t`${measure(diameter, unit)} from corner to corner.`, one));
  };
  shown.watch(show);
  scene.subscribe((state, previous) => {
    if (!isSameUnit(state, previous)) show();
  });
  show();
  return [correct.element, convert.element, size];
}
