/** Named looks: a colour ramp over the distance and stripes upon it. */
import {
  interpolateBlues,
  interpolateInferno,
  interpolateMagma,
  interpolateTurbo,
  interpolateViridis,
  interpolateYlGnBu,
} from 'd3-scale-chromatic';

/** 0 to 1 to a CSS colour, `#rrggbb` or `rgb(r, g, b)`. */
type Interpolator = (t: number) => string;

const RAMPS = {
  chalk: stops('#fffdf8', '#f3ecdf', '#e3d8c6'),
  paper: stops('#ffffff', '#e9eef2', '#cfd9e2'),
  candy: stops('#fff6ee', '#ffd9cf', '#ff9f92'),
  gold: stops('#fff3c4', '#f2cd63', '#c9922e', '#8a5a17'),
  lava: (t: number) => interpolateInferno(0.95 - 0.75 * t),
  water: (t: number) => interpolateBlues(0.12 + 0.78 * t),
  lagoon: (t: number) => interpolateYlGnBu(0.08 + 0.8 * t),
  dusk: (t: number) => interpolateMagma(0.22 + 0.7 * t),
  neon: stops('#2a0f5c', '#4b1a8f', '#21308f', '#0b4f86', '#0a6d75'),
  viridis: interpolateViridis,
  turbo: interpolateTurbo,
} satisfies Record<string, Interpolator>;

export type RampName = keyof typeof RAMPS;

export const RAMP_NAMES = Object.keys(RAMPS) as RampName[];

export interface Look {
  name: string;
  ramp: RampName;
  /** Stripe colour, `#rrggbb`. */
  stripe: string;
  /** Share of a period that the stripe paints, 0 (none) to 1. */
  width: number;
  /** Distance from stripe to stripe, as a share of the model's diameter. */
  period: number;
}

const look = (name: string, ramp: RampName, stripe: string, width: number, period: number): Look => ({
  name,
  ramp,
  stripe,
  width,
  period,
});

export const LOOKS: readonly Look[] = [
  look('zebra', 'chalk', '#1c1d20', 0.5, 0.05),
  look('candy', 'candy', '#c8102e', 0.5, 0.05),
  look('lava', 'lava', '#2a0d08', 0.22, 0.045),
  look('water', 'water', '#ffffff', 0.3, 0.04),
  look('gold', 'gold', '#4d2a0b', 0.4, 0.04),
  look('lagoon', 'lagoon', '#0b2f3a', 0.14, 0.05),
  look('scientific', 'viridis', '#ffffff', 0.1, 0.05),
  look('turbo', 'turbo', '#101114', 0.1, 0.04),
  look('dusk', 'dusk', '#fff1d6', 0.16, 0.045),
  look('contour', 'paper', '#23303b', 0.12, 0.03),
  look('neon', 'neon', '#58ffb0', 0.2, 0.05),
];

export const DEFAULT_LOOK = LOOKS[0];

export function findLook(name: string): Look | undefined {
  return LOOKS.find((candidate) => candidate.name === name);
}

export function isRamp(name: string): name is RampName {
  return Object.hasOwn(RAMPS, name);
}

/** 256 × 4 sRGB bytes over distance / largest distance. */
export function rampBytes(name: RampName): Uint8Array {
  const bytes = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; i++) {
    bytes.set([...parseColour(RAMPS[name](i / 255)), 255], 4 * i);
  }
  return bytes;
}

/** The look as a CSS background, for its button in the gallery. */
export function lookGradient({ ramp, stripe, width }: Look): string {
  const bands = 6;
  const parts: string[] = [];
  for (let i = 0; i < bands; i++) {
    const from = (100 * i) / bands;
    const middle = from + ((1 - width) * 100) / bands;
    const to = (100 * (i + 1)) / bands;
    const colour = RAMPS[ramp]((i + 0.5) / bands);
    parts.push(`${colour} ${from}% ${middle}%`, `${stripe} ${middle}% ${to}%`);
  }
  return `linear-gradient(100deg, ${parts.join(', ')})`;
}

/** Red, green and blue, 0 to 255. */
export function parseColour(css: string): [number, number, number] {
  if (css.startsWith('#')) {
    const value = Number.parseInt(css.slice(1), 16);
    return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
  }
  const [red, green, blue] = (css.match(/[\d.]+/g) ?? ['0', '0', '0']).map(Number);
  return [Math.round(red), Math.round(green), Math.round(blue)];
}

function stops(...colours: string[]): Interpolator {
  const parsed = colours.map(parseColour);
  return (t) => {
    const place = t * (parsed.length - 1);
    const left = Math.min(Math.floor(place), parsed.length - 2);
    const mixed = parsed[left].map((value, i) => Math.round(value + (place - left) * (parsed[left + 1][i] - value)));
    return `rgb(${mixed.join(', ')})`;
  };
}
