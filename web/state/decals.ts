/** Images on the surface. */
import { type ModelLength, ofModel } from '../length';
import type { LaidDecal, MeshPoint } from '../protocol';
import { POINT } from './points';
import { AMOUNT, type Codec, number } from './text';

/** Those that the page brings along. */
export const DECAL_IMAGES = ['compass', 'polar', 'grid', 'star'] as const;
export type DecalImage = (typeof DECAL_IMAGES)[number];

export interface Decal {
  /** Where its middle is. */
  place: MeshPoint;
  /** Half of its longer side, along the surface. */
  size: ModelLength;
  /** By how much it is turned counterclockwise, seen from outside, in degrees; at 0 it stands upright. */
  angle: number;
  /** One of the page's, or a file's: `file-` and the beginning of its SHA-256, in hexadecimal digits. */
  image: string;
}

/** One as it lies: which of the scene's it is, and was, and its image. */
export interface LaidImage {
  index: number;
  decal: Decal;
  image: ImageBitmap;
  laid: LaidDecal;
}

export const MOST_DECALS = 20;

const IMAGE = new RegExp(`^(${DECAL_IMAGES.join('|')}|file-[0-9a-f]{16})$`);

/** Whether an image is one of a file. */
export function isOfFile(image: string): boolean {
  return image.startsWith('file-');
}

/** Place, size, angle and image with commas between them, decals with semicolons; undefined where anything is no decal. */
export const DECALS: Codec<readonly Decal[]> = {
  encode: (decals) =>
    decals
      .map(({ place, size, angle, image }) => [POINT.encode(place), AMOUNT.encode(size), number(angle), image].join())
      .join(';') || 'none',
  parse: (text) => {
    const decals = text === 'none' ? [] : text.split(';').map(parseDecal);
    return decals.length <= MOST_DECALS && decals.every((decal) => decal !== undefined) ? decals : undefined;
  },
};

function parseDecal(text: string): Decal | undefined {
  const [at = '', long = '', turned = '', image = '', ...more] = text.split(',');
  const [place, size, angle] = [POINT.parse(at), AMOUNT.parse(long), Number(turned || NaN)];
  const isDecal = place && size && Number.isFinite(angle) && IMAGE.test(image) && more.length === 0;
  return isDecal ? { place, size: ofModel(size), angle, image } : undefined;
}
