/** The section of charts: what draws them is loaded when it is first expanded. */
import type { Session } from '../../session/session';
import type { MeasuredTape } from '../../session/tapes';
import { isSameUnit } from '../../length';
import type { Signal } from '../../state/signal';
import { h } from '../dom';
import type { Charts } from '../charts/charts';

/** `tapes`: what is measured; changes with each measurement. */
export function chartsSection(session: Session, tapes: Signal<readonly MeasuredTape[]>): HTMLElement {
  const element = h('div', {});
  let charts: Promise<Charts> | null = null;
  let isSeen = false;
  const update = async () => {
    if (!isSeen) return;
    try {
      charts ??= import('../charts/charts').then((module) => {
        const made = new module.Charts(session, () => tapes.value);
        element.append(made.element);
        return made;
      });
      (await charts).update();
    } catch (error) {
      // The next time that it is expanded tries again.
      charts = null;
      session.fail(error);
    }
  };
  new IntersectionObserver((entries) => {
    isSeen = entries.at(-1)?.isIntersecting ?? false;
    void update();
  }).observe(element);
  session.shown.watch(() => void update());
  tapes.watch(() => void update());
  session.scene.subscribe((state, previous) => {
    if (!isSameUnit(state, previous)) void update();
  });
  return element;
}
