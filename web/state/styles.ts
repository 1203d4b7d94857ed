/** Preset styles: the material of the surface, the pattern that shows the distance, and the lighting. */
import { interpolateInferno, interpolateMagma, interpolateTurbo, interpolateViridis } from 'd3-scale-chromatic';
import type { StripeBlend, Surroundings } from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu';
import { entry } from './entry';
import { between } from './vector';

/** 0 to 1 to a CSS colour, `#rrggbb` or `rgb(r, g, b)`. */
type Interpolator = (t: number) => string;

const RAMPS = {
  chalk: stops('#fffdf8', '#f3ecdf', '#e3d8c6'),
  paper: stops('#ffffff', '#e9eef2', '#cfd9e2'),
  bone: stops('#fbf7ec', '#f1e8d5', '#e2d3b8'),
  porcelain: stops('#ffffff', '#f2f5fa', '#e4eaf4'),
  candy: stops('#fff6ee', '#ffd9cf', '#ff9f92'),
  citrus: stops('#f4541d', '#ffab1f', '#ffee3d', '#ffffff'),
  gold: stops('#ffd978', '#f4bf58', '#e0a040'),
  copper: stops('#f7b08c', '#d98663', '#b8623f'),
  coal: stops('#55514d', '#413e3c', '#302e2f'),
  slate: stops('#4e5a5a', '#3d4a4b', '#2f3c3f'),
  ink: stops('#1c1830', '#17162b', '#101423'),
  ember: stops('#fff04a', '#ffb01e', '#f2501d', '#b3181f', '#3c0f14', '#190d10'),
  magma: stops('#ffd84a', '#ff8a24', '#ff3b1f', '#c31628', '#6d1026'),
  amethyst: stops('#b52ee6', '#8f24cf', '#6b1fa8', '#c3b5cf'),
  ocean: stops('#ffffff', '#bfeaf5', '#7fb2f2', '#4a63ee', '#2a2fc4'),
  glow: stops('#37ffd0', '#3fa8ff', '#a45cff', '#ff4fb4'),
  lava: (t: number) => interpolateInferno(0.95 - 0.75 * t),
  // The middle of ColorBrewer's Blues and YlGnBu.
  water: stops('#dfecf7', '#cbdff1', '#b1d2e8', '#8ec1de', '#69acd4', '#4995c8', '#2d7dbb', '#1764aa', '#0a4a90'),
  lagoon: stops('#f3fac1', '#dbf1b4', '#b3e1b6', '#7ecdbc', '#4db8c1', '#2c9ec0', '#207ab5', '#2255a3', '#1f368c'),
  dusk: (t: number) => interpolateMagma(0.22 + 0.7 * t),
  neon: stops('#2a0f5c', '#4b1a8f', '#21308f', '#0b4f86', '#0a6d75'),
  viridis: interpolateViridis,
  turbo: interpolateTurbo,
} satisfies Record<string, Interpolator>;

export type RampName = keyof typeof RAMPS;

export const RAMP_NAMES = Object.keys(RAMPS) as RampName[];

/** Material parameters besides the colour, 0 to 1; the glow is a factor on the colour, 0 to 3. */
export interface Finish {
  /** 0 is a dielectric, 1 a metal. */
  metalness: number;
  /** 0 is a mirror, 1 is matt. */
  roughness: number;
  /** Emission. */
  glow: number;
}

export const PATTERNS = ['bands', 'lines', 'none'] as const;
/** Stripes that cover a share of the period, thin lines with thinner ones between them, or nothing. */
export type Pattern = (typeof PATTERNS)[number];

export const SURFACE_SOURCES = ['style', 'file'] as const;
/** Whose material the surface has; that of the style where the file has none. */
export type SurfaceSource = (typeof SURFACE_SOURCES)[number];

export const BLENDS = ['contrast', 'over', 'multiply'] as const satisfies readonly StripeBlend[];
/** Whether stripes cover the material of the file, in another colour where theirs would not stand out, or their colour is a factor on its. */
export type Blend = (typeof BLENDS)[number];

export const SURROUNDINGS = ['studio', 'sky', 'night'] as const satisfies readonly Surroundings[];

/** Which channels the stripes change; `specular` gives them a metalness and a roughness of their own. */
export const MAPS = ['colour', 'normal', 'emission', 'specular'] as const;
export type MapName = (typeof MAPS)[number];

