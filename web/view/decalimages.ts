/** The images of decals: those of the page, drawn when they are first wanted, and those of files. */
import { Failure } from '../error';
import { DECAL_IMAGES, type DecalImage } from '../state/decals';
import { t } from '../texts';

/** Pixels along a side of the page's own. */
const SIDE = 512;
/** The longer side of a file's image; a larger one is made smaller. */
const LONGEST = 1024;

const INK = '#14202b';
const PAPER = '#f6f1e4';
const ACCENT = '#d8402f';

type Pen = OffscreenCanvasRenderingContext2D;

/** Each in a square from −1 to 1, y downward. */
const DRAWINGS: Readonly<Record<DecalImage, (pen: Pen) => void>> = {
  compass: (pen) => {
    disc(pen, 0.98, PAPER);
    ring(pen, 0.94, 0.04, INK);
    ring(pen, 0.72, 0.015, INK);
    for (let index = 0; index < 72; index++) {
      const [from, to] = [index % 6 === 0 ? 0.76 : 0.84, 0.9];
      spoke(pen, (index * Math.PI) / 36, from, to, index % 6 === 0 ? 0.025 : 0.012, INK);
    }
    for (let index = 0; index < 8; index++) {
      const isMain = index % 2 === 0;
      pen.save();
      pen.rotate((index * Math.PI) / 4);
      needle(pen, isMain ? 0.7 : 0.42, isMain ? 0.13 : 0.09, index === 0 ? ACCENT : INK);
      pen.restore();
    }
    disc(pen, 0.06, PAPER);
    ring(pen, 0.06, 0.02, INK);
  },
  polar: (pen) => {
    for (let index = 12; index > 0; index--) disc(pen, (0.98 * index) / 12, index % 2 === 0 ? INK : PAPER);
    for (let index = 0; index < 12; index++) {
      spoke(pen, (index * Math.PI) / 6, 0, 0.98, 0.014, index === 0 ? ACCENT : '#2b7de0');
    }
  },
  grid: (pen) => {
    const step = 0.25;
    for (let row = 0; row < 8; row++) {
      for (let column = 0; column < 8; column++) {
        pen.fillStyle = (row + column) % 2 === 0 ? INK : PAPER;
        pen.fillRect(step * column - 1, step * row - 1, step, step);
      }
    }
    pen.fillStyle = ACCENT;
    pen.fillRect(-1, -0.02, 2, 0.04);
    pen.fillRect(-0.02, -1, 0.04, 2);
  },
  star: (pen) => {
    pen.beginPath();
    for (let index = 0; index < 10; index++) {
      const [angle, radius] = [(index * Math.PI) / 5 - Math.PI / 2, index % 2 === 0 ? 0.96 : 0.42];
      pen.lineTo(radius * Math.cos(angle), radius * Math.sin(angle));
    }
    pen.closePath();
    pen.fillStyle = '#f5b301';
    pen.fill();
    pen.lineWidth = 0.05;
    pen.lineJoin = 'round';
    pen.strokeStyle = INK;
    pen.stroke();
  },
};

const made = new Map<string, Promise<ImageBitmap>>();

/** An image by its name in a scene. `file`: its bytes, of one that is from a file. */
export function decalImage(name: string, file: (name: string) => Promise<Blob>): Promise<ImageBitmap> {
  let image = made.get(name);
  if (!image) {
    const own = DECAL_IMAGES.find((one) => one === name);
    image = own ? Promise.resolve(drawn(own)) : file(name).then(decoded);
    image.catch(() => made.delete(name));
    made.set(name, image);
  }
  return image;
}

/** As a PNG. */
export async function pngOf(image: ImageBitmap): Promise<Uint8Array<ArrayBuffer>> {
  const canvas = new OffscreenCanvas(image.width, image.height);
  penOf(canvas).drawImage(image, 0, 0);
  const blob = await canvas.convertToBlob({ type: 'image/png' });
  return new Uint8Array(await blob.arrayBuffer());
}

function drawn(name: DecalImage): ImageBitmap {
  const canvas = new OffscreenCanvas(SIDE, SIDE);
  const pen = penOf(canvas);
  pen.translate(SIDE / 2, SIDE / 2);
  pen.scale(SIDE / 2, SIDE / 2);
  DRAWINGS[name](pen);
  return canvas.transferToImageBitmap();
}

async function decoded(file: Blob): Promise<ImageBitmap> {
  let image: ImageBitmap;
  try {
    image = await (file.type === 'image/svg+xml' ? rendered(file) : createImageBitmap(file));
  } catch {
    throw new Failure(t('The browser cannot read this image. Save it as PNG or JPEG.'));
  }
  const share = LONGEST / Math.max(image.width, image.height);
  if (share >= 1) return image;
  const [width, height] = [image.width, image.height].map((side) => Math.max(1, Math.round(share * side)));
  const canvas = new OffscreenCanvas(width ?? 1, height ?? 1);
  penOf(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
  image.close();
  return canvas.transferToImageBitmap();
}

/** What browsers do not decode without a document. */
async function rendered(file: Blob): Promise<ImageBitmap> {
  const address = URL.createObjectURL(file);
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const share = LONGEST / Math.max(image.naturalWidth, image.naturalHeight);
    const canvas = new OffscreenCanvas(share * image.naturalWidth, share * image.naturalHeight);
    penOf(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas.transferToImageBitmap();
  } finally {
    URL.revokeObjectURL(address);
  }
}

function penOf(canvas: OffscreenCanvas): Pen {
  const pen = canvas.getContext('2d');
  if (!pen) throw new Failure(t('This browser cannot draw images beside the page. Try another browser.'));
  return pen;
}

function disc(pen: Pen, radius: number, colour: string): void {
  pen.beginPath();
  pen.arc(0, 0, radius, 0, 2 * Math.PI);
  pen.fillStyle = colour;
  pen.fill();
}

function ring(pen: Pen, radius: number, width: number, colour: string): void {
  pen.beginPath();
  pen.arc(0, 0, radius, 0, 2 * Math.PI);
  pen.lineWidth = width;
  pen.strokeStyle = colour;
  pen.stroke();
}

/** From the right on, clockwise. */
function spoke(pen: Pen, angle: number, from: number, to: number, width: number, colour: string): void {
  pen.beginPath();
  pen.moveTo(from * Math.cos(angle), from * Math.sin(angle));
  pen.lineTo(to * Math.cos(angle), to * Math.sin(angle));
  pen.lineWidth = width;
  pen.strokeStyle = colour;
  pen.stroke();
}

/** Upward: one half is filled, the other one is paper. */
function needle(pen: Pen, length: number, width: number, colour: string): void {
  for (const side of [1, -1]) {
    pen.beginPath();
    pen.moveTo(0, -length);
    pen.lineTo(side * width, -width);
    pen.lineTo(0, 0);
    pen.closePath();
    pen.fillStyle = side > 0 ? colour : PAPER;
    pen.fill();
    pen.lineWidth = 0.012;
    pen.strokeStyle = INK;
    pen.stroke();
  }
}
