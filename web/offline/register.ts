/** Keeps the page for visits without a network, once it has nothing better to do. */

/** After the first scene has settled: whoever only looks in, or clicks at once, is not disturbed. */
const QUIET_MS = 10_000;

/** Of browsers that tell it. */
type Connection = { saveData?: boolean };

/** `settled` resolves when the page has nothing under way. */
export async function keepForOffline(settled: () => Promise<void>): Promise<void> {
  if (!mayKeep()) return;
  await settled();
  await quiet();
  await settled();
  // Where it cannot be kept, the page is one that needs its network.
  await navigator.serviceWorker.register(new URL('offline.js', document.baseURI)).catch(() => undefined);
}

/** Frames in other pages are left out, so are visitors who save data. */
function mayKeep(): boolean {
  const { connection } = navigator as Navigator & { connection?: Connection };
  const isFrame = window.parent !== window;
  return import.meta.env.PROD && 'serviceWorker' in navigator && !isFrame && connection?.saveData !== true;
}

/** A while later, or as soon as the page is hidden. */
function quiet(): Promise<void> {
  return new Promise((resolve) => {
    const look = () => {
      if (document.visibilityState === 'hidden') resolve();
    };
    setTimeout(resolve, QUIET_MS);
    document.addEventListener('visibilitychange', look);
    look();
  });
}
