/** Decodes the images of a file. */
import type { Plain } from '../../protocol';
import type { EncodedImage } from '../../wasm/solver/heatwalk_worker.js';

/** Texels either way: what graphics devices take, and more than a model on a screen shows. */
const LARGEST = 4096;

/** As the file has it: colors are converted and alpha is applied by the renderer. */
const AS_IT_IS: ImageBitmapOptions = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };

/** Null where the browser cannot decode it: what needs it is shown without. */
export async function decodeImage({ mediaType, bytes }: Plain<EncodedImage>): Promise<ImageBitmap | null> {
  try {
    const whole = await createImageBitmap(new Blob([bytes as BlobPart], { type: mediaType }), AS_IT_IS);
    const excess = Math.max(whole.width, whole.height) / LARGEST;
    if (excess <= 1) return whole;
    const smaller = await createImageBitmap(whole, {
      ...AS_IT_IS,
      resizeWidth: Math.max(1, Math.round(whole.width / excess)),
      resizeHeight: Math.max(1, Math.round(whole.height / excess)),
      resizeQuality: 'high',
    });
    whole.close();
    return smaller;
  } catch {
    return null;
  }
}
