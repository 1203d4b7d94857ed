/** Fetches meshes from other servers. Servers learn nothing about the page or its user: no cookies, no referrer. */
import { Failure, messageOf } from '../error';
import { nameOf, pathOf } from './address';
import { type Collection, collectArchive } from './collection';
import { isMesh, isPacked } from './paths';
import type { Reference } from './references';
import type { InputFile } from '../protocol';
import { count, t, type Words } from '../texts';

/** Of a mesh and what it refers to. */
const MOST_BYTES = 2 ** 29;
export const MOST_FETCHED = t`${MOST_BYTES / 2 ** 20} MiB`;
/** Files that a mesh may refer to. */
const MOST_FILES = 1000;

const REPORT_MS = 50;

const ARCHIVE = 'PK\u0003\u0004';
const PAGE = /^\s*<(!doctype html|html|head|body)\b/i;
const JSON_DOCUMENT = /^\s*\{/;
const HEAD_BYTES = 512;
const OBJ = /\.obj$/i;
/** Material libraries are named before the triangles. */
const LIBRARY_BYTES = 2 ** 20;

/** `fraction`: of the file that is being fetched; null where the server does not tell its length. */
export type FetchListener = (bytes: number, fraction: number | null) => void;

/** The meshes at an address. Throws a sentence where there is none that can be had; an abortion as it is. */
export async function fetchCollection(
  address: string,
  progress: FetchListener,
  signal: AbortSignal,
): Promise<Collection> {
  const fetcher = new Fetcher(progress, signal);
  const { content: packed, base } = await fetcher.fetch(new URL(address));
  const named = { path: pathOf(address), content: packed };
  const file = isPacked(named.path) ? await (await import('./gzip')).unpacked(named) : named;
  const { content } = file;
  const head = await content.slice(0, HEAD_BYTES).text();
  if (head.startsWith(ARCHIVE) && !isMesh(file.path)) return collectArchive(content, nameOf(address));
  if (PAGE.test(head))
    throw new Failure(t('the address gives a web page, not a mesh; use the address of the file itself'));
  const mesh = file.path || 'mesh';
  // Most meshes refer to nothing.
  const { gltfReferences, librariesOf, mapsOf } = await import('./references');
  const document = JSON_DOCUMENT.test(head) ? await content.text() : '';
  const companions = document ? await fetcher.companions(gltfReferences(mesh, document), base) : [];
  if (OBJ.test(mesh)) {
    const libraries = await fetcher.companions(librariesOf(mesh, await content.slice(0, LIBRARY_BYTES).text()), base);
    companions.push(...libraries);
    for (const { path, content: library } of libraries)
      companions.push(...(await fetcher.companions(mapsOf(mesh, path, await library.text()), base)));
  }
  const files = [{ path: mesh, content }, ...companions];
  return { meshes: [mesh], input: () => ({ kind: 'files', mesh, files }) };
}

class Fetcher {
  readonly #progress: FetchListener;
  readonly #signal: AbortSignal;
  #bytes = 0;
  #files = 0;
  #reportedAt = 0;

  constructor(progress: FetchListener, signal: AbortSignal) {
    this.#progress = progress;
    this.#signal = signal;
  }

  /** `base`: where it was found in the end. */
  async fetch(url: URL): Promise<{ content: Blob; base: URL }> {
    const response = await this.#answer(url);
    if (!response.ok) throw new Failure(t`${url.host} answered with status ${response.status}`);
    const length = Number(response.headers.get('Content-Length'));
    if (this.#bytes + length > MOST_BYTES) throw tooLarge();
    const chunks: Uint8Array<ArrayBuffer>[] = [];
    const reader = response.body?.getReader();
    const before = this.#bytes;
    for (;;) {
      const { value: chunk } = (await reader?.read().catch((error: unknown) => this.#lost(url, error))) ?? {};
      if (!chunk) return { content: new Blob(chunks), base: new URL(response.url || url) };
      chunks.push(chunk);
      this.#bytes += chunk.length;
      if (this.#bytes > MOST_BYTES) {
        void reader?.cancel();
        throw tooLarge();
      }
      this.#tell(length > 0 ? Math.min(1, (this.#bytes - before) / length) : null);
    }
  }

  /** The files that a mesh refers to, those that are there. Throws where one that is needed is not. */
  async companions(references: readonly Reference[], base: URL): Promise<InputFile[]> {
    this.#files += references.length;
    if (this.#files > MOST_FILES)
      throw new Failure(t`it refers to more than ${count(MOST_FILES)} files; download them and drop their folder here`);
    const found: InputFile[] = [];
    for (const { uri, path, isNeeded } of references) {
      try {
        found.push({ path, content: await this.#companion(uri, base) });
      } catch (error) {
        this.#signal.throwIfAborted();
        if (isNeeded) throw new Failure(t`it refers to ${uri}, but ${messageOf(error)}`, { cause: error });
      }
    }
    return found;
  }

  async #companion(uri: string, base: URL): Promise<Blob> {
    const url = URL.canParse(uri, base) ? new URL(uri, base) : null;
    if (url?.origin !== base.origin)
      throw new Failure(t`only files of ${base.host} are fetched for it; download both and drop them here`);
    return (await this.fetch(url)).content;
  }

  async #answer(url: URL): Promise<Response> {
    try {
      return await fetch(url, { ...ANONYMOUS, signal: this.#signal });
    } catch (error) {
      this.#signal.throwIfAborted();
      throw new Failure(await this.#reason(url), { cause: error });
    }
  }

  /** A fetch does not say why it failed. */
  async #reason(url: URL): Promise<Words> {
    if (!navigator.onLine) return t('there is no connection to the network');
    if (location.protocol === 'https:' && url.protocol === 'http:')
      return t`a page served over https cannot read from http://${url.host}; ${DOWNLOAD}`;
    const isThere = await fetch(url, { ...ANONYMOUS, method: 'HEAD', mode: 'no-cors', signal: this.#signal }).then(
      () => true,
      () => false,
    );
    return isThere
      ? t`${url.host} does not allow other pages to read it (CORS); ${DOWNLOAD}`
      : t`${url.host} could not be reached; check the address and the connection`;
  }

  #lost(url: URL, error: unknown): never {
    this.#signal.throwIfAborted();
    throw new Failure(t`the connection to ${url.host} was lost; try again`, { cause: error });
  }

  #tell(fraction: number | null): void {
    const now = performance.now();
    if (now - this.#reportedAt < REPORT_MS) return;
    this.#reportedAt = now;
    this.#progress(this.#bytes, fraction);
  }
}

const DOWNLOAD = t('download the file and drop it here');
const ANONYMOUS = { credentials: 'omit', referrerPolicy: 'no-referrer' } as const;

function tooLarge(): Error {
  return new Failure(t`it is larger than ${MOST_FETCHED}, the most that is fetched; ${DOWNLOAD}`);
}
