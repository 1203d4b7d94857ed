/** What a drop, the clipboard or a file dialogue holds, as files with their paths. */
import { Failure } from '../../error';
import { addressIn } from '../../files/address';
import { isArchive, isMesh, withoutGz } from '../../files/paths';
import type { InputFile } from '../../protocol';
import type { InputFiles } from '../../session/opener';
import { count, t } from '../../texts';

/** A folder with more is not the folder of a mesh. */
const MOST_FILES = 10_000;

/** Files as a dialogue gives them; those of a folder tell their paths. */
export function filesOf(files: Iterable<File>): InputFiles {
  const given = Array.from(files, (file) => ({ path: file.webkitRelativePath || file.name, content: file }));
  const [title = ''] = (given[0]?.path ?? '').split('/');
  return { title, files: given.length > MOST_FILES ? Promise.reject(tooMany(title)) : Promise.resolve(given) };
}

/** Files and folders. To be called while the event that brings them is handled: later, they are gone. */
export function itemsOf(items: DataTransferItemList): InputFiles {
  const taken = Array.from(items)
    .filter(({ kind }) => kind === 'file')
    .map((item) => ({ entry: item.webkitGetAsEntry(), file: item.getAsFile() }));
  const [first] = taken;
  const title = first?.entry?.name ?? first?.file?.name ?? '';
  return { title, files: allOf(title, taken) };
}

/** The address of a link or an image that is dragged from another page; null where there are files to open. */
export function draggedAddress(dragged: DataTransfer): string | null {
  if ([...dragged.items].some((item) => item.webkitGetAsEntry()?.isDirectory)) return null;
  if ([...dragged.files].some(({ name }) => isMesh(withoutGz(name)) || isArchive(name))) return null;
  // A list may begin with comments.
  const lines = dragged.getData('text/uri-list').split('\n').map(addressIn);
  return lines.find((address) => address !== null) ?? null;
}

interface Taken {
  /** Null where the browser knows only the file, as of the clipboard. */
  entry: FileSystemEntry | null;
  file: File | null;
}

async function allOf(title: string, taken: readonly Taken[]): Promise<InputFile[]> {
  const found: InputFile[] = [];
  const add = (path: string, content: Blob) => {
    if (found.length === MOST_FILES) throw tooMany(title);
    found.push({ path, content });
  };
  const walk = async (entry: FileSystemEntry): Promise<void> => {
    if (isFolder(entry)) for (const child of await childrenOf(entry)) await walk(child);
    else if (isFile(entry)) add(entry.fullPath.replace(/^\//, ''), await fileOf(entry));
  };
  for (const { entry, file } of taken) {
    // WebKit finds no file by the entry of what a script has dropped.
    if (file && !entry?.isDirectory) add(file.name, file);
    else if (entry) await walk(entry);
  }
  return found;
}

function isFolder(entry: FileSystemEntry): entry is FileSystemDirectoryEntry {
  return entry.isDirectory;
}

function isFile(entry: FileSystemEntry): entry is FileSystemFileEntry {
  return entry.isFile;
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) => entry.file(resolve, reject));
}

async function childrenOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const children: FileSystemEntry[] = [];
  // A folder is listed in batches, the last of them empty.
  for (;;) {
    const piece = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (piece.length === 0) return children;
    children.push(...piece);
  }
}

function tooMany(title: string): Error {
  return new Failure(t`${title} holds more than ${count(MOST_FILES)} files; choose the folder of one mesh`);
}
