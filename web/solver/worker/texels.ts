/** Images that are made of others, texel by texel. */

/** A channel of an image, 0 to 3; 1 everywhere where there is no image. */
export interface Channel {
  image: ImageBitmap | null;
  channel: number;
}

/** Mean difference of red and blue, of 255, up to which an image is gray: compression leaves some, maps of normals have 127. */
const GRAY = 32;

/** From black to white, as a share of the image's width: maps of bumps have no unit, and their bumps are shallow. */
const RELIEF = 0.01;

/** An image whose red, green, blue and alpha are these channels; null where none has an image. */
export function ofChannels(channels: readonly Channel[]): Promise<ImageBitmap> | null {
  const sources = channels.flatMap(({ image }) => image ?? []);
  if (sources.length === 0) return null;
  const width = Math.max(...sources.map((source) => source.width));
  const height = Math.max(...sources.map((source) => source.height));
  const made = new Uint8ClampedArray(4 * width * height).fill(255);
  const read = new Map([...new Set(sources)].map((source) => [source, texelsOf(source, width, height).data]));
  channels.forEach(({ image, channel }, target) => {
    const texels = image && read.get(image);
    if (!texels) return;
    for (let at = 0; at < texels.length; at += 4) made[at + target] = texels[at + channel] ?? 0;
  });
  return bitmapOf(made, width, height);
}

/** Normals of the surface whose heights an image in shades of gray tells, as glTF has them; another image as it is. */
export async function normalsOfHeights(image: ImageBitmap): Promise<ImageBitmap> {
  const { width, height } = image;
  const { data } = texelsOf(image, width, height);
  let difference = 0;
  const texel = (at: number) => data[at] ?? 0;
  for (let at = 0; at < data.length; at += 4) difference += Math.abs(texel(at) - texel(at + 2));
  if (difference > (GRAY * data.length) / 4) return image;
  image.close();
  const normals = new Uint8ClampedArray(data.length).fill(255);
  const heightAt = (x: number, y: number) => texel(4 * (((y + height) % height) * width + ((x + width) % width))) / 255;
  const slope = (RELIEF * width) / 2;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      // Green points up, rows go down.
      const right = slope * (heightAt(x - 1, y) - heightAt(x + 1, y));
      const up = slope * (heightAt(x, y + 1) - heightAt(x, y - 1));
      const length = Math.hypot(right, up, 1);
      const at = 4 * (y * width + x);
      [right, up, 1].forEach((part, axis) => (normals[at + axis] = 127.5 * (part / length + 1)));
    }
  }
  return bitmapOf(normals, width, height);
}

function texelsOf(image: ImageBitmap, width: number, height: number): ImageData {
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('there is no canvas');
  context.drawImage(image, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

/** `height × width × 4`: red, green, blue and alpha. */
export function bitmapOf(texels: Uint8ClampedArray<ArrayBuffer>, width: number, height: number): Promise<ImageBitmap> {
  const options: ImageBitmapOptions = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };
  return createImageBitmap(new ImageData(texels, width, height), options);
}
