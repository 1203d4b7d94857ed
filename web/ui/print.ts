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
  const { backgroundColor, borderTopColor, borderTopWidth, color, font } = getComputedStyle(element);
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
  context.fillText(element.textContent ?? '', x + width / 2, y + height / 2);
}
