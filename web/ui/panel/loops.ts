/** Loops around handles: a switch, their lengths, and files of them. */
import { isSameUnit, MODEL, unitOf } from '../../length';
import type { Session } from '../../session/session';
import { measure } from '../../state/measures';
import type { Overlay } from '../../state/scene';
import { h, say } from '../dom';
import { overlaySwitch } from './overlay';
import { savingCurves } from './saving';
import { counted, enumerated, sentences, t } from '../../texts';

const LOOPS: Overlay = 'loops';
/** Lengths that are told; all are in files. */
const MOST_TOLD = 12;

export function loopsControls(session: Session): HTMLElement {
  const { scene, shown, loops } = session;
  const on = overlaySwitch(
    session,
    LOOPS,
    t('Loops around handles'),
    t('Closed curves that cannot shrink to a point, as short as they can be'),
  );
  const lengths = h('p', { class: 'quiet', role: 'status' });
  const saving = savingCurves(session, {
    label: t('Loops'),
    button: t('Save loops'),
    title: t('The loops around handles as curves'),
    suffix: 'loops',
    file: (engine, file) => engine.queries.loopFile(file),
  });
  const show = () => {
    on.show(scene.state.overlays.includes(LOOPS));
    on.bar(shown.value?.opened.interior ? t('Loops are on surfaces alone.') : null);
    const { value: found } = loops;
    saving.hidden = !found || found.lengths.length === 0;
    lengths.hidden = !found;
    if (!found) return;
    const unit = shown.value ? unitOf(scene.state, shown.value.opened) : MODEL;
    const told = found.lengths.slice(0, MOST_TOLD).map((length) => measure(length, unit));
    const number = counted(found.lengths.length, '{0} loop.', '{0} loops.');
    const none = t('The surface has no handle: all closed curves shrink to points.');
    say(lengths, told.length > 0 ? sentences(number, t`The shortest: ${enumerated(told)}.`) : none);
  };
  loops.watch(show);
  shown.watch(show);
  scene.subscribe((state, previous) => {
    if (state.overlays !== previous.overlays || !isSameUnit(state, previous)) show();
  });
  show();
  return h('div', { class: 'stack' }, on.element, lengths, saving);
}
