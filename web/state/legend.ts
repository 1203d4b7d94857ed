/** What a legend tells of the colors: what they mean, from no value to the largest one, with round numbers beside them. */
import { type LengthUnit, type ModelLength, ofModel, told } from '../length';
import type { VertexField } from '../wasm/contract';
import type { Pattern, Style } from './styles';
import { measure, threeDigits } from './measures';
import { t, type Words } from '../texts';

/** What is painted. */
export interface Painted {
  kind: VertexField;
  /** The largest value: a length, powers of ten of heat below the hottest place, or a relative error. */
  most: number;
  /** Whether distance is what a path costs. */
  isCost: boolean;
}

export interface Tick {
  /** Share of the largest value. */
  at: number;
  text: Words;
}

/** The least of 1, 2 and 5 times a power of ten of which `most` has at most so many. */
export function roundStep(most: number, count: number): number {
  const least = most / count;
  const power = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5].map((digit) => digit * power).find((value) => value >= least * (1 - 1e-9)) ?? 10 * power;
  return Number(step.toPrecision(1));
}

/** The greatest of 1, 2 and 5 times a power of ten that is at most `most`. */
export function roundBelow(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  const below = [5, 2, 1].map((digit) => digit * power).find((value) => value <= most * (1 + 1e-9)) ?? power;
  return Number(below.toPrecision(1));
}

/** Round values from 0 on, at most `count` of them above 0, and at least one but for heat. */
export function ticksOf({ kind, most }: Painted, unit: LengthUnit, count: number): Tick[] {
  if (!(most > 0)) return [{ at: 0, text: tickWords(kind, 0) }];
  const largest = kind === 'distance' ? told(ofModel(most), unit) : kind === 'error' ? 100 * most : most;
  // Powers of ten are whole.
  const round = roundStep(largest, count);
  const step = kind === 'heat' ? Math.max(round, 1) : Math.min(round, roundBelow(largest));
  const values = Array.from({ length: Math.floor(largest / step + 1e-9) + 1 }, (_, times) =>
    Number((times * step).toPrecision(6)),
  );
  return values.map((value) => ({ at: value / largest, text: tickWords(kind, value) }));
}

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

function tickWords(kind: VertexField, value: number): Words {
  if (kind === 'error') return t`${threeDigits(value)} %`;
  if (kind === 'distance') return threeDigits(value);
  return value === 0 ? '1' : `10⁻${Array.from(String(value), (digit) => SUPERSCRIPTS[Number(digit)]).join('')}`;
}

/** The largest value in words. */
export function largestWords({ kind, most }: Painted, unit: LengthUnit): Words {
  if (kind === 'distance') return measure(ofModel(most), unit);
  return tickWords(kind, kind === 'error' ? 100 * most : Math.round(most));
}

/** What the colors mean. */
export function nameWords({ kind, isCost }: Painted): Words {
  if (kind === 'heat') return t('Heat (log scale)');
  if (kind === 'error') return t('Relative error');
  return isCost ? t('Least cost') : t('Distance');
}

/** The same with the unit of the numbers beside them. */
export function titleWords(painted: Painted, { symbol, assumed }: LengthUnit): Words {
  const name = nameWords(painted);
  if (painted.kind !== 'distance') return name;
  const unit = symbol || t('units');
  return assumed ? t`${name} (${unit}, assumed)` : t`${name} (${unit})`;
}

/** From one stripe to the next; null where there are none, and where what they are apart is no length. */
export function spacingOf(pattern: Pattern, { kind }: Painted, period: number): ModelLength | null {
  return kind === 'distance' && pattern !== 'none' && period > 0 ? ofModel(period) : null;
}

/** Thin lines between two others, and their opacity: as surface.wgsl has them. */
const SUBDIVISIONS = 5;
const THIN_OPACITY = 0.45;
const THIN_WIDTH = 0.55;
/** The most that lines cover where they are too dense to be told apart. */
const DENSEST = 0.4;
/** Places of a pixel that are looked at. */
const SAMPLES = 16;

/**
 * Share of a pixel that the pattern covers at a phase, in periods. `span`: periods of a pixel. As surface.wgsl draws it on
 * a surface that is seen straight on.
 */
export function coverage({ pattern, width, sharpness }: Style, lineWidth: number, phase: number, span: number): number {
  if (pattern === 'none') return 0;
  if (pattern === 'lines') {
    const thin = lines(phase * SUBDIVISIONS, span * SUBDIVISIONS, (THIN_WIDTH * lineWidth) / 2);
    return Math.max(lines(phase, span, lineWidth / 2), THIN_OPACITY * thin);
  }
  const flank = Math.max(0.5 * Math.min(width, 1 - width) * (1 - sharpness), 1e-3);
  let sum = 0;
  for (let i = 0; i < SAMPLES; i++) sum += profile(phase + ((i + 0.5) / SAMPLES - 0.5) * span, width, flank);
  return mix(sum / SAMPLES, width, smoothstep(0.33, 0.6, span));
}

/** Height of a stripe, 0 to 1: up in the middle `width` of each period of 1. */
function profile(phase: number, width: number, flank: number): number {
  const at = fraction(phase) - 0.5;
  return smoothstep(-flank, flank, at + width / 2) - smoothstep(-flank, flank, at - width / 2);
}

function lines(phase: number, span: number, half: number): number {
  const away = Math.abs(fraction(phase + 0.5) - 0.5) / Math.max(span, 1e-6);
  const covered = Math.min(1, Math.max(0, half + 0.5 - away));
  return mix(covered, Math.min(DENSEST, 2 * half * span), smoothstep(0.12, 0.3, span));
}

function fraction(value: number): number {
  return value - Math.floor(value);
}

function mix(a: number, b: number, share: number): number {
  return a + (b - a) * share;
}

function smoothstep(from: number, to: number, value: number): number {
  const share = Math.min(1, Math.max(0, (value - from) / (to - from)));
  return share * share * (3 - 2 * share);
}
