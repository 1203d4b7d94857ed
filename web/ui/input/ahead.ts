/** Keys that are typed ahead of what they are meant for. */

/** Keeps them from the page while that is on its way. Returns what ends this, and gives them in order. */
export function keysAhead(): () => readonly string[] {
  const keys: string[] = [];
  const keep = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    keys.push(event.key);
  };
  addEventListener('keydown', keep, { capture: true });
  return () => {
    removeEventListener('keydown', keep, { capture: true });
    return keys.splice(0);
  };
}
