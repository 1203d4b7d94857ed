/** Decodes the images of a file. */
import type { EncodedImage } from '../../wasm/solver/heatwalk_worker.js';
import { decodeBasis, isBasis } from './basis';
import { type Channel, normalsOfHeights, ofChannels } from './texels';

/** Texels either way: what graphics devices take, and more than a model on a screen shows. */
const LARGEST = 4096;

/** As the file has it: colors are converted and alpha is applied by the renderer. */
const AS_IT_IS: ImageBitmapOptions = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };

export interface DecodedImages {
  /** Null for an image that is missing or cannot be decoded: what needs it is shown without. */
  images: (ImageBitmap | null)[];
  /** Names of those that are there and cannot be decoded. */
  undecoded: string[];
}

export async function decodeImages(encoded: readonly EncodedImage[]): Promise<DecodedImages> {
  const decoded = await Promise.all(encoded.map(decodeImage));
  const undecoded = encoded.filter(({ bytes }, index) => bytes.length > 0 && decoded[index] === null);
  const made = encoded.map(({ channels }) => channelsOf(channels, decoded)).map((channels) => ofChannels(channels));
  const images = await Promise.all(made.map((image, index) => image ?? decoded[index] ?? null));
  return { images, undecoded: undecoded.map(({ name }) => name) };
}

/** Images and their channels as the file pairs them. */
function channelsOf(pairs: Int32Array, images: readonly (ImageBitmap | null)[]): Channel[] {
  return Array.from({ length: pairs.length / 2 }, (_, index) => {
    const [image = -1, channel = 0] = pairs.subarray(2 * index, 2 * index + 2);
    return { image: images[image] ?? null, channel };
  });
}

async function decodeImage({ mediaType, bytes, mayBeHeights }: EncodedImage): Promise<ImageBitmap | null> {
  if (bytes.length === 0) return null;
  try {
    const whole = isBasis(bytes)
      ? await decodeBasis(bytes, LARGEST)
      : await createImageBitmap(new Blob([bytes as BlobPart], { type: mediaType }), AS_IT_IS);
    const excess = Math.max(whole.width, whole.height) / LARGEST;
    if (excess <= 1) return mayBeHeights ? await normalsOfHeights(whole) : whole;
    const smaller = await createImageBitmap(whole, {
      ...AS_IT_IS,
      resizeWidth: Math.max(1, Math.round(whole.width / excess)),
      resizeHeight: Math.max(1, Math.round(whole.height / excess)),
      resizeQuality: 'high',
    });
    whole.close();
    return mayBeHeights ? await normalsOfHeights(smaller) : smaller;
  } catch {
    return null;
  }
}
