/** Keeps the model clear of what floats over it: tells the view how far the panel and the tool bar reach in. */
import type { View } from '../../view/view';
import { narrow } from '../panel/panel';

export function followInsets(view: View, bar: HTMLElement, panel: HTMLElement | null): void {
  const update = () => {
    const stage = view.stage.getBoundingClientRect();
    const tools = bar.getBoundingClientRect();
    const side = panel?.getBoundingClientRect();
    if (narrow()) {
      const bottom = side ? stage.bottom - side.top : 0;
      view.insets = { left: tools.right - stage.left, top: 0, right: 0, bottom };
    } else {
      const right = side && panel?.dataset.open === 'true' ? stage.right - side.left : 0;
      view.insets = { left: 0, top: 0, right, bottom: stage.bottom - tools.top };
    }
  };
  const observer = new ResizeObserver(update);
  for (const element of [view.stage, bar, panel]) if (element) observer.observe(element);
}
