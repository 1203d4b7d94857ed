/** The table of tapes: lengths of their legs, areas, a known length that sets the scale, and all of it as CSV. */
import type { Session } from '../../session/session';
import { lengthOf, type MeasuredTape, stateOf, straightOf, type Tapes } from '../../session/tapes';
import {
  convertible,
  isSameUnit,
  type LengthUnit,
  type ModelLength,
  ofModel,
  told,
  type UnitChoice,
  unitOf,
  UNITS,
} from '../../length';
import { SCALES } from '../../state/tapes';
import { AUTOMATIC } from '../../wasm/contract';
import { save } from '../../view/picture';
import { copy } from '../clipboard';
import { h, say, select } from '../dom';
import { withUnit } from '../../state/measures';
import { fileNameOf } from '../words';
import { csvOf, enclosureWords, lengthNumber, lengthWords, ratioWords, STATE_WORDS } from './words';
import { t, type Words } from '../../texts';

export function tapesTable(session: Session, tapes: Tapes): HTMLElement {
  const { scene, shown } = session;
  const list = h('div', { class: 'stack' });
  const said = h('span', { class: 'quiet', role: 'status' });
  const csv = () => csvOf(tapes.measured.value, unitNow());
  const unitNow = () => unitOf(scene.state, shown.value?.opened ?? { unit: '', unitAssumed: false });
  const copyAll = async () => {
    const isCopied = await copy(csv());
    say(said, isCopied ? t('Copied.') : t('The clipboard is not available. Save the file instead.'));
  };
  const saveFile = () => save(new Blob([csv()], { type: 'text/csv' }), `${fileNameOf(shown.value)} tapes.csv`);
  const buttons = h(
    'div',
    { class: 'openers' },
    h('button', { class: 'small', title: t('Copy all lengths as CSV'), onclick: () => void copyAll() }, t('Copy CSV')),
    h('button', { class: 'small', title: t('Save all lengths as a CSV file'), onclick: saveFile }, t('Save CSV')),
    h(
      'button',
      { class: 'small', title: t('Delete all tapes'), onclick: () => scene.edit({ tapes: [] }) },
      t('Delete all'),
    ),
  );
  let cards: Card[] = [];
  const show = () => {
    const measured = tapes.measured.value;
    if (cards.length !== measured.length) {
      const focused = cards.findIndex(({ element }) => element.contains(document.activeElement));
      cards = measured.map((_, index) => card(session, index));
      list.replaceChildren(...cards.map(({ element }) => element));
      // Whoever deletes one goes on with the next.
      if (focused >= 0)
        cards[Math.min(focused, cards.length - 1)]?.element.querySelector<HTMLElement>('.small')?.focus();
    }
    measured.forEach((each, index) => cards[index]?.show(each, unitNow()));
    list.hidden = buttons.hidden = measured.length === 0;
    say(said, '');
  };
  tapes.measured.watch(show);
  scene.subscribe((state, previous) => {
    if (!isSameUnit(state, previous)) show();
  });
  return h('div', { class: 'stack' }, list, buttons, said);
}

interface Card {
  element: HTMLElement;
  show: (measured: MeasuredTape, unit: LengthUnit) => void;
}

