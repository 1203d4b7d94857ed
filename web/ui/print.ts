/** The words of the page on a saved picture. */
import type { PlaneContext } from '../view/view';

interface Frame {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Prints the text of an element as the element is styled, into a frame. */
export function printLabel(context: PlaneContext, element: Element, { x, y, width, height }: Frame): void {
  const { backgroundColor, borderTopColor, borderTopWidth, color, font, lineHeight } = getComputedStyle(element);
  context.beginPath();
  context.roundRect(x, y, width, height, 4);
  context.fillStyle = backgroundColor;
  context.fill();
  if (borderTopWidth !== '0px') {
    context.lineWidth = 1;
    context.strokeStyle = borderTopColor;
    context.stroke();
  }
  context.font = font;
  context.fillStyle = color;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const down = Number.parseFloat(lineHeight);
  const lines = height < 2 * down ? [element.textContent ?? ''] : linesOf(element).slice(0, Math.round(height / down));
  const first = y + (height - (lines.length - 1) * down) / 2;
  lines.forEach((line, index) => context.fillText(line, x + width / 2, first + index * down));
}

/** Its words as they are broken into lines. */
function linesOf({ firstChild, textContent }: Element): string[] {
  const letters = textContent ?? '';
  if (!firstChild) return [letters];
  const range = new Range();
  const starts = [0];
  let line = Infinity;
  for (let at = 0; at < letters.length; at++) {
    range.setStart(firstChild, at);
    range.setEnd(firstChild, at + 1);
    const { top, height } = range.getBoundingClientRect();
    if (top > line + height / 2) starts.push(at);
    // The blank at which a line is broken takes no room.
    if (height > 0) line = top;
  }
  return starts.map((start, index) => letters.slice(start, starts[index + 1]).trim());
}
