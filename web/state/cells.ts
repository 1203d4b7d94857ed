/** Cells that are shown, and their colors. */
import type { FoundCells } from '../protocol';
import { cssOf } from './linear';
import type { Vector } from './vector';

/** `outdated`: while others are found. */
export interface ShownCells extends FoundCells {
  outdated?: boolean;
}

/** Between the hues of one cell and the next, in turns: the golden angle, so that few cells and many are all told apart. */
const TURN = (3 - Math.sqrt(5)) / 2;
const FIRST_HUE = 0.4;
/** In OKLCH (B. Ottosson, "A perceptual color space for image processing", 2020); cells take the lightnesses in turn. */
const LIGHTNESSES = [0.72, 0.6, 0.8] as const;
const CHROMA = 0.12;

/** Of the cell with a number, linear RGB. */
export function linearColourOfCell(cell: number): Vector {
  const hue = 2 * Math.PI * (FIRST_HUE + cell * TURN);
  const lightness = LIGHTNESSES[cell % LIGHTNESSES.length] ?? LIGHTNESSES[0];
  const [a, b] = [CHROMA * Math.cos(hue), CHROMA * Math.sin(hue)];
  const cube = (u: number, v: number) => (lightness + u * a + v * b) ** 3;
  const [l, m, s] = [
    cube(0.3963377774, 0.2158037573),
    cube(-0.1055613458, -0.0638541728),
    cube(-0.0894841775, -1.291485548),
  ];
  const mixed: Vector = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return mixed.map((value) => Math.min(1, Math.max(0, value))) as unknown as Vector;
}

/** The same in CSS. */
export function colourOfCell(cell: number): string {
  return cssOf(linearColourOfCell(cell));
}
