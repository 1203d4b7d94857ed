/** Basis Universal images in KTX 2.0 files, decoded by a module that is loaded with the first of them. */
import basisAddress from '../../wasm/basis/heatwalk_basis_bg.wasm?url';
import { onDemand } from './demand';
import { bitmapOf } from './texels';

/** How a file of KTX 2.0 begins. */
const IDENTIFIER = [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30];

const decoder = onDemand(async () => {
  const module = await import('../../wasm/basis/heatwalk_basis.js');
  await module.default({ module_or_path: basisAddress });
  return module;
});

export function isBasis(bytes: Uint8Array): boolean {
  return IDENTIFIER.every((byte, index) => bytes[index] === byte);
}

/** The image with at most `largest` texels either way that the file has, else its smallest. */
export async function decodeBasis(bytes: Uint8Array, largest: number): Promise<ImageBitmap> {
  const { BasisImage, __wbg_reset_state: renew } = await decoder();
  try {
    const image = BasisImage.decode(bytes, largest);
    const { width, height } = image;
    const texels = image.take_texels();
    return await bitmapOf(new Uint8ClampedArray(texels.buffer as ArrayBuffer), width, height);
  } finally {
    // Each image has an instance of its own: memory of the last one goes back, and a trap ends nothing else.
    renew();
  }
}
