/** Saves images and videos of the scene. */
import { Failure } from '../error';
import type { View } from './view';
import { t } from '../texts';

/** Whether the browser can record a canvas. */
export const canRecord = 'MediaRecorder' in globalThis && 'captureStream' in HTMLCanvasElement.prototype;

const FRAMES_A_SECOND = 60;
const BITS_A_SECOND = 12_000_000;

/** A PNG of the view with its overprints and, if `captioned`, its captions, `scale` times as large as on the screen. */
export async function png(view: View, scale: number, clear: boolean, captioned: boolean): Promise<Blob> {
  const picture = await view.capture(scale, clear);
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  // Pixels come and go: a graphics device would gain nothing, and some leave traces around shapes that they draw.
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Failure(t('This browser cannot write the image into a file. Try another browser.'));
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
  return canvas.convertToBlob({ type: 'image/png' });
}

/** A WebM video of the view with its overprints until `end`, with all pixels. */
export async function video(view: View, end: Promise<unknown>): Promise<Blob> {
  const { drawsAllPixels } = view;
  view.drawsAllPixels = true;
  view.adapt(1);
  try {
    return await record(view.overprints.length > 0 ? overprinted(view) : view.canvas, end);
  } finally {
    view.drawsAllPixels = drawsAllPixels;
    view.looker = null;
  }
}

/** A canvas that has each frame of the view, and its overprints, until nobody looks at the view any more. */
function overprinted(view: View): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  if (!context) throw new Failure(t('This browser cannot write the image into a file. Try another browser.'));
  [canvas.width, canvas.height] = [view.canvas.width, view.canvas.height];
  view.looker = () => {
    const { width, height } = view.stage.getBoundingClientRect();
    context.resetTransform();
    context.drawImage(view.canvas, 0, 0, canvas.width, canvas.height);
    context.scale(canvas.width / width, canvas.height / height);
    for (const print of view.overprints) print(context);
  };
  return canvas;
}

async function record(canvas: HTMLCanvasElement, end: Promise<unknown>): Promise<Blob> {
  const recorder = new MediaRecorder(canvas.captureStream(FRAMES_A_SECOND), {
    mimeType: 'video/webm',
    videoBitsPerSecond: BITS_A_SECOND,
  });
  const chunks: Blob[] = [];
  const recorded = new Promise<void>((resolve, reject) => {
    recorder.addEventListener('dataavailable', ({ data }) => chunks.push(data));
    recorder.addEventListener('stop', () => resolve());
    recorder.addEventListener('error', () =>
      reject(new Failure(t('The browser stopped recording. Try again, or try another browser.'))),
    );
  });
  recorder.start();
  const stop = () => {
    if (recorder.state !== 'inactive') recorder.stop();
  };
  void end.then(stop, stop);
  await recorded;
  return new Blob(chunks, { type: 'video/webm' });
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
