export class GlbWriter {
  view(content: Buffer): number;
  accessor(
    array: Float32Array | Uint32Array | Uint8Array,
    type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4' | 'MAT4',
    more?: object,
  ): number;
  pack(document: object): Buffer;
}
export function pack(json: string, bin: Buffer): Buffer;
