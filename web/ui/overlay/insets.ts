/** Keeps the model clear of what floats over it: tells the view how far the panel, the tool bar and, on low windows, the heading reach in. */
import type { View } from '../../view/view';
import { narrow } from '../panel/panel';

/** Of a window in which the model reaches up to the heading. */
const LOW_PX = 480;

export function followInsets(view: View, head: HTMLElement, bar: HTMLElement, panel: HTMLElement | null): void {
  const update = () => {
    const stage = view.stage.getBoundingClientRect();
    const tools = bar.getBoundingClientRect();
    const side = panel?.getBoundingClientRect();
    const top = stage.height < LOW_PX ? head.getBoundingClientRect().bottom - stage.top : 0;
    if (narrow()) {
      const bottom = side ? stage.bottom - side.top : 0;
      view.insets = { left: tools.right - stage.left, top, right: 0, bottom };
    } else {
      const right = side && panel?.dataset.open === 'true' ? stage.right - side.left : 0;
      view.insets = { left: 0, top, right, bottom: stage.bottom - tools.top };
    }
  };
  const observer = new ResizeObserver(update);
  for (const element of [view.stage, bar, panel]) if (element) observer.observe(element);
}
