/** The handle of the sheet on a narrow window is drawn up and down as well as tapped. Loaded after the first picture. */
import { draggable } from '../gesture';
import { narrow } from './panel';

/** CSS pixels. */
const SWIPE = 24;
/** A click comes within so many milliseconds of the pointer that makes it. */
const CLICK_MS = 500;

export function followSwipes(panel: HTMLElement): void {
  const handle = panel.querySelector<HTMLElement>('.panel-handle');
  if (!handle) return;
  let ended = -Infinity;
  draggable(handle, {
    begin: ({ button, clientY }) => (button === 0 && narrow() ? { from: clientY, isSwipe: false } : null),
    move: ({ clientY }, drag) => {
      const up = drag.from - clientY;
      if (Math.abs(up) < SWIPE) return;
      drag.from = clientY;
      drag.isSwipe = true;
      if ((panel.dataset.open === 'true') !== up > 0) handle.click();
    },
    // Right after a swipe the browser takes a tap for the end of it, and makes no click of it.
    end: ({ type, timeStamp }, { isSwipe }) => {
      ended = timeStamp;
      if (!isSwipe && type === 'pointerup') handle.click();
    },
  });
  // The click that a pointer makes after the sheet has moved may be at what has come under it, which nobody has tapped.
  const drop = (event: MouseEvent) => {
    if (!event.isTrusted || event.detail === 0 || event.timeStamp - ended > CLICK_MS) return;
    event.stopPropagation();
    event.preventDefault();
  };
  addEventListener('pointerdown', () => (ended = -Infinity), true);
  addEventListener('click', drop, true);
}
