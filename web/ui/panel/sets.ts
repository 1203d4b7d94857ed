/** Draws, types, and saves sources that are many at once. */
import { sentenceOf } from '../../error';
import type { Session } from '../../session/session';
import { selectedSet } from '../../state/edit';
import type { Scene } from '../../state/history';
import { fitLink } from '../../state/sets';
import type { Signal } from '../../state/signal';
import type { SourceSet } from '../../state/sources';
import { save } from '../../view/picture';
import { h, say, select } from '../dom';
import { byHand } from '../words';
import { cellsControls } from './cells';
import { offsetsControls } from './offsets';
import { DRAWING, type Tool } from '../../state/tool';
import { plainNumbers, t, type Words } from '../../texts';

const NO_DRAWING = 'none';
type Choice = typeof NO_DRAWING | (typeof DRAWING)[number];

const WORDS: readonly (readonly [Choice, Words])[] = [
  [NO_DRAWING, t('single sources')],
  ['line', t('line along edges (4)')],
  ['stroke', t('stroke (5)')],
  ['boundary', t('whole boundary (6)')],
  ['part', t('whole part (7)')],
];

const HINTS: Record<Choice, Words> = {
  none: byHand(t('Shift + click draws a line along edges from the last source.'), t('Choose what a tap draws.')),
  line: byHand(
    t('Mark one vertex after the other. The last one again, or Esc, ends the line; the first one closes it.'),
    t('Mark one vertex after the other. The last one again ends the line; the first one closes it.'),
  ),
  stroke: t('Drag on the surface to draw. A stroke that ends where it began is closed.'),
  boundary: t('Choose a boundary: all of its vertices are sources.'),
  part: t('Choose a part: all of its vertices are sources; of a model of one part, those of the component.'),
};

const TOO_MANY = t(
  'These sources are too many for a link, which leaves out those drawn and listed. Save them as a file: whoever drops it on the page has them again.',
);

/** What draws sources, a field to type or paste them, and a file to save them in. */
export function drawingControls(session: Session, tool: Signal<Tool>): HTMLElement[] {
  const { scene } = session;
  const choice = select<Choice>(t('Draw'), WORDS, (value) => {
    tool.value = value === NO_DRAWING ? 'source' : value;
  });
  const hint = h('p', { class: 'quiet' });
  tool.watch((value) => {
    const chosen = DRAWING.find((drawing) => drawing === value) ?? NO_DRAWING;
    choice.show(chosen);
    say(hint, HINTS[chosen]);
  });

  const said = h('p', { class: 'quiet', role: 'status', hidden: true });
  const tell = (text: Words) => {
    said.hidden = false;
    say(said, text);
  };
  // What was said of a model is not of another one.
  session.shown.watch((shown, previous) => {
    if (shown?.opened !== previous?.opened) said.hidden = true;
  });
  const add = async (text: string) => {
    if (text.trim() === '') return;
    try {
      const [{ addList }, { isOneLine }] = await Promise.all([
        import('../../session/sets'),
        import('../../state/list'),
      ]);
      // A list is one of several lines, and its name stays with it.
      tell(addList(session, isOneLine(text) ? t('What was typed') : t('List'), text));
      field.value = '';
    } catch (error) {
      tell(sentenceOf(error));
    }
  };
  const field = h('input', {
    type: 'text',
    placeholder: t('Vertex, or x y z'),
    title: t('A vertex of the file, counted from 0, or coordinates in the unit that is shown; a list can be pasted'),
    'aria-label': t('Source to add: a vertex, or x y z'),
    onkeydown: (event) => {
      if (event instanceof KeyboardEvent && event.key === 'Enter') void add(plainNumbers(field.value));
    },
    // A field of one line would join those of a list.
    onpaste: (event) => {
      const text = (event instanceof ClipboardEvent && event.clipboardData?.getData('text/plain')) || '';
      if (!/[\r\n]/.test(text.trim())) return;
      event.preventDefault();
      void add(text);
    },
  });
  const typed = h(
    'div',
    { class: 'linking' },
    field,
    h('button', { class: 'small', onclick: () => void add(plainNumbers(field.value)) }, t('Add')),
  );

  const tooMany = h('p', { class: 'warning', role: 'status', hidden: true });
  const button = (name: Words, title: Words, run: () => Promise<void>) => {
    const onclick = () => void run().catch((error: unknown) => session.fail(error));
    return h('button', { class: 'small', title, onclick }, name);
  };
  const keep = button(t('Save sources'), t('All sources as a CSV file, which can be dropped on the page'), async () => {
    const { tableOf } = await import('../../session/sets');
    save(new Blob([tableOf(session)], { type: 'text/csv' }), 'sources.csv');
  });
  const clear = h(
    'button',
    { class: 'small', onclick: () => scene.edit({ sources: [], sets: [], selected: -1 }) },
    t('Delete all'),
  );
  const close = button(t('Close curve'), t('Joins the end of the selected curve with its beginning'), async () => {
    const curve = openCurve(scene);
    if (curve) await (await import('../../session/sets')).closeLine(session, curve);
  });
  const keeping = h('div', { class: 'linking', hidden: true }, close, keep, clear);
  const showSets = () => {
    const { sets, sources } = scene.state;
    keeping.hidden = sets.length === 0 && sources.length < 2;
    close.hidden = openCurve(scene) === undefined;
    tooMany.hidden = fitLink(sets);
    say(tooMany, tooMany.hidden ? null : TOO_MANY);
  };
  scene.subscribe((state, previous) => {
    // While a stroke is drawn, its text is not wanted at every step.
    if (session.dragging) return;
    const isOther = state.sets !== previous.sets || state.sources.length !== previous.sources.length;
    if (isOther || state.selected !== previous.selected) showSets();
  });
  session.shown.watch(() => {
    if (!session.dragging) showSets();
  });
  return [choice.element, hint, typed, said, tooMany, keeping, ...cellsControls(session), ...offsetsControls(session)];
}

/** The curve that is selected, if it can be closed. */
function openCurve(scene: Scene): SourceSet | undefined {
  const set = selectedSet(scene);
  return set && 'closed' in set.shape && !set.shape.closed && set.points.length > 2 ? set : undefined;
}
