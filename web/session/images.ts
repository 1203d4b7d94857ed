/** Images of the user, kept in this browser for decals: a reload and the way back find them. */
import { Failure } from '../error';
import type { InputFile } from '../protocol';
import { askStore } from './store';
import { t } from '../texts';

interface StoredImage {
  hash: string;
  time: number;
  type: string;
  bytes: ArrayBuffer;
}

const DATABASE = 'heatwalk-images';
/** Of one image, and how many are kept. */
const MOST_BYTES = 2 ** 25;
const MOST_KEPT = 40;
const SVG = 'image/svg+xml';
/** Digits of the hash in the name. */
const DIGITS = 16;

/** Those of this visit. */
const given = new Map<string, Blob>();

/** Keeps an image; its name in a scene. */
export async function keepImage(file: Blob, path: string): Promise<string> {
  if (file.size > MOST_BYTES) throw new Failure(t`An image can have up to ${MOST_BYTES / 2 ** 20} MiB.`);
  const bytes = await file.arrayBuffer();
  const name = `file-${await hashOf(bytes)}`;
  const type = file.type || (/\.svg$/i.test(path) ? SVG : '');
  given.set(name, new Blob([bytes], { type }));
  const image: StoredImage = { hash: name, time: Date.now(), type, bytes };
  // Where the browser keeps nothing, it is there for this visit.
  await put(image).catch(() => undefined);
  return name;
}

/** Keeps images of a scene that was saved. */
export async function keepImages(files: readonly InputFile[]): Promise<void> {
  for (const { path, content } of files) await keepImage(content, path);
}

/** An image by its name in a scene. */
export async function imageFile(name: string): Promise<Blob> {
  const known = given.get(name);
  if (known) return known;
  const kept = await askStore<StoredImage | undefined>(DATABASE, 'readonly', (images) => images.get(name)).catch(
    () => undefined,
  );
  if (!kept) throw new Failure(t('The image of this scene is not in this browser. Choose it again.'));
  return new Blob([kept.bytes], { type: kept.type });
}

/** Those with these names, as files that `keepImage` knows again; what this browser has not is left out. */
export async function filesOfImages(names: readonly string[]): Promise<InputFile[]> {
  const found = await Promise.all(
    [...new Set(names)].map(async (name) => {
      const content = await imageFile(name).catch(() => null);
      return content ? [{ path: content.type === SVG ? `${name}.svg` : name, content }] : [];
    }),
  );
  return found.flat();
}

async function put(image: StoredImage): Promise<void> {
  await askStore<unknown>(DATABASE, 'readwrite', (images) => images.put(image));
  const all = await askStore<StoredImage[]>(DATABASE, 'readonly', (images) => images.getAll());
  const oldest = all.toSorted((a, b) => b.time - a.time).slice(MOST_KEPT);
  for (const { hash } of oldest) await askStore<unknown>(DATABASE, 'readwrite', (images) => images.delete(hash));
}

/** The beginning of its SHA-256; where the browser offers none, as on pages that are not served over HTTPS, of its size and time. */
async function hashOf(bytes: ArrayBuffer): Promise<string> {
  const { subtle } = crypto as { subtle?: SubtleCrypto };
  if (!subtle) return (Date.now() * 4096 + (bytes.byteLength % 4096)).toString(16).padStart(DIGITS, '0').slice(-DIGITS);
  const digest = new Uint8Array(await subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0'))
    .join('')
    .slice(0, DIGITS);
}