export interface Style {
  name: string;
  surfaceOf: SurfaceSource;
  blend: Blend;
  /** Colours of the surface over the distance. */
  ramp: RampName;
  /** Colour of the stripes, `#rrggbb`, or the name of a ramp. */
  stripe: string;
  pattern: Pattern;
  /** Share of a period that the stripe covers, 0 (none) to 1; lines are this share of `WIDEST_LINE`. */
  width: number;
  /** Distance from stripe to stripe, as a share of the model's diameter. */
  period: number;
  /** Shift of the stripes away from the sources, in periods, 0 to 1. */
  offset: number;
  /** 0: stripes fade over their whole width; 1: hard edges. */
  sharpness: number;
  /** Height of the stripes, in periods; negative: grooves. */
  relief: number;
  surface: Finish;
  stripes: Finish;
  /** The maps in use. */
  maps: readonly MapName[];
  surroundings: Surroundings;
  /** Rotation of the surroundings, degrees. */
  light: number;
  /** Speed of the stripes away from the sources, in periods a second. */
  flow: number;
}

/** Lowest and highest value of each number of a style. */
export const STYLE_RANGES = {
  period: [0.001, 1],
  width: [0, 1],
  offset: [0, 1],
  sharpness: [0, 1],
  relief: [-0.2, 0.2],
  light: [-180, 180],
  flow: [-2, 2],
} as const satisfies Partial<Record<keyof Style, readonly [number, number]>>;
export const STYLE_NUMBERS = Object.keys(STYLE_RANGES) as (keyof typeof STYLE_RANGES)[];

/** CSS pixels. */
export const WIDEST_LINE = 8;

const finish = (metalness: number, roughness: number, glow = 0): Finish => ({ metalness, roughness, glow });

const BASE: Omit<Style, 'name'> = {
  surfaceOf: 'style',
  blend: 'contrast',
  ramp: 'chalk',
  stripe: '#1c1d20',
  pattern: 'bands',
  width: 0.5,
  period: 0.05,
  offset: 0,
  sharpness: 0.92,
  relief: 0.02,
  surface: finish(0, 0.32),
  stripes: finish(0, 0.22),
  maps: MAPS,
  surroundings: 'studio',
  light: 0,
  flow: 0,
};

const preset = (name: string, ramp: RampName, stripe: string, change: Partial<Style>): Style => ({
  ...BASE,
  ...change,
  name,
  ramp,
  stripe,
});

/** Groove or ridge of a given shape. */
const profile = (width: number, period: number, relief: number, sharpness = 0.45): Partial<Style> => ({
  width,
  period,
  relief,
  sharpness,
});

/** Metalness, roughness and glow of the surface, and of the stripes. */
const finishes = (
  surface: Parameters<typeof finish>,
  stripes: Parameters<typeof finish>,
): Pick<Style, 'surface' | 'stripes'> => ({ surface: finish(...surface), stripes: finish(...stripes) });

/** The file's own materials under thin stripes. */
export const MODEL_STYLE = preset('model', 'chalk', '#14161a', {
  ...profile(0.16, 0.05, 0, 0.9),
  surfaceOf: 'file',
});

export const STYLES: readonly [Style, ...Style[]] = [
  preset('zebra', 'chalk', '#17181b', {}),
  MODEL_STYLE,
  preset('gold', 'gold', '#5a3a0e', { ...profile(0.16, 0.05, -0.05), ...finishes([1, 0.2], [1, 0.45]) }),
  preset('lava', 'coal', 'magma', { ...profile(0.17, 0.05, -0.05), ...finishes([0, 0.6], [0, 0.4, 0.65]) }),
  preset('bone', 'bone', '#2a3340', { ...profile(0.24, 0.045, -0.045), ...finishes([0, 0.55], [0, 0.14]) }),
  preset('water', 'ocean', '#3c4a78', { ...profile(0.14, 0.04, 0.035), ...finishes([0, 0.1], [0, 0.3]) }),
  preset('neon', 'ink', 'glow', {
    ...profile(0.16, 0.05, 0.03, 0.5),
    ...finishes([0.4, 0.28], [0, 0.4, 1.1]),
    surroundings: 'night',
  }),
  preset('porcelain', 'porcelain', '#1f46ae', {
    width: 0.2,
    relief: 0,
    ...finishes([0, 0.09], [0, 0.09]),
  }),
  preset('scientific', 'viridis', '#ffffff', { pattern: 'lines', width: 0.25, relief: 0, surface: finish(0, 0.6) }),
  preset('candy', 'candy', '#c8102e', finishes([0, 0.2], [0, 0.14])),
  preset('citrus', 'citrus', '#2b3138', { ...profile(0.14, 0.05, -0.04), ...finishes([0, 0.35], [0, 0.3]) }),
  preset('ember', 'ember', '#ffe9b0', { ...profile(0.07, 0.05, 0.02), ...finishes([0, 0.25], [0, 0.3, 0.3]) }),
  preset('amethyst', 'amethyst', '#fff3b8', { ...profile(0.1, 0.045, 0.03), ...finishes([0.35, 0.2], [0, 0.3, 0.2]) }),
  preset('jade', 'slate', '#8dff5a', { ...profile(0.12, 0.05, 0.04), ...finishes([0.3, 0.3], [0, 0.35, 0.35]) }),
  preset('copper', 'copper', '#3d1f16', { ...profile(0.3, 0.045, -0.05), ...finishes([1, 0.3], [1, 0.6]) }),
  preset('lagoon', 'lagoon', '#0b2f3a', { ...profile(0.14, 0.05, -0.03), surface: finish(0, 0.25) }),
  preset('dusk', 'dusk', '#fff1d6', { ...profile(0.16, 0.045, 0.03), surface: finish(0, 0.3) }),
  preset('turbo', 'turbo', '#101114', {
    pattern: 'lines',
    width: 0.2,
    period: 0.05,
    relief: 0,
    surface: finish(0, 0.6),
  }),
  preset('contour', 'paper', '#23303b', {
    pattern: 'lines',
    width: 0.22,
    period: 0.05,
    relief: 0,
    surface: finish(0, 0.7),
  }),
];

