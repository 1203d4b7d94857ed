/** Basis Universal images in KTX 2.0 files, decoded by a module that is loaded with the first of them. */
import basisAddress from '../../wasm/basis/heatwalk_basis_bg.wasm?url';
import { inFreshInstance, moduleOnDemand } from './demand';
import { bitmapOf } from './texels';

/** How a file of KTX 2.0 begins. */
const IDENTIFIER = [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30];

const decoder = moduleOnDemand(() => import('../../wasm/basis/heatwalk_basis.js'), basisAddress);

export function isBasis(bytes: Uint8Array): boolean {
  return IDENTIFIER.every((byte, index) => bytes[index] === byte);
}

/** The image with at most `largest` texels either way that the file has, else its smallest. */
export function decodeBasis(bytes: Uint8Array, largest: number): Promise<ImageBitmap> {
  return inFreshInstance(decoder, ({ BasisImage }) => {
    const image = BasisImage.decode(bytes, largest);
    const { width, height } = image;
    const texels = image.take_texels();
    return bitmapOf(new Uint8ClampedArray(texels.buffer as ArrayBuffer), width, height);
  });
}
