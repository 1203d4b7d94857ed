/** Writes binary glTF 2.0: arrays and images in one buffer, described by JSON. */

/** `mode` of a primitive that is pairs of vertices (5.24.4). */
export const LINES = 1;

/** Types of numbers in arrays (3.6.2.2), and what views of the buffer are for. */
const [FLOAT, UNSIGNED_INT] = [5126, 5125];
const [ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER] = [34962, 34963];
/** The file, its chunks (4.4), and the character that JSON is filled up with. */
const [GLTF, VERSION, JSON_CHUNK, BIN_CHUNK, SPACE] = [0x46546c67, 2, 0x4e4f534a, 0x004e4942, 0x20];
/** Linear, with mipmaps (5.26). */
const SAMPLER = { magFilter: 9729, minFilter: 9987, wrapS: 10497, wrapT: 33071 };
const WIDTH = { VEC2: 2, VEC3: 3 } as const;

type Json = Readonly<Record<string, unknown>>;

/** A file that grows by arrays and images, which are named by their numbers. */
export class GlbFile {
  readonly #accessors: Json[] = [];
  readonly #views: Json[] = [];
  readonly #images: Json[] = [];
  readonly #parts: Uint8Array[] = [];
  #length = 0;

  /** An array of vertices, with its least and greatest values, which positions must have. */
  vertices(numbers: Float32Array, type: keyof typeof WIDTH): number {
    const width = WIDTH[type];
    const least = Array.from({ length: width }, () => Infinity);
    const most = least.map((none) => -none);
    numbers.forEach((number, index) => {
      const axis = index % width;
      least[axis] = Math.min(least[axis] ?? number, number);
      most[axis] = Math.max(most[axis] ?? number, number);
    });
    const bufferView = this.#view(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength), ARRAY_BUFFER);
    return this.#add({ bufferView, componentType: FLOAT, count: numbers.length / width, type, min: least, max: most });
  }

  indices(corners: Uint32Array): number {
    const bufferView = this.#view(new Uint8Array(corners.buffer), ELEMENT_ARRAY_BUFFER);
    return this.#add({ bufferView, componentType: UNSIGNED_INT, count: corners.length, type: 'SCALAR' });
  }

  /** An image as a texture, which is repeated along U and not along V. */
  texture(png: Uint8Array): number {
    return this.#images.push({ bufferView: this.#view(png), mimeType: 'image/png' }) - 1;
  }

  #add(accessor: Json): number {
    return this.#accessors.push(accessor) - 1;
  }

  #view(bytes: Uint8Array, target?: number): number {
    const view = { buffer: 0, byteOffset: this.#length, byteLength: bytes.length, ...(target ? { target } : {}) };
    // Numbers begin at multiples of their size.
    const filled = new Uint8Array(4 * Math.ceil(bytes.length / 4));
    filled.set(bytes);
    this.#parts.push(filled);
    this.#length += filled.length;
    return this.#views.push(view) - 1;
  }

  #textures(): Json {
    const textures = this.#images.map((_, source) => ({ source, sampler: 0 }));
    return { images: this.#images, textures, samplers: [SAMPLER] };
  }

  /** The file: one scene of the first node, and what else this document has. */
  finish(document: Json): Uint8Array<ArrayBuffer> {
    const root = {
      asset: { version: '2.0', generator: 'Heatwalk' },
      scene: 0,
      scenes: [{ nodes: [0] }],
      ...document,
      ...(this.#images.length > 0 ? this.#textures() : {}),
      accessors: this.#accessors,
      bufferViews: this.#views,
      buffers: [{ byteLength: this.#length }],
    };
    const text = new TextEncoder().encode(JSON.stringify(root));
    const described = 4 * Math.ceil(text.length / 4);
    const bytes = new Uint8Array(12 + 8 + described + 8 + this.#length);
    const header = new DataView(bytes.buffer);
    const put = (at: number, ...words: number[]) =>
      words.forEach((word, i) => header.setUint32(at + 4 * i, word, true));
    put(0, GLTF, VERSION, bytes.length, described, JSON_CHUNK);
    bytes.fill(SPACE, 20, 20 + described).set(text, 20);
    put(20 + described, this.#length, BIN_CHUNK);
    bytes.set(joined(this.#parts), 28 + described);
    return bytes;
  }
}

/** Bytes one after the other. */
export function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}
