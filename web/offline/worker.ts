/**
 * The service worker: keeps the files of one build, so that the page opens without a network. The page itself and the
 * documents are asked for over the network first, and every file by a name that its content decides, so that files of two
 * builds never meet. A
 * newer worker waits until no page of the older build is open; a page of the newer build takes its files from the network
 * until then.
 */
import type { KeptFiles, Question } from './files';

declare const self: ServiceWorkerGlobalScope;

/** Written by the build; see tools/vite/offline.ts. */
declare const KEPT_FILES: KeptFiles;

/** A connection that answers more slowly is as good as none. */
const PATIENCE_MS = 4000;
/** So many files at once leave the connection to the page. */
const AT_ONCE = 4;

const { build, page, files, documents } = KEPT_FILES;
const scope = self.registration.scope;
/** Of this page: others may be served from the same host. */
const OURS = `heatwalk ${scope} `;
const STORE = OURS + build;
const addressOf = (path: string) => new URL(path, scope).href;
const addresses = new Set(files.map(addressOf));
const documentAddresses = new Set(documents.map(addressOf));

self.addEventListener('install', (event) => event.waitUntil(keepAll()));

self.addEventListener('activate', (event) => event.waitUntil(takeOver()));

self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET') return;
  const address = new URL(request.url);
  address.hash = '';
  if (addresses.has(address.href)) return event.respondWith(kept(request));
  if (request.mode === 'navigate' && isPage(address)) return event.respondWith(newest(request, scope));
  const document = documentAt(address);
  if (documentAddresses.has(document)) event.respondWith(newest(request, document));
});

self.addEventListener('message', (event) => event.waitUntil(reply(event)));

async function reply({ data, ports }: ExtendableMessageEvent): Promise<void> {
  const question = (data as Partial<Question> | null)?.heatwalk;
  if (question === 'page') ports[0]?.postMessage(page);
  if (question !== 'take over') return;
  // Other pages of the older build may still ask for its files.
  const pages = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const isAlone = pages.filter(({ url }) => url.startsWith(scope)).length === 1;
  if (isAlone) await self.skipWaiting();
  ports[0]?.postMessage(isAlone ? page : null);
}

/** Keeps every file, or fails: the next visit tries again. */
async function keepAll(): Promise<void> {
  const store = await caches.open(STORE);
  await twice(() => keepPage(store));
  // The last ones first: the documents can wait.
  const waiting = [...documentAddresses, ...addresses];
  const keepEach = async () => {
    for (let address = waiting.pop(); address !== undefined; address = waiting.pop()) {
      const file = address;
      await twice(() => (documentAddresses.has(file) ? keepDocument(store, file) : keep(store, file)));
    }
  };
  await Promise.all(Array.from({ length: AT_ONCE }, keepEach));
}

/** Again where it fails, as where a connection breaks: one file of a hundred would lose all the others. */
function twice(task: () => Promise<void>): Promise<void> {
  return task().catch(task);
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
  await store.put(scope, unredirected(text, response));
}

/** Under the name that it has in every build. */
async function keepDocument(store: Cache, address: string): Promise<void> {
  const response = await fetch(address, { cache: 'no-cache' });
  if (!response.ok) throw new Error(`${address} cannot be kept: status ${response.status}.`);
  await store.put(address, unredirected(await response.blob(), response));
}

/** Without the mark of a redirection, with which a browser would reject it as a page. */
function unredirected(content: BodyInit, { headers }: Response): Response {
  return new Response(content, { headers });
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

/** What the server has now, else what is kept of that address. */
async function newest(request: Request, address: string): Promise<Response> {
  const late = new Promise<null>((resolve) => setTimeout(() => resolve(null), PATIENCE_MS));
  const asked = fetch(request);
  const answer = await Promise.race([asked, late]).catch(() => null);
  if (answer && (answer.ok || answer.type === 'opaqueredirect')) return answer;
  const store = await caches.open(STORE);
  return (await store.match(address)) ?? asked;
}

/** The address of the document that is meant: hosts serve `index.html` where a folder is asked for. */
function documentAt({ origin, pathname }: URL): string {
  return origin + (pathname.endsWith('/') ? `${pathname}index.html` : pathname);
}

function isPage({ origin, pathname }: URL): boolean {
  const base = new URL(scope);
  return origin === base.origin && (pathname === base.pathname || pathname === `${base.pathname}index.html`);
}

/** Some hosts answer with their page where a file is missing. */
function isFile(response: Response): boolean {
  return response.ok && !response.headers.get('Content-Type')?.startsWith('text/html');
}
