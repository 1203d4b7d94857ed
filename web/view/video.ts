/** Writes a video of the view frame by frame, however long each takes to be drawn: it is as long as it has frames. */
import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  QUALITY_HIGH,
  type VideoCodec,
  WebMOutputFormat,
} from 'mediabunny';
import { Failure } from '../error';
import { t } from '../texts';
import { paint } from './picture';
import type { View } from './view';

export const FRAMES_A_SECOND = 30;

/** What plays nearly everywhere first. */
const FORMATS: readonly { make: () => Mp4OutputFormat | WebMOutputFormat; codecs: VideoCodec[] }[] = [
  { make: () => new Mp4OutputFormat({ fastStart: 'in-memory' }), codecs: ['avc'] },
  { make: () => new WebMOutputFormat(), codecs: ['vp9', 'av1', 'vp8'] },
];

export interface Video {
  file: Blob;
  /** Of the name of its file. */
  ending: string;
  seconds: number;
}

/** `next` makes the view show the frame of a number; false where there is none any more. Rejects where `signal` is aborted. */
export async function video(
  view: View,
  next: (frame: number) => Promise<boolean>,
  signal: AbortSignal,
): Promise<Video> {
  if (!(await next(0))) throw new Failure(t('There is nothing to record.'));
  const first = await paint(view, 1, false, true);
  // Encoders want even sizes.
  const [width, height] = [first.width & ~1, first.height & ~1];
  const canvas = new OffscreenCanvas(width, height);
  const { format, codec } = await encoderFor(width, height);
  const target = new BufferTarget();
  const output = new Output({ format, target });
  const source = new CanvasSource(canvas, { codec, quality: QUALITY_HIGH });
  output.addVideoTrack(source, { frameRate: FRAMES_A_SECOND });
  let frame = 0;
  try {
    await output.start();
    do {
      signal.throwIfAborted();
      await paint(view, 1, false, true, canvas);
      await source.add(frame / FRAMES_A_SECOND, 1 / FRAMES_A_SECOND);
      frame += 1;
    } while (await next(frame));
    await output.finalize();
  } catch (error) {
    await output.cancel();
    throw error;
  }
  if (!target.buffer) throw new Failure(t('The browser stopped recording. Try again, or try another browser.'));
  const file = new Blob([target.buffer], { type: format.mimeType });
  return { file, ending: format.fileExtension, seconds: frame / FRAMES_A_SECOND };
}

/** The first format whose pictures of this size the browser can encode. */
async function encoderFor(width: number, height: number) {
  for (const { make, codecs } of FORMATS) {
    const codec = await getFirstEncodableVideoCodec(codecs, { width, height, quality: QUALITY_HIGH });
    if (codec) return { format: make(), codec };
  }
  throw new Failure(
    t('This browser has no encoder for videos of this size. Try a smaller window, or another browser.'),
  );
}
