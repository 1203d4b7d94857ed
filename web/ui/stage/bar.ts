/** Lines are this far apart in a bar, or left out, since they would hide the colors; CSS pixels. */
export const LEAST_APART = 3;

/** A bar of the colors. */
export interface Bar {
  title: string;
  ticks: { at: number; text: string }[];
  /** Gives the color at a share of the bar; `pixels`: of the whole bar, `scale` of them a CSS pixel. */
  colours: (pixels: number, scale: number) => (share: number) => string;
  /** What the colors depend on beside the rest. */
  key: string;
}
