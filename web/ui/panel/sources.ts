import type { MeshPoint } from '../../protocol';
import { linkAll, linkNearest } from '../../session/links';
import type { Session } from '../../session/session';
import { setInitialDistance } from '../../state/edit';
import { h } from '../dom';
import { unreachedSentence } from '../words';

/** The list of sources: select, focus, initial distance, delete; and the parts that none of them reaches. */
export function sourcesSection(session: Session): HTMLElement {
  const { scene } = session;
  const list = h('ul', { class: 'sources' });
  const unreached = h('p', { class: 'warning', hidden: true });
  const nearest = h(
    'button',
    {
      class: 'small',
      title:
        'Lets distance and paths cross to the nearest group of components that is not reached, where it is nearest',
      onclick: () => {
        nearest.disabled = true;
        void linkNearest(session).finally(() => {
          nearest.disabled = false;
        });
      },
    },
    'Link nearest',
  );
  const all = h(
    'button',
    { class: 'small', title: 'Links all groups of components', onclick: () => linkAll(session) },
    'Link all',
  );
  const linking = h('div', { class: 'linking', hidden: true }, nearest, all);
  let rows: HTMLElement[] = [];

  const build = () => {
    const { sources } = scene.state;
    rows = sources.map((_, index) => row(index));
    list.replaceChildren(...rows);
    if (rows.length === 0) list.append(h('li', { class: 'quiet' }, 'No source: click the surface to set one.'));
  };
  const row = (index: number) => {
    const name = h('button', {
      class: 'source-name',
      title: 'Select; arrows move it, Delete removes it',
      onclick: () => {
        const selected = scene.state.selected === index ? -1 : index;
        scene.set({ selected });
        const place = session.shown.value?.places.at(scene.state.sources[index]);
        if (selected >= 0 && place) session.view.focus(place.position);
      },
    });
    const remove = h(
      'button',
      {
        class: 'small',
        title: 'Delete this source (Delete)',
        'aria-label': `Delete source ${index + 1}`,
        onclick: () => scene.place({ sources: scene.state.sources.toSpliced(index, 1), selected: -1 }),
      },
      '×',
    );
    return h('li', {}, h('span', { class: 'pin', 'aria-hidden': 'true' }), name, initialDistanceField(index), remove);
  };
  /** All that is typed until the focus leaves is one step of undo. */
  const initialDistanceField = (index: number) => {
    let gesture = {};
    const field = h('input', {
      type: 'number',
      min: 0,
      step: 'any',
      title: 'Initial distance: the distance at this source, in units of the file',
      'aria-label': `Initial distance of source ${index + 1}, in units`,
      onfocus: () => {
        gesture = {};
      },
      oninput: () => {
        if (field.validity.valid && field.value !== '') {
          setInitialDistance(scene, index, field.valueAsNumber, gesture);
        }
      },
      onblur: () => {
        field.valueAsNumber = scene.state.sources[index]?.offset ?? 0;
      },
    });
    return h('label', { class: 'initial quiet' }, 'initial', field);
  };
  const label = () => {
    const { sources, selected } = scene.state;
    rows.forEach((element, index) => {
      const name = element.querySelector<HTMLButtonElement>('.source-name');
      if (!name) return;
      name.textContent = pointName(sources[index]);
      name.setAttribute('aria-pressed', String(index === selected));
      const initial = element.querySelector<HTMLInputElement>('.initial input');
      // What is being typed is left alone.
      if (initial && initial !== document.activeElement) initial.valueAsNumber = sources[index].offset ?? 0;
    });
  };
  scene.subscribe((state, previous) => {
    // A drag changes places, not the rows: rebuilding them would drop the focus.
    if (state.sources.length !== previous.sources.length) build();
    if (state.sources !== previous.sources || state.selected !== previous.selected) label();
  });
  build();
  label();

  session.shown.watch((shown) => {
    const sentence = shown?.answer.field ? unreachedSentence(shown.opened, shown.answer.field) : null;
    unreached.hidden = !sentence;
    linking.hidden = !sentence || shown?.opened.report.components === 1 || shown?.opened.interior !== null;
    if (unreached.textContent !== (sentence ?? '')) unreached.textContent = sentence ?? '';
  });
  unreached.setAttribute('role', 'status');
  return h('div', { class: 'stack' }, list, unreached, linking);
}

function pointName(point: MeshPoint): string {
  if ('vertex' in point) return `Vertex ${point.vertex}`;
  return 'face' in point ? `Triangle ${point.face}` : `Tetrahedron ${point.tetrahedron}`;
}
