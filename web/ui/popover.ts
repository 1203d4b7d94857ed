/** Where a menu stands that a button opens. */

/** Between the button and its menu, and from the edges of the window; CSS pixels. */
const GAP = 8;

/** Places a menu that is shown at its button, as far as the window has room. */
export function placeMenu(menu: HTMLElement, button: HTMLElement, side: 'above' | 'below' | 'beside'): void {
  const { left, right, top, bottom } = button.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = menu;
  const x = side === 'beside' ? right + GAP : left;
  const y = { above: top - height - GAP, below: bottom + GAP, beside: bottom - height }[side];
  menu.style.left = `${Math.max(GAP, Math.min(x, innerWidth - width - GAP))}px`;
  menu.style.top = `${Math.max(GAP, Math.min(y, innerHeight - height - GAP))}px`;
}
