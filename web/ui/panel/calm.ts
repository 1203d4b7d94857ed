/** What shows the scene in the panel, calmed while a drag brings more answers than there are frames. */
import type { Session } from '../../session/session';

/** Shows at once or, while something is dragged, once with the next frame. */
export function calmly(session: Session, show: () => void): () => void {
  let isAwaited = false;
  const now = () => {
    isAwaited = false;
    show();
  };
  return () => {
    if (!session.dragging) return show();
    if (isAwaited) return;
    isAwaited = true;
    requestAnimationFrame(now);
  };
}