/** What light makes of the stripes, by the maps in use. */
export function stripeFinish({ maps, surface, stripes }: Style): Finish {
  const { metalness, roughness } = maps.includes('specular') ? stripes : surface;
  const { glow } = maps.includes('emission') ? stripes : surface;
  return { metalness, roughness, glow };
}

export const DEFAULT_STYLE = STYLES[0];

export function findStyle(name: string): Style | undefined {
  return STYLES.find((candidate) => candidate.name === name);
}

export function isRamp(name: string): name is RampName {
  return Object.hasOwn(RAMPS, name);
}

/** 0 to 1 to a CSS colour, for `#rrggbb` or the name of a ramp. */
function paint(colour: string): Interpolator {
  return isRamp(colour) ? RAMPS[colour] : () => colour;
}

/** Ramps by which values are told apart from one end to the other. */
const TELLING: ReadonlySet<RampName> = new Set(['viridis', 'turbo', 'lava', 'water', 'lagoon', 'dusk']);

/** Whether the surface of a style shows a field other than distance, which has no stripes to be read by. */
export function tells({ surfaceOf, ramp }: Pick<Style, 'surfaceOf' | 'ramp'>): boolean {
  return surfaceOf === 'style' && TELLING.has(ramp);
}

/** A style whose surface shows such a field: in colors that tell its values, matt, and with the stripes as thin lines. */
export function telling(style: Style): Style {
  if (tells(style)) return style;
  const ramp = TELLING.has(style.ramp) ? style.ramp : 'viridis';
  const lines = { pattern: 'lines', stripe: '#ffffff', width: 0.25, relief: 0, stripes: BASE.stripes } as const;
  return { ...style, ...(style.pattern === 'none' ? {} : lines), surfaceOf: 'style', ramp, surface: finish(0, 0.6) };
}

/** 256 × 4 sRGB bytes over distance / largest distance, of the surface and then of the stripes. */
export function rampBytes({ ramp, stripe }: Pick<Style, 'ramp' | 'stripe'>): Uint8Array {
  const bytes = new Uint8Array(2 * 256 * 4);
  for (const [row, colour] of [RAMPS[ramp], paint(stripe)].entries()) {
    for (let i = 0; i < 256; i++) {
      bytes.set([...parseColour(colour(i / 255)), 255], 4 * (256 * row + i));
    }
  }
  return bytes;
}

/** The style as a CSS background, for its button in the gallery. */
export function styleGradient({ ramp, stripe, pattern, width }: Style): string {
  const bands = 6;
  const covered = pattern === 'lines' ? 0.08 : Math.max(0.1, width);
  const parts: string[] = [];
  for (let i = 0; i < bands; i++) {
    const from = (100 * i) / bands;
    const middle = from + ((1 - covered) * 100) / bands;
    const to = (100 * (i + 1)) / bands;
    const along = (i + 0.5) / bands;
    parts.push(`${RAMPS[ramp](along)} ${from}% ${middle}%`, `${paint(stripe)(along)} ${middle}% ${to}%`);
  }
  return `linear-gradient(100deg, ${parts.join(', ')})`;
}

/** Red, green and blue, 0 to 255. */
export function parseColour(css: string): [number, number, number] {
  if (css.startsWith('#')) {
    const value = Number.parseInt(css.slice(1), 16);
    return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
  }
  const [red = 0, green = 0, blue = 0] = (css.match(/[\d.]+/g) ?? []).map(Number);
  return [Math.round(red), Math.round(green), Math.round(blue)];
}

function stops(...colours: string[]): Interpolator {
  const parsed = colours.map(parseColour);
  return (t) => {
    const place = t * (parsed.length - 1);
    const left = Math.min(Math.floor(place), parsed.length - 2);
    const mixed = between(entry(parsed, left), entry(parsed, left + 1), place - left);
    return `rgb(${mixed.map(Math.round).join(', ')})`;
  };
}
