/** Archives as of the ZIP File Format Specification (PKWARE APPNOTE.TXT 6.3), unpacked by fflate one file at a time. */
import { Failure } from '../error';
import { unzipSync } from 'fflate';
import { t } from '../texts/translate';

const MOST_FILES = 10_000;
/** Of an archive, and of all that is unpacked from it. */
const MOST_BYTES = 2 ** 31;
/** What is packed tighter than this, and is not small, only claims its size: meshes are packed by 2 to 20. */
const MOST_RATIO = 250;
const SMALL_BYTES = 2 ** 24;
const MEBIBYTE = 2 ** 20;

const STORED = 0;
const DEFLATED = 8;

interface Entry {
  /** Its number among the entries, and its name there. */
  index: number;
  name: string;
  packed: number;
  size: number;
  method: number;
  isEncrypted: boolean;
}

export class Archive {
  readonly #bytes: Uint8Array;
  readonly #entries: ReadonlyMap<string, Entry>;
  /** Bytes that may still be unpacked. */
  #left: number;

  readonly #most: number;

  /** Throws a sentence where the bytes are no archive, one of too many files, or one with two files of one name. */
  constructor(bytes: Uint8Array, mostBytes = Math.min(MOST_BYTES, 2 * SMALL_BYTES + MOST_RATIO * bytes.length)) {
    this.#bytes = bytes;
    this.#left = this.#most = mostBytes;
    this.#entries = entriesOf(bytes);
  }

  static async of(content: Blob): Promise<Archive> {
    if (content.size > MOST_BYTES)
      throw new Failure(t('an archive may have 2 GiB at most; unpack it and open the files'));
    return new Archive(new Uint8Array(await content.arrayBuffer()));
  }

  get paths(): string[] {
    return [...this.#entries.keys()];
  }

  /** Unpacks a file. Throws a sentence where that is not possible, and before anything is unpacked that is too large. */
  read(path: string): Uint8Array<ArrayBuffer> {
    const entry = this.#entries.get(path);
    if (!entry) throw new Failure(t`${path} is not in the archive`);
    const { index, name, packed, size, method, isEncrypted } = entry;
    if (isEncrypted) throw new Failure(t`${path} is encrypted; unpack the archive and open the files`);
    if (method !== STORED && method !== DEFLATED)
      throw new Failure(
        t`${path} is packed by method ${method}, which is not supported; pack it again as a plain .zip`,
      );
    if (size > SMALL_BYTES && size > MOST_RATIO * packed)
      throw new Failure(t`${path} claims to be ${Math.round(size / packed)} times as large as it is packed`);
    if (size > this.#left) {
      const most = Math.floor(this.#most / MEBIBYTE);
      throw new Failure(
        t`${path} and what is with it take more than ${most} MiB unpacked, too much for an archive of this size`,
      );
    }
    let at = 0;
    const bytes = orDamaged(() => unzipSync(this.#bytes, { filter: () => at++ === index })[name]);
    if (bytes?.length !== size) throw new Failure(damaged());
    this.#left -= size;
    return bytes;
  }
}

const damaged = () => t('the archive is damaged or cut short; copy it again');

function entriesOf(bytes: Uint8Array): Map<string, Entry> {
  const flags = flagsOf(bytes);
  const entries = new Map<string, Entry>();
  let twice: string | undefined;
  let index = 0;
  orDamaged(() =>
    unzipSync(bytes, {
      filter({ name, size, originalSize, compression }) {
        const isEncrypted = ((flags[index] ?? 0) & ENCRYPTED) !== 0;
        const entry = { index, name, packed: size, size: originalSize, method: compression, isEncrypted };
        index++;
        const path = name.replaceAll('\\', '/');
        if (entries.has(path)) twice ??= path;
        if (!path.endsWith('/')) entries.set(path, entry);
        return false;
      },
    }),
  );
  // Programs differ in which one they take.
  if (twice !== undefined) throw new Failure(t`the archive holds ${twice} twice; unpack it and open the files`);
  return entries;
}

const END = 0x06054b50;
const END_BYTES = 22;
const LONGEST_COMMENT = 0xffff;
const END_64 = 0x06064b50;
const LOCATOR_64 = 0x07064b50;
const LOCATOR_64_BYTES = 20;
const ENTRY_BYTES = 46;
const ENCRYPTED = 1;

/** General purpose flags (4.4.4) of each entry of the central directory (4.3.12), which fflate does not tell. */
function flagsOf(bytes: Uint8Array): number[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const { count, offset } = orDamaged(() => directoryOf(view));
  if (count > MOST_FILES)
    throw new Failure(t`the archive holds ${count} files, more than ${MOST_FILES}; unpack it and open the files`);
  return orDamaged(() => {
    const flags: number[] = [];
    for (let at = offset; flags.length < count;) {
      flags.push(view.getUint16(at + 8, true));
      // Lengths of the name, of extra fields and of the comment.
      const [name, extra, comment] = [
        view.getUint16(at + 28, true),
        view.getUint16(at + 30, true),
        view.getUint16(at + 32, true),
      ];
      at += ENTRY_BYTES + name + extra + comment;
    }
    return flags;
  });
}

/** Where the central directory is (4.3.16), in large archives by a second record (4.3.14). */
function directoryOf(view: DataView): { count: number; offset: number } {
  let end = view.byteLength - END_BYTES;
  for (const least = end - LONGEST_COMMENT; view.getUint32(end, true) !== END; end--) {
    if (end === least) throw new RangeError();
  }
  const locator = end - LOCATOR_64_BYTES;
  if (locator >= 0 && view.getUint32(locator, true) === LOCATOR_64) {
    const end64 = view.getUint32(locator + 8, true);
    if (view.getUint32(end64, true) === END_64)
      return { count: view.getUint32(end64 + 32, true), offset: view.getUint32(end64 + 48, true) };
  }
  return { count: view.getUint16(end + 8, true), offset: view.getUint32(end + 16, true) };
}

/** Whatever goes wrong while damaged bytes are read has this one reason. */
function orDamaged<T>(work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Failure(damaged(), { cause: error });
  }
}
