import type { Opener } from '../../session/opener';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import { asSentence } from '../../error';
import { lookInto } from '../../state/edit';
import { isSameUnit, type LengthUnit, unitOf } from '../../length';
import { anglesOf, CUTS, DEFAULT_FILL, FILLS, type Inside, INSIDE_RANGES, LEAST_SPACING } from '../../state/inside';
import { attribute, h, say, select } from '../dom';
import { labelled, slider, toggle } from '../widgets';
import { KEYS, keyName } from '../keys';
import { volume } from '../../state/measures';
import { finePercent, percent, seconds, tenths, tetrahedraWords } from '../words';
import { count, retold, sentences, some, t, type Words } from '../../texts';

const CUT_WORDS: Record<Inside['cut'], Words> = { none: t('nothing'), plane: t('half'), wedge: t('a wedge') };

/** Steps of the slider of tetrahedra for a factor of ten. */
const FILL_STEPS = 20;
/** Digits of the numbers that it gives. */
const FILL_DIGITS = 2;
/** Milliseconds that a tetrahedron takes to be made in a tab, before any has been. */
const MS_PER_TETRAHEDRON = 0.01;

const EMPTY = t('A closed surface can be filled: distance then leads through its inside.');

/** Fills a surface with tetrahedra, and looks into them. */
export function insideSection(session: Session, opener: Opener): HTMLElement {
  const { scene, view } = session;
  let pace = MS_PER_TETRAHEDRON;
  let wanted = DEFAULT_FILL;
  const amount = slider({
    label: t('Tetrahedra'),
    min: FILL_STEPS * Math.log10(FILLS[0]),
    max: FILL_STEPS * Math.log10(FILLS[1]),
    step: 1,
    describe: (step) => t`${count(fillAt(step))}, about ${seconds(pace * fillAt(step))}`,
    change: (step) => {
      wanted = fillAt(step);
    },
  });
  const fill = h('button', { class: 'small', onclick: () => void opener.fill(wanted) }, t('Fill the inside'));
  const empty = h('button', { class: 'small', onclick: () => void opener.fill(null) }, t('Show the surface'));
  const report = h('p', { class: 'quiet', role: 'status' });

  const choose = (part: Partial<Inside>) => lookInto(scene, part, {});
  const number = (key: keyof typeof INSIDE_RANGES, label: Words, step: number, describe: (value: number) => Words) => {
    const [min, max] = INSIDE_RANGES[key];
    const change = (value: number, gesture: object) => lookInto(scene, { [key]: value }, gesture);
    return slider({ label, min, max, step, describe, change });
  };
  const cut = select<Inside['cut']>(t('Cut away'), labelled(CUTS, CUT_WORDS), (value) => choose({ cut: value }));
  attribute(cut.element, 'title', keyName(KEYS.cut));
  const place = number('place', t('Position'), 0.01, (value) => (value === 0 ? t('middle') : percent(value)));
  attribute(place.element, 'title', t('Comma and full stop move it'));
  const turn = number('turn', t('Turn'), 1, (value) => `${value}°`);
  const tilt = number('tilt', t('Tilt'), 1, (value) => `${value}°`);
  const opening = number('opening', t('Opening'), 1, (value) => `${value}°`);
  const face = h(
    'button',
    {
      class: 'small',
      title: t('Turns what is cut away towards the camera'),
      onclick: () => {
        const [yaw = 0, pitch = 0] = view.camera ?? [];
        choose(anglesOf([Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)]));
      },
    },
    t('Face the camera'),
  );
  const whole = toggle(t('Whole tetrahedra'), (on) => choose({ whole: on }));
  const gap = number('gap', t('Pull apart'), 0.05, (value) => (value === 0 ? t('together') : percent(value)));
  const spacing = slider({
    label: t('Shells'),
    min: INSIDE_RANGES.spacing[0],
    max: INSIDE_RANGES.spacing[1],
    step: LEAST_SPACING,
    describe: (value) => (value === 0 ? t('none') : t`every ${percent(value)} of the largest distance`),
    change: (value, gesture) => lookInto(scene, { spacing: value }, gesture),
  });
  const arrows = toggle(t('Arrows inside'), (on) => choose({ arrows: on }));
  const looking = h(
    'div',
    { class: 'stack' },
    cut.element,
    place.element,
    turn.element,
    tilt.element,
    opening.element,
    h('div', { class: 'linking' }, face),
    whole.element,
    gap.element,
    spacing.element,
    arrows.element,
  );

  const showInside = ({ inside }: { inside: Inside }) => {
    const isCut = inside.cut !== 'none';
    cut.show(inside.cut);
    for (const { element } of [place, turn, tilt]) element.hidden = !isCut;
    face.hidden = !isCut;
    opening.element.hidden = inside.cut !== 'wedge';
    place.show(inside.place);
    turn.show(inside.turn);
    tilt.show(inside.tilt);
    opening.show(inside.opening);
    whole.show(inside.whole);
    gap.show(inside.gap);
    spacing.show(inside.spacing);
    arrows.show(inside.arrows);
  };
  const showFill = ({ fill: filled }: { fill: number | null }) => {
    if (filled !== null) wanted = filled;
    amount.show(Math.round(FILL_STEPS * Math.log10(wanted)));
  };
  scene.subscribe((state, previous) => {
    if (state.inside !== previous.inside) showInside(state);
    if (state.fill !== previous.fill) showFill(state);
  });
  const showReport = () => {
    const shown = session.shown.value;
    if (shown) say(report, reportOf(shown, unitOf(scene.state, shown.opened), scene.state.mesh.kind !== 'preset'));
  };
  scene.subscribe((state, previous) => {
    if (state.mesh !== previous.mesh || !isSameUnit(state, previous)) showReport();
  });
  session.shown.watch((shown, previous) => {
    if (!shown || shown.opened === previous?.opened) return;
    const { interior } = shown.opened;
    const isFilled = interior?.report.isFilled ?? false;
    if (interior && isFilled) {
      pace = interior.madeMs / interior.report.tetrahedra;
    }
    showFill(scene.state);
    for (const element of [amount.element, fill]) element.hidden = interior !== null && !isFilled;
    say(fill, isFilled ? t('Fill anew') : t('Fill the inside'));
    empty.hidden = !isFilled;
    looking.hidden = !interior;
    showReport();
    showInside(scene.state);
  });
  showInside(scene.state);
  return h('div', { class: 'stack' }, amount.element, h('div', { class: 'linking' }, fill, empty), report, looking);
}

/** What tetrahedra there are, and what was repaired of those of a file. */
function reportOf({ opened, places }: Shown, unit: LengthUnit, isFile: boolean): Words {
  if (!opened.interior) return EMPTY;
  const { report, madeMs } = opened.interior;
  const deviation = t`Their boundary is within ${finePercent(report.deviation / places.diameter)} of the diagonal of the surface; its sharp corners may be cut by more.`;
  return sentences(
    t`${tetrahedraWords(report)} with dihedral angles from ${tenths(report.leastAngle)}° to ${tenths(report.largestAngle)}°, made in ${seconds(madeMs)}; volume ${volume(report.volume, unit)}.`,
    report.isFilled ? deviation : null,
    some(report.holes, '{0} hole of the surface was closed.', '{0} holes of the surface were closed.'),
    some(
      report.leftOut,
      '{0} without volume or twice there was left out.',
      '{0} without volume or twice there were left out.',
    ),
    isFile ? some(report.turned, '{0} inside out was turned.', '{0} inside out were turned.') : null,
    report.remark ? asSentence(retold(report.remark)) : null,
  );
}

function fillAt(step: number): number {
  return Number((10 ** (step / FILL_STEPS)).toPrecision(FILL_DIGITS));
}
