/**
 * Keeps the page for visits without a network, once it has nothing better to do, and tells when a newer build of it is kept: it is never
 * loaded unasked. Fetched after the first picture.
 */
import type { Question } from './files';

/** After the first scene has settled: whoever only looks in, or clicks at once, is not disturbed. */
const QUIET_MS = 10_000;

/** Of browsers that tell it. */
type Connection = { saveData?: boolean };

/** `settled` resolves when the page has nothing under way; `offer` tells of a newer build, and loads it by what it is given. */
export async function keepForOffline(settled: () => Promise<void>, offer: (load: () => void) => void): Promise<void> {
  if (!mayKeep()) return;
  await settled();
  await quiet();
  await settled();
  try {
    const registration = await navigator.serviceWorker.register(new URL('offline.js', document.baseURI));
    const look = () => void offerWaiting(registration, offer);
    registration.addEventListener('updatefound', () => registration.installing?.addEventListener('statechange', look));
    look();
  } catch {
    // Where it cannot be kept, the page is one that needs its network.
  }
}

/** Offers the build that waits, unless this page is of it: the network has brought it then. */
async function offerWaiting({ waiting }: ServiceWorkerRegistration, offer: (load: () => void) => void): Promise<void> {
  if (!waiting || !navigator.serviceWorker.controller) return;
  const page = await ask(waiting, 'page');
  if (document.querySelector(`script[src$="${page}"]`)) return;
  offer(() => {
    navigator.serviceWorker.addEventListener('controllerchange', () => location.reload());
    // Other pages of the older build keep their files: this one is loaded from the network.
    void ask(waiting, 'take over').then((answer) => {
      if (answer === null) location.reload();
    });
  });
}

function ask(worker: ServiceWorker, heatwalk: Question['heatwalk']): Promise<string | null> {
  const { port1, port2 } = new MessageChannel();
  return new Promise((resolve) => {
    port1.addEventListener('message', ({ data }: MessageEvent<string | null>) => resolve(data));
    port1.start();
    worker.postMessage({ heatwalk } satisfies Question, [port2]);
  });
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
