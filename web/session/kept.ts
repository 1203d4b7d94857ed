/** Files that the user opened, kept in this browser: a reload and the way back find them, and they can be opened again. */
import { Failure, toError } from '../error';
import type { MeshInput } from '../protocol';
import type { MeshReference } from '../state/scene';
import { fileName } from '../files/paths';
import { askStore } from './store';
import { t, type Words } from '../texts';

/** Files as they came together. */
export type GivenInput = Extract<MeshInput, { mesh: string }>;

export interface KeptFile {
  /** SHA-256 of the file of the mesh. */
  hash: string;
  /** When it was opened last, in milliseconds since 1970. */
  time: number;
  bytes: number;
  input: GivenInput;
}

/** As it is kept: some browsers keep no Blobs. */
interface StoredFile extends Omit<KeptFile, 'input'> {
  input:
    | { kind: 'files'; mesh: string; files: readonly { path: string; content: Blob | ArrayBuffer }[] }
    | { kind: 'archive'; mesh: string; archive: Blob | ArrayBuffer };
}

const DATABASE = 'heatwalk';
/** Of one opening, of all, and how many openings. */
const MOST_BYTES = 2 ** 28;
const MOST_BYTES_IN_ALL = 2 ** 29;
const MOST_KEPT = 12;

/** What was opened since the page was, also from addresses: its files are where they were, and take no room. */
const ofThisVisit = new Map<string, GivenInput>();
/** Why the last file is not kept; null where it is. */
let trouble: Words | null = null;

/** Why the last file that was opened is not kept. */
export function keepingTrouble(): Words | null {
  return trouble;
}

/** Keeps what a mesh was opened from; of the user's own files, also for other visits. Never fails: see `keepingTrouble`. */
export async function keep(reference: MeshReference, input: GivenInput): Promise<void> {
  ofThisVisit.set(keyOf(reference), input);
  // A page that holds this one in a frame gives its own files.
  if (reference.kind !== 'file' || window.parent !== window) return;
  const name = fileName(input.mesh);
  const bytes = input.kind === 'archive' ? input.archive.size : sum(input.files.map(({ content }) => content.size));
  trouble = null;
  try {
    if (reference.hash === '') throw new Failure(t('The page is not opened over HTTPS.'));
    if (bytes > MOST_BYTES) throw new Failure(t`More than ${MOST_BYTES / 2 ** 20} MiB are not kept.`);
    const kept = await keptFiles();
    // A reload brings what is kept already.
    if (kept[0]?.hash === reference.hash) return;
    const file: KeptFile = { hash: reference.hash, time: Date.now(), bytes, input };
    await put(file);
    await forgetOldest();
  } catch (error) {
    const reason = error instanceof Failure ? error.words : t('The browser has no room for it, or keeps nothing.');
    trouble = t`${name} is not kept. ${reason}`;
  }
}

/** What a mesh was opened from before; null where it is not kept. */
export async function findKept(reference: MeshReference): Promise<GivenInput | null> {
  const given = ofThisVisit.get(keyOf(reference));
  if (given || reference.kind !== 'file' || reference.hash === '') return given ?? null;
  const kept = await inStore<StoredFile | undefined>('readonly', (files) => files.get(reference.hash)).catch(
    () => null,
  );
  return kept ? inBlobs(kept.input) : null;
}

/** Those of all visits, the newest first; none where the browser keeps nothing. */
export async function keptFiles(): Promise<KeptFile[]> {
  const all = await inStore<StoredFile[]>('readonly', (files) => files.getAll()).catch(() => []);
  return all
    .map(({ hash, time, bytes, input }) => ({ hash, time, bytes, input: inBlobs(input) }))
    .toSorted((a, b) => b.time - a.time);
}

/** Erases one, or all of them for null, from the browser. */
export async function eraseKept(hash: string | null): Promise<void> {
  trouble = null;
  await inStore<unknown>('readwrite', (files) => (hash === null ? files.clear() : files.delete(hash)));
}

async function store(file: StoredFile): Promise<void> {
  await inStore<unknown>('readwrite', (files) => files.put(file));
}

async function put(file: KeptFile): Promise<void> {
  try {
    await store(file);
  } catch (error) {
    if (toError(error).name === 'QuotaExceededError') throw error;
    // Private windows of WebKit keep no Blobs.
    await store({ ...file, input: await inBytes(file.input) });
  }
}

async function inBytes(input: GivenInput): Promise<StoredFile['input']> {
  if (input.kind === 'archive') return { ...input, archive: await input.archive.arrayBuffer() };
  const files = input.files.map(async ({ path, content }) => ({ path, content: await content.arrayBuffer() }));
  return { ...input, files: await Promise.all(files) };
}

function inBlobs(input: StoredFile['input']): GivenInput {
  if (input.kind === 'archive') return { ...input, archive: new Blob([input.archive]) };
  return { ...input, files: input.files.map(({ path, content }) => ({ path, content: new Blob([content]) })) };
}

async function forgetOldest(): Promise<void> {
  let bytes = 0;
  for (const [index, kept] of (await keptFiles()).entries()) {
    bytes += kept.bytes;
    if (index >= MOST_KEPT || bytes > MOST_BYTES_IN_ALL)
      await inStore<unknown>('readwrite', (files) => files.delete(kept.hash));
  }
}

function keyOf(reference: MeshReference): string {
  return JSON.stringify(reference);
}

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0);
}

function inStore<T>(mode: IDBTransactionMode, ask: (files: IDBObjectStore) => IDBRequest): Promise<T> {
  return askStore(DATABASE, mode, ask);
}
