/**
 * The service worker: keeps the files of one build, so that the page opens without a network. The page itself is asked for
 * over the network first, and every file by a name that its content decides, so that files of two builds never meet. A
 * newer worker waits until no page of the older build is open; a page of the newer build takes its files from the network
 * until then.
 */
import type { KeptFiles } from './files';

declare const self: ServiceWorkerGlobalScope;

/** Written by the build; see tools/vite/offline.ts. */
declare const KEPT_FILES: KeptFiles;

/** A connection that answers more slowly is as good as none. */
const PATIENCE_MS = 4000;
/** So many files at once leave the connection to the page. */
const AT_ONCE = 4;

const { build, page, files } = KEPT_FILES;
const scope = self.registration.scope;
/** Of this page: others may be served from the same host. */
const OURS = `heatwalk ${scope} `;
const STORE = OURS + build;
const addresses = new Set(files.map((file) => new URL(file, scope).href));

self.addEventListener('install', (event) => event.waitUntil(keepAll()));

self.addEventListener('activate', (event) => event.waitUntil(takeOver()));

self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET') return;
  const address = new URL(request.url);
  address.hash = '';
  if (addresses.has(address.href)) event.respondWith(kept(request));
  else if (request.mode === 'navigate' && isPage(address)) event.respondWith(newestPage(request));
});

/** Keeps every file, or fails: the next visit tries again. */
async function keepAll(): Promise<void> {
  const store = await caches.open(STORE);
  await keepPage(store);
  const waiting = [...addresses];
  const keepEach = async () => {
    for (let address = waiting.pop(); address !== undefined; address = waiting.pop()) await keep(store, address);
  };
  await Promise.all(Array.from({ length: AT_ONCE }, keepEach));
}

/** What an older build has under the same name is the same. */
async function keep(store: Cache, address: string): Promise<void> {
  if (await store.match(address)) return;
  const response = (await caches.match(address)) ?? (await fetch(address));
  if (!isFile(response)) throw new Error(`${address} cannot be kept: status ${response.status}.`);
  await store.put(address, response);
}

async function keepPage(store: Cache): Promise<void> {
  const response = await fetch(scope, { cache: 'no-cache' });
  const text = await response.text();
  if (!response.ok || !text.includes(page)) throw new Error('The server has another build of the page by now.');
  // Without the mark of a redirection, with which a browser would refuse it as a page.
  await store.put(scope, new Response(text, { headers: response.headers }));
}

/** Also of the page that is open, of this build too: what it has not asked for yet is here. */
async function takeOver(): Promise<void> {
  const names = await caches.keys();
  const others = names.filter((name) => name.startsWith(OURS) && name !== STORE);
  await Promise.all(others.map((name) => caches.delete(name)));
  await self.clients.claim();
}

async function kept(request: Request): Promise<Response> {
  const store = await caches.open(STORE);
  return (await store.match(request.url)) ?? fetch(request);
}

/** The page as the server has it now, else as it is kept. */
async function newestPage(request: Request): Promise<Response> {
  const late = new Promise<null>((resolve) => setTimeout(() => resolve(null), PATIENCE_MS));
  const asked = fetch(request);
  const answer = await Promise.race([asked, late]).catch(() => null);
  if (answer && (answer.ok || answer.type === 'opaqueredirect')) return answer;
  const store = await caches.open(STORE);
  return (await store.match(scope)) ?? asked;
}

function isPage({ origin, pathname }: URL): boolean {
  const base = new URL(scope);
  return origin === base.origin && (pathname === base.pathname || pathname === `${base.pathname}index.html`);
}

/** Some hosts answer with their page where a file is missing. */
function isFile(response: Response): boolean {
  return response.ok && !response.headers.get('Content-Type')?.startsWith('text/html');
}
