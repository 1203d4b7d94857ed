/** Which source is nearest: colors on the surface, a table of areas, and files of the borders. */
import { Failure } from '../../error';
import type { CurveFile, FoundCells } from '../../protocol';
import { whyNoCells } from '../../session/cells';
import { towardEye } from '../../session/export';
import type { Session } from '../../session/session';
import { colourOfCell } from '../../state/cells';
import { threeDigits, withUnit } from '../../state/measures';
import type { Overlay } from '../../state/scene';
import { isKnown, isSameUnit, MODEL, ofModel, toldArea, unitOf, unitOfFile } from '../../length';
import { save } from '../../view/picture';
import { attribute, h, select } from '../dom';
import { toggle } from '../widgets';
import { fileNameOf, finePercent } from '../words';
import { entryAt } from './sources';
import { counted, t, type Words } from '../../texts';

const CELLS: Overlay = 'cells';
type Kind = Extract<CurveFile['kind'], 'dxf' | 'obj' | 'svg' | 'pdf' | 'csv' | 'glb'>;
const FILES: readonly (readonly [Kind, Words])[] = [
  ['dxf', t('Borders, DXF')],
  ['obj', t('Borders, OBJ')],
  ['svg', t('Borders as seen, SVG')],
  ['pdf', t('Borders as seen, PDF')],
  ['csv', t('Borders, CSV')],
  ['glb', t('Borders, GLB')],
];
/** Rows of the table; more are told by a file. */
const MOST_ROWS = 100;

export function cellsControls(session: Session): HTMLElement[] {
  const { scene, shown, cells } = session;
  const on = toggle(t('Cells'), (isOn) => {
    const others = scene.state.overlays.filter((overlay) => overlay !== CELLS);
    scene.edit({ overlays: isOn ? [...others, CELLS] : others });
  });
  attribute(on.element, 'title', t('What is nearest to each source, in colors, by exact distances'));
  const table = h('div', {});
  let [[kind]] = FILES as readonly [readonly [Kind, Words]];
  const file = select(t('File'), FILES, (value) => (kind = value));
  const keep = h(
    'button',
    {
      class: 'small',
      title: t('The borders, where another source becomes the nearest one'),
      onclick: () => void saveBorders(session, kind).catch((error: unknown) => session.fail(error)),
    },
    t('Save borders'),
  );
  const saving = h('div', { class: 'linking', hidden: true }, file.element, keep);
  const show = () => {
    on.show(scene.state.overlays.includes(CELLS));
    on.bar(shown.value && whyNoCells(shown.value, scene.state));
    saving.hidden = cells.value === null;
    table.replaceChildren(...(cells.value ? [tableOf(session, cells.value)] : []));
  };
  cells.watch(show);
  shown.watch(show);
  scene.subscribe((state, previous) => {
    const isOther = state.sources.length !== previous.sources.length || state.sets.length !== previous.sets.length;
    if (isOther || state.overlays !== previous.overlays || !isSameUnit(state, previous)) show();
  });
  show();
  return [on.element, table, saving];
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
  const heads = [t('Nearest source'), area, t('Share')].map((head) => h('th', { scope: 'col' }, head));
  return h(
    'table',
    { class: 'rows' },
    h('caption', { class: 'quiet' }, counted(areas.length, '{0} cell', '{0} cells')),
    h('thead', {}, h('tr', {}, ...heads)),
    h('tbody', {}, ...rows),
  );
}

async function saveBorders({ scene, shown, engine, view }: Session, kind: Kind): Promise<void> {
  if (!engine || !shown.value) return;
  const unit = unitOfFile(kind, unitOf(scene.state, shown.value.opened));
  if (kind === 'pdf' && !isKnown(unit))
    throw new Failure(
      t('A PDF is at true scale, and nothing says what the lengths are in. Choose it by "Correct unit".'),
    );
  const bytes = await engine.queries.cellFile({ kind, towardEye: towardEye(view.camera), unit });
  save(new Blob([bytes]), `${fileNameOf(shown.value)}.cells.${kind}`);
}
