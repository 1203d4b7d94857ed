/** Which source is nearest: colors on the surface, a table of areas, and files of the borders. */
import { Failure } from '../../error';
import type { FoundCells } from '../../protocol';
import { otherSources, whyNoCells } from '../../session/cells';
import type { Session } from '../../session/session';
import { colourOfCell } from '../../state/cells';
import { sendWalker } from '../../state/edit';
import { isWeighted } from '../../state/ground';
import { threeDigits, withUnit } from '../../state/measures';
import type { Overlay } from '../../state/scene';
import { isSameUnit, MODEL, ofModel, toldArea, unitOf } from '../../length';
import { h } from '../dom';
import { finePercent } from '../words';
import { entryAt } from './entries';
import { overlaySwitch } from './overlay';
import { savingCurves } from './saving';
import { count, counted, t, type Words } from '../../texts';

const CELLS: Overlay = 'cells';
const MOST_SPREAD = 1000;
/** Of relaxing: after so many, sources hardly move. */
const ROUNDS = 10;
/** Rows of the table; more are told by a file. */
const MOST_ROWS = 100;

export function cellsControls(session: Session): HTMLElement[] {
  const { scene, shown, cells } = session;
  const on = overlaySwitch(
    session,
    CELLS,
    t('Cells'),
    t('What is nearest to each source, in colors, by exact distances'),
  );
  const table = h('div', {});
  const many = h('input', {
    type: 'number',
    min: 2,
    max: MOST_SPREAD,
    value: 12,
    'aria-label': t('Number of sources'),
  });
  const button = (name: Words, title: Words, work: () => Promise<void>) => {
    const element = h('button', { class: 'small', title }, name);
    element.addEventListener('click', () => {
      element.disabled = true;
      work()
        .catch((error: unknown) => session.fail(error))
        .finally(() => (element.disabled = false));
    });
    return element;
  };
  const spread = button(t('Spread'), t('So many sources, each as far from those before as can be'), async () => {
    const wanted = Math.round(many.valueAsNumber);
    if (!(wanted >= 2 && wanted <= MOST_SPREAD)) throw new Failure(t`Spread 2 to ${count(MOST_SPREAD)} sources.`);
    const sources = await otherSources(session, wanted);
    if (sources) scene.edit({ sources, sets: [], selected: -1 });
  });
  const relax = button(t('Relax'), t('Moves the sources to the middles of their cells, step by step'), async () => {
    const gesture = {};
    for (let round = 0; round < ROUNDS; round++) {
      const sources = await otherSources(session, 'middles');
      if (!sources) return;
      scene.edit({ sources }, gesture);
    }
  });
  const mean = button(
    t('Mean'),
    t('Sends the walker to the mean of the sources: where their squared distances sum to least'),
    async () => {
      const [place] = (await otherSources(session, 'mean')) ?? [];
      if (place) sendWalker(scene, place);
    },
  );
  const spreading = h('div', { class: 'linking' }, many, spread, relax, mean);
  const saving = savingCurves(session, {
    label: t('Borders'),
    button: t('Save borders'),
    title: t('The borders, where another source becomes the nearest one'),
    suffix: 'cells',
    file: (engine, file) => engine.queries.cellFile(file),
  });
  const show = () => {
    on.show(scene.state.overlays.includes(CELLS));
    on.bar(shown.value && whyNoCells(shown.value, scene.state));
    saving.hidden = cells.value === null;
    saving.inert = cells.value?.outdated === true;
    spreading.hidden = shown.value?.opened.interior !== null || isWeighted(shown.value.answer.question.ground);
    mean.hidden = scene.state.sources.length < 2;
    relax.hidden = mean.hidden || scene.state.sets.length > 0;
    table.replaceChildren(...(cells.value ? [tableOf(session, cells.value)] : []));
  };
  cells.watch(show);
  shown.watch(show);
  scene.subscribe((state, previous) => {
    const isOther = state.sources.length !== previous.sources.length || state.sets.length !== previous.sets.length;
    if (isOther || state.overlays !== previous.overlays || !isSameUnit(state, previous)) show();
  });
  show();
  return [spreading, on.element, table, saving];
}

function tableOf({ scene, shown }: Session, { areas }: FoundCells): HTMLElement {
  const opened = shown.value?.opened;
  const unit = opened ? unitOf(scene.state, opened) : MODEL;
  const whole = areas.reduce((sum, area) => sum + area, 0);
  const rows = areas.slice(0, MOST_ROWS).map((area, cell) => {
    const { title } = entryAt(scene.state, cell, opened);
    const mark = h('span', { class: 'pin set', 'aria-hidden': 'true' });
    mark.style.background = colourOfCell(cell);
    const share = finePercent(whole > 0 ? area / whole : 0);
    const numbers = [threeDigits(toldArea(ofModel<2>(area), unit)), share];
    return h('tr', {}, h('th', { scope: 'row' }, mark, ' ', title), ...numbers.map((number) => h('td', {}, number)));
  });
  const area = withUnit(t('Area'), unit.symbol && `${unit.symbol}²`);
  const heads = [t('Nearest source'), area, t('Percentage')].map((head) => h('th', { scope: 'col' }, head));
  return h(
    'table',
    { class: 'rows' },
    h('caption', { class: 'quiet' }, counted(areas.length, '{0} cell', '{0} cells')),
    h('thead', {}, h('tr', {}, ...heads)),
    h('tbody', {}, ...rows),
  );
}
