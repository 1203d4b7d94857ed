/** Addresses of meshes. */
import { fileName, isArchive, isMesh, withoutGz } from './paths';

/** An http or https address as the browser writes it, without a fragment; null for any other text. */
export function addressIn(text: string): string | null {
  const trimmed = text.trim();
  if (!/^https?:\/\/\S+$/i.test(trimmed) || !URL.canParse(trimmed)) return null;
  const url = new URL(trimmed);
  url.hash = '';
  // A fetch rejects an address with a user name.
  return url.username === '' && url.password === '' ? url.href : null;
}

/** Whether an address says by its path that a mesh is there, or an archive. */
export function namesMesh(address: string): boolean {
  const path = withoutGz(pathOf(address));
  return isMesh(path) || isArchive(path);
}

/** Path of an address, readable. */
export function pathOf(address: string): string {
  return percentDecoded(new URL(address).pathname.replace(/^\/|\/$/g, ''));
}

/** What is at an address, in a word: the name of the file, else the host. */
export function nameOf(address: string): string {
  return fileName(pathOf(address)) || hostOf(address);
}

export function hostOf(address: string): string {
  return new URL(address).host;
}

/** As it is where it is not encoded well. */
export function percentDecoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
