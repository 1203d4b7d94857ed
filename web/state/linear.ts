/** Linear RGB, from 0 to 1, as a color in CSS. */
export function cssOf([red = 0, green = 0, blue = 0]: readonly number[]): string {
  const encoded = [red, green, blue].map((value) =>
    value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055,
  );
  return `rgb(${encoded.map((value) => Math.round(255 * value)).join(' ')})`;
}
