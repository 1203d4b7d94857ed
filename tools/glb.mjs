// GLB files, written array by array: for tests and benchmarks.

const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

/** A growing document. */
export class GlbWriter {
  #bytes = [];
  #bufferViews = [];
  #accessors = [];

  /** Its index. */
  view(content) {
    const byteOffset = this.#bytes.reduce((sum, { length }) => sum + length, 0);
    this.#bytes.push(content, Buffer.alloc((4 - (content.length % 4)) % 4));
    return this.#bufferViews.push({ buffer: 0, byteOffset, byteLength: content.length }) - 1;
  }

  /** Its index. */
  accessor(array, type, more = {}) {
    const componentType = array instanceof Float32Array ? 5126 : array instanceof Uint32Array ? 5125 : 5121;
    const bufferView = this.view(Buffer.from(array.buffer));
    const count = array.length / WIDTHS[type];
    return this.#accessors.push({ bufferView, componentType, type, count, ...more }) - 1;
  }

  /** The file of a document that refers to them. */
  pack(document) {
    const bin = Buffer.concat(this.#bytes);
    return pack(
      JSON.stringify({
        asset: { version: '2.0' },
        scene: 0,
        scenes: [{ nodes: document.nodes?.map((_, node) => node) ?? [] }],
        buffers: [{ byteLength: bin.length }],
        bufferViews: this.#bufferViews,
        accessors: this.#accessors,
        ...document,
      }),
      bin,
    );
  }
}

/** A GLB file of a document and its buffer, of whole words. */
export function pack(json, bin) {
  const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
  const chunks = [word(text.length, 0x4e4f534a), text, word(bin.length, 0x004e4942), bin];
  const length = 12 + chunks.reduce((sum, chunk) => sum + chunk.length, 0);
  return Buffer.concat([word(0x46546c67, 2, length), ...chunks]);
}

function word(...values) {
  return Buffer.from(Uint32Array.from(values).buffer);
}