function card(session: Session, index: number): Card {
  const { scene } = session;
  const title = t`Tape ${index + 1}`;
  const total = h('span', { class: 'value' });
  const body = h('tbody');
  const note = h('p', { class: 'quiet', hidden: true });
  const remove = () => scene.edit({ tapes: scene.state.tapes.toSpliced(index, 1) });
  const head = h(
    'div',
    { class: 'tape-head' },
    h('span', {}, title),
    total,
    h(
      'button',
      { class: 'small', title: t('Delete this tape'), 'aria-label': t`Delete tape ${index + 1}`, onclick: remove },
      '×',
    ),
  );
  const titles = h('tr');
  const table = h('table', { class: 'tape-legs', 'aria-label': title }, h('thead', {}, titles), body);
  const known = knownLength(session, index);
  return {
    element: h('section', { class: 'tape', 'aria-label': title }, head, table, note, known.element),
    show: (measured, unit) => {
      const { legs } = measured;
      const sum = lengthOf(measured);
      say(total, legs.length > 0 ? lengthWords(sum, stateOf(measured), unit) : t('one place so far'));
      table.hidden = legs.length === 0;
      const inUnit = (name: Words) => withUnit(name, unit.symbol);
      const isInside = legs.some(({ leg }) => leg && 'points' in leg);
      const names = [t('Leg'), inUnit(isInside ? t('Path') : t('Surface')), inUnit(t('Straight')), t('Ratio')];
      titles.replaceChildren(...names.map((name) => h('th', { scope: 'col' }, name)));
      const rows = legs.map(({ leg, state, straight }, k) =>
        row(String(k + 1), leg?.length ?? ofModel(NaN), straight, state, unit),
      );
      if (legs.length > 1) rows.push(row('Σ', sum, straightOf(measured), stateOf(measured), unit));
      body.replaceChildren(...rows);
      say(note, enclosureWords(measured, unit));
      note.hidden = !note.textContent;
      known.show(sum, unit);
    },
  };
}

function row(
  name: string,
  surface: ModelLength,
  straight: ModelLength,
  state: keyof typeof STATE_WORDS,
  unit: LengthUnit,
): HTMLElement {
  return h(
    'tr',
    {},
    h('th', { scope: 'row' }, name),
    h('td', {}, lengthNumber(surface, state, unit), h('span', { class: 'quiet' }, STATE_WORDS[state])),
    h('td', {}, lengthNumber(straight, 'exact', unit)),
    h('td', {}, ratioWords(straight, surface)),
  );
}

/** A field for the true length of a tape, which sets the scale of all lengths. */
function knownLength(
  session: Session,
  index: number,
): { element: HTMLElement; show: (length: ModelLength, unit: LengthUnit) => void } {
  const { scene, shown } = session;
  let measured = ofModel(NaN);
  let chosen: UnitChoice = 'm';
  const field = h('input', { type: 'number', min: 0, step: 'any', 'aria-label': t`Known length of tape ${index + 1}` });
  const unit = select(
    t('Unit of the known length'),
    UNITS.map((name) => [name, name === 'none' ? t('units') : name] as const),
    (value) => (chosen = value),
  );
  const trouble = h('p', { class: 'quiet', role: 'status' });
  const set = h(
    'button',
    {
      class: 'small',
      title: t('Corrects the size of the model, so that this tape has that length'),
      onclick: () => {
        const scale = field.valueAsNumber / measured;
        const isKnown = scale >= SCALES[0] && scale <= SCALES[1];
        say(trouble, isKnown ? null : t('Give the length of this tape, a number above 0.'));
        if (!isKnown || !shown.value) return;
        const { shownUnit } = scene.state;
        scene.edit(convertible({ scale, unit: chosen, shownUnit }, shown.value.opened));
      },
    },
    t('Set scale'),
  );
  const reset = h(
    'button',
    {
      class: 'small',
      title: t('Takes lengths as the file has them'),
      onclick: () => {
        const units = { ...scene.state, scale: 1, unit: AUTOMATIC } as const;
        if (shown.value) scene.edit(convertible(units, shown.value.opened));
      },
    },
    t('Reset'),
  );
  const element = h(
    'div',
    { class: 'known' },
    h('span', { class: 'quiet' }, t('Known length')),
    field,
    unit.element,
    set,
    reset,
    trouble,
  );
  return {
    element,
    show: (length, now) => {
      measured = length;
      element.hidden = !(length > 0);
      reset.hidden = scene.state.scale === 1;
      if (field !== document.activeElement) {
        field.value = length > 0 ? String(Number(told(length, now).toPrecision(4))) : '';
        chosen = UNITS.find((name) => name === now.symbol) ?? 'm';
        unit.show(chosen);
      }
    },
  };
}
