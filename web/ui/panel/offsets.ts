/** Distance from curves on both sides: a switch, its range, and files of its isolines. */
import type { CurveFile } from '../../protocol';
import { whyNone } from '../../session/offsets';
import type { Session } from '../../session/session';
import { measure } from '../../state/measures';
import type { Overlay } from '../../state/scene';
import { isCurve } from '../../state/sources';
import { isSameUnit, MODEL, ofModel, unitOf } from '../../length';
import { h, say } from '../dom';
import { overlaySwitch } from './overlay';
import { savingCurves } from './saving';
import { t } from '../../texts';

const CURVES: Overlay = 'curves';

export function offsetsControls(session: Session): HTMLElement[] {
  const { scene, shown, offsets } = session;
  const on = overlaySwitch(
    session,
    CURVES,
    t('Distance from curves'),
    t('Exact distance from all of a curve, not its places alone, negative inside; in two colors'),
  );
  const range = h('p', { class: 'quiet', role: 'status' });
  const saving = savingCurves(session, {
    label: t('Offsets'),
    button: t('Save offsets'),
    title: t('The curve and its offsets on both sides, as far apart as the stripes'),
    suffix: 'offsets',
    file: (engine, file: CurveFile) => engine.queries.offsetFile(file),
  });
  const show = () => {
    const { state } = scene;
    on.show(state.overlays.includes(CURVES));
    on.bar(shown.value && whyNone(shown.value, state));
    on.element.hidden = !state.sets.some(isCurve) && !state.overlays.includes(CURVES);
    const { value: found } = offsets;
    saving.hidden = found === null;
    range.hidden = found === null;
    if (!found) return;
    const unit = shown.value ? unitOf(state, shown.value.opened) : MODEL;
    const [least, most] = found.range;
    const inside = measure(ofModel(-least), unit);
    say(range, t`Blue is inside, up to ${inside} deep; orange is outside, up to ${measure(most, unit)} away.`);
  };
  offsets.watch(show);
  shown.watch(show);
  scene.subscribe((state, previous) => {
    if (state.sets !== previous.sets || state.overlays !== previous.overlays || !isSameUnit(state, previous)) show();
  });
  show();
  return [on.element, range, saving];
}
