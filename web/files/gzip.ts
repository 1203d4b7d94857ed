/** Files that gzip has packed (RFC 1952). */
import { Failure } from '../error';
import type { InputFile } from '../protocol';
import { fileName, withoutGz } from './paths';
import { t } from '../texts/translate';

/** What is packed tighter than this, and is not small, fills memory rather than a mesh: meshes are packed by 2 to 20. */
const MOST_RATIO = 250;
const SMALL_BYTES = 2 ** 25;
const MOST_BYTES = 2 ** 31;
const MEBIBYTE = 2 ** 20;

/** A file as it was before it was packed, without `.gz`. Servers may have unpacked it on the way. Throws a sentence where that is not possible. */
export async function unpacked({ path, content }: InputFile): Promise<InputFile> {
  const name = withoutGz(path);
  const head = new Uint8Array(await content.slice(0, 2).arrayBuffer());
  if (head[0] !== 0x1f || head[1] !== 0x8b) return { path: name, content };
  const most = Math.min(MOST_BYTES, SMALL_BYTES + MOST_RATIO * content.size);
  const reader = content.stream().pipeThrough(new DecompressionStream('gzip')).getReader();
  const chunks: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  for (;;) {
    const { value } = await reader.read().catch((error: unknown) => {
      throw new Failure(t`${fileName(path)} is damaged or cut short; copy it again`, { cause: error });
    });
    if (!value) return { path: name, content: new Blob(chunks) };
    chunks.push(value);
    bytes += value.length;
    if (bytes > most) {
      await reader.cancel();
      throw new Failure(
        t`${fileName(path)} takes more than ${Math.floor(most / MEBIBYTE)} MiB unpacked, too much for a file of this size`,
      );
    }
  }
}
