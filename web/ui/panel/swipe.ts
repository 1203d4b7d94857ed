/** The handle of the sheet on a narrow window is drawn up and down as well. Loaded after the first picture. */
import { draggable } from '../gesture';
import { narrow } from './panel';

/** CSS pixels. */
const SWIPE = 24;

export function followSwipes(panel: HTMLElement): void {
  const handle = panel.querySelector<HTMLElement>('.panel-handle');
  if (!handle) return;
  let isSwipe = false;
  draggable(handle, {
    begin: ({ button, clientY }) => {
      isSwipe = false;
      return button === 0 && narrow() ? { from: clientY } : null;
    },
    move: ({ clientY }, swipe) => {
      const up = swipe.from - clientY;
      if (Math.abs(up) < SWIPE) return;
      swipe.from = clientY;
      isSwipe = true;
      if ((panel.dataset.open === 'true') !== up > 0) handle.click();
    },
  });
  // What ends a swipe is no click; that of a key has no detail.
  const drop = (event: MouseEvent) => {
    if (isSwipe && event.isTrusted && event.detail > 0 && event.target === handle) event.stopPropagation();
  };
  panel.addEventListener('click', drop, true);
}
