/** Saves images of the scene, and what is saved as files. */
import { Failure } from '../error';
import type { View } from './view';
import { t } from '../texts';

/** A PNG of the view with its overprints and, if `captioned`, its captions, `scale` times as large as on the screen. */
export async function png(view: View, scale: number, clear: boolean, captioned: boolean): Promise<Blob> {
  const canvas = await paint(view, scale, clear, captioned);
  return canvas.convertToBlob({ type: 'image/png' });
}

/** The same on a canvas: on one that is given, or on another, as large as the picture. */
export async function paint(
  view: View,
  scale: number,
  clear: boolean,
  captioned: boolean,
  given?: OffscreenCanvas,
): Promise<OffscreenCanvas> {
  const picture = await view.capture(scale, clear);
  const canvas = given ?? new OffscreenCanvas(picture.width, picture.height);
  // Pixels come and go: a graphics device would gain nothing, and some leave traces around shapes that they draw.
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Failure(t('This browser cannot write the image into a file. Try another browser.'));
  context.resetTransform();
  context.putImageData(picture, 0, 0);
  const { left, top, width, height } = view.stage.getBoundingClientRect();
  const [x, y] = view.centre;
  const pixels = picture.width / width;
  context.scale(pixels, picture.height / height);
  context.save();
  // Pictures have no panel beside the model.
  context.translate(left + width / 2 - x, top + height / 2 - y);
  for (const print of view.overprints) print(context);
  context.restore();
  if (captioned) for (const print of view.captions) print(context, width, height, pixels);
  return canvas;
}

/** Saves a file through the browser's download. */
export function save(file: Blob, name: string): void {
  const address = URL.createObjectURL(file);
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // The browser has read it by then.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
