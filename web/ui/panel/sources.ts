import { linkAll, linkNearest } from '../../session/links';
import type { Session } from '../../session/session';
import { removeEntry, setInitialDistance } from '../../state/edit';
import { inModel, isSameUnit, MODEL, typed, unitOf } from '../../length';
import type { Signal } from '../../state/signal';
import { attribute, h, say } from '../dom';
import { calmly } from './calm';
import type { Tool } from '../../state/tool';
import { unreachedSentence } from '../words';
import { entryAt } from './entries';
import { t } from '../../texts';

/**
 * The list of sources: select, focus, initial distance, delete; what draws and adds them, fetched after the `first` picture; and the
 * parts that none of them reaches.
 */
export function sourcesSection(session: Session, tool: Signal<Tool>, first: Promise<void>): HTMLElement {
  const { scene } = session;
  const list = h('ul', { class: 'sources' });
  const unreached = h('p', { class: 'warning', hidden: true });
  const nearest = h(
    'button',
    {
      class: 'small',
      title: t(
        'Lets distance and paths cross to the nearest group of components that is not reached, where it is nearest',
      ),
      onclick: () => {
        nearest.disabled = true;
        void linkNearest(session).finally(() => {
          nearest.disabled = false;
        });
      },
    },
    t('Link nearest'),
  );
  const all = h(
    'button',
    { class: 'small', title: t('Links all groups of components'), onclick: () => linkAll(session) },
    t('Link all'),
  );
  const linking = h('div', { class: 'linking', hidden: true }, nearest, all);
  const trouble = h('p', { class: 'warning', role: 'status', hidden: true });
  let rows: HTMLElement[] = [];
  const shownUnit = () => (session.shown.value ? unitOf(scene.state, session.shown.value.opened) : MODEL);

  const build = () => {
    const { sources, sets } = scene.state;
    rows = [...sources, ...sets].map((_, index) => row(index));
    list.replaceChildren(...rows);
    trouble.hidden = true;
    if (rows.length === 0) list.append(h('li', { class: 'quiet' }, t('No source yet: set one on the surface.')));
  };
  const row = (index: number) => {
    const name = h('button', {
      class: 'source-name',
      title: t('Select; arrows on the model move it, Delete removes it'),
      onclick: () => {
        const selected = scene.state.selected === index ? -1 : index;
        scene.set({ selected });
        const place = session.shown.value?.places.at(entryAt(scene.state, index).middle);
        if (selected >= 0 && place) session.view.focus(place.position);
      },
    });
    const remove = h(
      'button',
      {
        class: 'small',
        title: t('Delete this source (Delete)'),
        'aria-label': t`Delete source ${index + 1}`,
        onclick: () => removeEntry(scene, index),
      },
      '×',
    );
    const isSet = index >= scene.state.sources.length;
    const mark = h('span', { class: isSet ? 'pin set' : 'pin', 'aria-hidden': 'true' });
    return h('li', {}, mark, name, initialDistanceField(index), remove);
  };
  /** All that is typed until the focus leaves is one step of undo. */
  const initialDistanceField = (index: number) => {
    let gesture = {};
    const field = h('input', {
      type: 'number',
      min: 0,
      step: 'any',
      title: t('Initial distance: the distance at this source'),
      onfocus: () => {
        gesture = {};
      },
      oninput: () => {
        const { valid } = field.validity;
        trouble.hidden = valid;
        say(trouble, valid ? null : t('An initial distance is a number, 0 or more.'));
        if (valid && field.value !== '') {
          setInitialDistance(scene, index, inModel(field.valueAsNumber, shownUnit()), gesture);
        }
      },
      onblur: () => {
        field.valueAsNumber = typed(entryAt(scene.state, index).offset, shownUnit());
      },
    });
    const unitName = h('span', { class: 'initial-unit' });
    return h('label', { class: 'initial quiet' }, t('initial'), field, unitName);
  };
  const fill = () => {
    const { selected } = scene.state;
    const unit = shownUnit();
    rows.forEach((element, index) => {
      const name = element.querySelector<HTMLButtonElement>('.source-name');
      if (!name) return;
      const { title, offset } = entryAt(scene.state, index, session.shown.value?.opened);
      say(name, title);
      name.setAttribute('aria-pressed', String(index === selected));
      const initial = element.querySelector<HTMLInputElement>('.initial input');
      // What is being typed is left alone.
      if (initial && initial !== document.activeElement) initial.valueAsNumber = typed(offset, unit);
      const symbol = unit.symbol || t('units');
      if (initial) attribute(initial, 'aria-label', t`Initial distance of source ${index + 1}, in ${symbol}`);
      const unitName = element.querySelector<HTMLElement>('.initial-unit');
      if (unitName) say(unitName, unit.symbol);
    });
  };
  const show = calmly(session, fill);
  scene.subscribe((state, previous) => {
    // A drag changes places, not the rows: rebuilding them would drop the focus.
    if (state.sources.length !== previous.sources.length || state.sets.length !== previous.sets.length) {
      const focused = rows.findIndex((one) => one.contains(document.activeElement));
      build();
      fill();
      // Whoever deletes one goes on with the next, or sets another.
      const next = rows[Math.min(focused, rows.length - 1)]?.querySelector<HTMLElement>('.small');
      if (focused >= 0) (next ?? session.view.stage).focus();
    }
    const isOther = state.sources !== previous.sources || state.sets !== previous.sets;
    if (isOther || state.selected !== previous.selected || !isSameUnit(state, previous)) show();
  });
  build();
  show();

  session.shown.watch((shown, previous) => {
    if (shown?.opened !== previous?.opened) show();
    const sentence = shown?.answer.field ? unreachedSentence(shown.opened, shown.answer.field) : null;
    unreached.hidden = !sentence;
    linking.hidden = !sentence || shown?.opened.report.components === 1 || shown?.opened.interior !== null;
    say(unreached, sentence ?? '');
  });
  unreached.setAttribute('role', 'status');
  const drawing = h('div', { class: 'stack' });
  void first.then(async () => drawing.append(...(await import('./sets')).drawingControls(session, tool)));
  return h('div', { class: 'stack' }, list, trouble, drawing, unreached, linking);
}
