/** Draws the legend, on the page as on saved pictures. All numbers are CSS pixels. */
import type { PlaneContext } from '../../view/view';
import type { Bar } from './bar';
import type { Axis, Content, North } from './content';
import type { Vector } from '../../state/vector';

export interface Look {
  /** Size and family. */
  font: string;
  text: string;
  plate: string;
  line: string;
  /** Of the axes by their names; the text's where a name has none. */
  axes: Readonly<Record<string, string>>;
}

type Point = [right: number, down: number];

const BOLD = '600 ';
const LINE = 16;
const PADDING = 8;
const BAR = { wide: { width: 14, height: 144 }, compact: { width: 10, height: 48 } } as const;
const TICK = 4;
/** Half the size of a cross of axes, and its arms. */
const CROSS = 26;
const ARM = 17;
/** The room of an axis's letter. */
const NAME = 10;
/** Half the width of the needle that points north. */
const NEEDLE = 6;
/** Between the numbers and the cross. */
const APART = 12;
const RADIUS = 8;

const hasCross = ({ axes, north }: Content) => axes.length > 0 || north !== null;
const formOf = ({ isCompact }: Content) => BAR[isCompact ? 'compact' : 'wide'];

/** Its width and height. */
export function sizeOf(context: PlaneContext, content: Content, font: string): [number, number] {
  const { bar, spacing, scale } = content;
  const form = formOf(content);
  const cross = hasCross(content) ? 2 * CROSS : 0;
  const wide = (text: string, weight = '') => {
    context.font = weight + font;
    return context.measureText(text).width;
  };
  const widths = [0];
  let height = 2 * PADDING;
  if (bar) {
    const numbers = Math.max(...bar.ticks.map(({ text }) => form.width + TICK + 4 + wide(text)));
    widths.push(wide(bar.title, BOLD), numbers + (cross && APART + cross));
    height += LINE + 4 + form.height + 8;
  } else height += cross;
  if (spacing) {
    widths.push(wide(spacing));
    height += LINE;
  }
  if (scale) {
    widths.push(scale.pixels, wide(scale.text));
    height += LINE + 8;
  }
  if (cross) widths.push(cross);
  return [Math.ceil(Math.max(...widths)) + 2 * PADDING, Math.ceil(height)];
}

/** What the page has below it. */
export function drawPlate(context: PlaneContext, content: Content, { font, plate, line }: Look): void {
  const [width, height] = sizeOf(context, content, font);
  context.beginPath();
  context.roundRect(-0.5, -0.5, width + 1, height + 1, RADIUS);
  context.fillStyle = plate;
  context.fill();
  context.strokeStyle = line;
  context.lineWidth = 1;
  context.stroke();
}

/** At the origin of the context, of which `pixels` of the device are one of CSS. */
export function drawLegend(context: PlaneContext, content: Content, look: Look, pixels: number): void {
  const [width] = sizeOf(context, content, look.font);
  context.save();
  context.translate(PADDING, PADDING);
  context.textBaseline = 'middle';
  context.textAlign = 'left';
  context.fillStyle = context.strokeStyle = look.text;
  if (content.bar) drawBar(context, content.bar, formOf(content), look.font, pixels);
  context.fillStyle = look.text;
  context.font = look.font;
  if (hasCross(content)) {
    // Beside the bar, at its lower end.
    const [right, down] = content.bar ? [width - 2 * PADDING - CROSS, -8 - CROSS] : [CROSS, CROSS];
    context.save();
    context.translate(right, down);
    if (content.north) drawNorth(context, content.north, look);
    else drawAxes(context, content.axes, look);
    context.restore();
    if (!content.bar) context.translate(0, 2 * CROSS);
  }
  if (content.spacing) {
    context.fillText(content.spacing, 0, LINE / 2);
    context.translate(0, LINE);
  }
  if (content.scale) {
    const { pixels: length, text } = content.scale;
    context.fillText(text, 0, LINE / 2);
    context.beginPath();
    context.moveTo(0.75, LINE);
    context.lineTo(0.75, LINE + 5);
    context.lineTo(length - 0.75, LINE + 5);
    context.lineTo(length - 0.75, LINE);
    context.lineWidth = 1.5;
    context.stroke();
  }
  context.restore();
}

function drawBar(
  context: PlaneContext,
  { title, ticks, colours }: Bar,
  { width, height }: { width: number; height: number },
  font: string,
  pixels: number,
): void {
  context.font = BOLD + font;
  context.fillText(title, 0, LINE / 2);
  context.translate(0, LINE + 4);
  const rows = Math.round(height * pixels);
  const colour = colours(rows, pixels);
  for (let row = 0; row < rows; row++) {
    context.fillStyle = colour(1 - (row + 0.5) / rows);
    // The next one covers what is too much.
    context.fillRect(0, (row / rows) * height, width, Math.min(2 / pixels, height - (row / rows) * height));
  }
  context.lineWidth = 1;
  context.strokeRect(0.5, 0.5, width - 1, height - 1);
  context.font = font;
  context.fillStyle = context.strokeStyle;
  for (const { at, text } of ticks) {
    const y = Math.min(height - 0.5, Math.max(0.5, height * (1 - at)));
    context.beginPath();
    context.moveTo(width, y);
    context.lineTo(width + TICK, y);
    context.stroke();
    context.fillText(text, width + TICK + 4, y);
  }
  context.translate(0, height + 8);
}

function drawAxes(context: PlaneContext, axes: readonly Axis[], look: Look): void {
  context.textAlign = 'center';
  context.lineWidth = 2;
  context.lineCap = 'round';
  const names: Point[] = [];
  for (const { name, direction } of axes) {
    const [x, y] = direction;
    context.beginPath();
    context.moveTo(0, 0);
    context.lineTo(ARM * x, ARM * y);
    context.strokeStyle = look.axes[name] ?? look.text;
    context.stroke();
    const place = nameAt(direction);
    // Axes of a plane that the eye is in lie on one line.
    while (names.some((other) => isClose(other, place))) place[1] += 1;
    names.push(place);
    context.fillText(name, ...place);
  }
}

function isClose(one: Point, other: Point): boolean {
  return Math.abs(one[0] - other[0]) < NAME && Math.abs(one[1] - other[1]) < NAME;
}

/** Beyond the end of an axis; beside the middle where it points towards the eye. */
function nameAt([x, y]: Vector): Point {
  const length = Math.hypot(x, y);
  const away = ARM * length + 7;
  return length > 0.1 ? [(away * x) / length, (away * y) / length] : [away, 0];
}

/** A needle that lies on the ground, its northern half filled. */
function drawNorth(context: PlaneContext, { north, east }: North, look: Look): void {
  context.textAlign = 'center';
  context.lineWidth = 1.5;
  context.lineJoin = 'round';
  context.strokeStyle = look.text;
  for (const end of [ARM, -ARM]) {
    context.beginPath();
    context.moveTo(NEEDLE * east[0], NEEDLE * east[1]);
    context.lineTo(end * north[0], end * north[1]);
    context.lineTo(-NEEDLE * east[0], -NEEDLE * east[1]);
    context.closePath();
    if (end > 0) context.fill();
    context.stroke();
  }
  context.fillText('N', ...nameAt(north));
}
