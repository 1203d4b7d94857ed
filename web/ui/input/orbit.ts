/** Camera by wheel and by two fingers. */
import type { View } from '../../view/view';

export interface Finger {
  x: number;
  y: number;
}

/** Pixels of a wheel that reports lines (Firefox). */
const LINE_PX = 16;
const ZOOM_PER_PX = 0.0016;
/** A trackpad's pinch arrives as a wheel with ctrl and small steps. */
const PINCH_PER_PX = 0.01;

export function listenToWheel(stage: HTMLElement, view: View, moved: () => void): void {
  stage.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * LINE_PX : event.deltaY;
      view.zoom(Math.exp(-pixels * (event.ctrlKey ? PINCH_PER_PX : ZOOM_PER_PX)));
      moved();
    },
    { passive: false },
  );
}

/** Pans by the middle of the two fingers and zooms by their distance. */
export function pinch(view: View, before: readonly [Finger, Finger], after: readonly [Finger, Finger]): void {
  const spread = ([a, b]: readonly [Finger, Finger]) => Math.max(1, Math.hypot(a.x - b.x, a.y - b.y));
  const middle = ([a, b]: readonly [Finger, Finger]) => [(a.x + b.x) / 2, (a.y + b.y) / 2] as const;
  const [x0, y0] = middle(before);
  const [x1, y1] = middle(after);
  view.pan(x1 - x0, y1 - y0);
  view.zoom(spread(after) / spread(before));
}
