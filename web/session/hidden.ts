import { Signal } from '../state/signal';

/** Whether the page is hidden: in another tab, minimised, or behind a locked screen. */
export function pageHidden(): Signal<boolean> {
  const isHidden = new Signal(document.hidden);
  document.addEventListener('visibilitychange', () => (isHidden.value = document.hidden));
  return isHidden;
}
