/** A chart as SVG: bars or lines over one axis, with labels that are text, so that the file can be edited. */
import { entry } from '../../state/entry';
import { numbers, t, type Words } from '../../texts';
import { attribute, say } from '../dom';

const plain = numbers({ maximumFractionDigits: 12, useGrouping: false });

export interface Series {
  name: Words;
  /** Points are joined by lines. Bars stand from each x to the next one, which is one more than there are y. */
  kind: 'bars' | 'line' | 'points';
  x: ArrayLike<number>;
  y: ArrayLike<number>;
}

export interface Chart {
  title: Words;
  xLabel: Words;
  yLabel: Words;
  /** `up`: powers of ten at equal steps upwards; values of 0 lie on the lowest one. `both`: as much of both axes as values take, which are above 0. */
  logarithmic?: 'up' | 'both';
  series: readonly Series[];
}

export interface Palette {
  text: string;
  quiet: string;
  grid: string;
  paper: string;
  series: readonly string[];
}

/** On the page, where the theme chooses. */
export const THEMED: Palette = {
  text: 'var(--text)',
  quiet: 'var(--quiet)',
  grid: 'var(--line)',
  paper: 'none',
  series: ['var(--accent)', 'var(--series)'],
};
/** In a file, which other programs show on paper. */
export const PRINTED: Palette = {
  text: '#16191c',
  quiet: '#4a535b',
  grid: '#d5d9dc',
  paper: '#ffffff',
  series: ['#0d7a41', '#b3470b'],
};

const [WIDTH, HEIGHT] = [320, 190];
const MARGIN = { left: 44, right: 10, top: 26, bottom: 36 };
/** Left of the vertical axis: its title and the gaps around its labels, and what a sign of these takes at most. */
const TITLE_WIDTH = 21;
const SIGN_WIDTH = 7;
const TICKS = 5;
/** Of axes that are fitted to their values: on either side, a share of what these take; in powers of ten where there is one value. */
const FITTED_MARGIN = 0.08;
const LONE_MARGIN = 0.3;
/** Which multiples of each power of ten have a tick, on axes of at most `decades`; on longer ones the powers alone. */
const STEPS = [
  { decades: 1, steps: [1, 1.5, 2, 3, 4, 5, 7] },
  { decades: 2.5, steps: [1, 2, 5] },
];
/** Radius of points. */
const POINT = 3;

/** Values at equal steps of 1, 2 or 5 times a power of ten, from 0 to the most. */
export function ticksTo(most: number, count = TICKS): number[] {
  if (!(most > 0)) return [0];
  const rough = most / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((times) => times * power >= rough) ?? 10);
  // A tick is missed neither nor invented by rounding.
  return Array.from({ length: Math.floor(most / step + 1e-9) + 1 }, (_, index) =>
    Number((index * step).toPrecision(12)),
  );
}

interface Axis {
  /** Where a value is, from 0 at the origin to 1 at the end. */
  place: (value: number) => number;
  ticks: readonly { value: number; label: Words }[];
}

function linearAxis(most: number): Axis {
  const ticks = ticksTo(most).map((value) => ({ value, label: plain(value) }));
  return { place: (value) => (most > 0 ? value / most : 0), ticks };
}

/** From the power of ten below the least positive value to that above the most. */
export function logarithmicAxis(values: readonly number[]): Axis {
  const exponents = values.filter((value) => value > 0).map(Math.log10);
  const low = Math.floor(Math.min(...exponents, 0));
  const high = Math.ceil(Math.max(...exponents, low + 1));
  const step = Math.ceil((high - low) / TICKS);
  const ticks = Array.from({ length: Math.floor((high - low) / step) + 1 }, (_, index) => high - index * step);
  return {
    place: (value) => Math.max(0, (Math.log10(value) - low) / (high - low)),
    ticks: ticks.map((exponent) => ({ value: 10 ** exponent, label: `10${superscript(exponent)}` })),
  };
}

/** From the least to the most value, with a margin on either side. */
export function fittedAxis(values: readonly number[]): Axis {
  const logarithms = values.map(Math.log10);
  const [least, most] = [Math.min(...logarithms), Math.max(...logarithms)];
  const margin = FITTED_MARGIN * (most - least) || LONE_MARGIN;
  const [low, high] = [least - margin, most + margin];
  const powers = Array.from({ length: Math.ceil(high) - Math.floor(low) + 1 }, (_, index) => Math.floor(low) + index);
  const { steps } = STEPS.find(({ decades }) => high - low <= decades) ?? { steps: [1] };
  const ticks = powers
    .flatMap((power) => steps.map((step) => Number(`${step}e${power}`)))
    .filter((value) => Math.log10(value) >= low && Math.log10(value) <= high);
  return {
    place: (value) => (Math.log10(value) - low) / (high - low),
    ticks: ticks.map((value) => ({ value, label: shortly(value) })),
  };
}

/** Up to four places; else as a product with a power of ten. */
function shortly(value: number): Words {
  const power = Math.floor(Math.log10(value) + 1e-9);
  if (power > -4 && power < 4) return plain(value);
  const digit = Math.round(value / 10 ** power);
  return `${digit === 1 ? '' : `${digit}·`}10${superscript(power)}`;
}

function superscript(whole: number): string {
  return [...String(whole)].map((sign) => (sign === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(sign)])).join('');
}

export function plot({ title, xLabel, yLabel, logarithmic, series }: Chart, palette: Palette): SVGSVGElement {
  const places = series.flatMap(({ x }) => Array.from(x));
  const values = series.flatMap(({ y }) => Array.from(y).filter(Number.isFinite));
  const along = logarithmic === 'both' ? fittedAxis(places) : linearAxis(Math.max(...places, 0));
  const up =
    logarithmic === 'both'
      ? fittedAxis(values)
      : logarithmic === 'up'
        ? logarithmicAxis(values)
        : linearAxis(Math.max(...values, 0));
  const longest = Math.max(...up.ticks.map(({ label }) => String(label).length));
  const left = Math.max(MARGIN.left, TITLE_WIDTH + SIGN_WIDTH * longest);
  const [right, bottom] = [WIDTH - MARGIN.right, HEIGHT - MARGIN.bottom];
  const px = (x: number) => left + along.place(x) * (right - left);
  const py = (y: number) => bottom - up.place(y) * (bottom - MARGIN.top);
  const root = svg('svg', {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: 'img',
    'aria-label': t`${title}: ${yLabel} by ${xLabel}`,
    'font-family': 'system-ui, sans-serif',
    'font-size': 11,
  });
  root.append(svg('rect', { width: WIDTH, height: HEIGHT, fill: palette.paper }));
  root.append(text(title, { x: MARGIN.left, y: 14, fill: palette.text, 'font-weight': 600, 'font-size': 12 }));
  for (const { value, label: words } of up.ticks) {
    const y = py(value).toFixed(1);
    root.append(svg('path', { d: `M${left} ${y}H${right}`, stroke: palette.grid }));
    root.append(text(words, { x: left - 5, y, dy: '0.35em', 'text-anchor': 'end', fill: palette.quiet }));
  }
  for (const { value, label: words } of along.ticks) {
    root.append(text(words, { x: px(value).toFixed(1), y: bottom + 13, 'text-anchor': 'middle', fill: palette.quiet }));
  }
  root.append(text(xLabel, { x: (left + right) / 2, y: HEIGHT - 6, 'text-anchor': 'middle', fill: palette.text }));
  const middle = (MARGIN.top + bottom) / 2;
  root.append(
    text(yLabel, { transform: `translate(11 ${middle}) rotate(-90)`, 'text-anchor': 'middle', fill: palette.text }),
  );
  series.forEach(({ name, kind, x, y }, index) => {
    const color = entry(palette.series, index % palette.series.length);
    const across = (i: number) => px(entry(x, i)).toFixed(2);
    const top = (i: number) => py(entry(y, i)).toFixed(2);
    const at = (i: number) => `${across(i)} ${top(i)}`;
    const bar = (i: number) => `M${across(i)} ${bottom}V${top(i)}H${across(i + 1)}V${bottom}Z`;
    const order = Array.from({ length: y.length }, (_, i) => i);
    if (kind === 'bars') root.append(svg('path', { d: order.map(bar).join(''), fill: color }));
    else root.append(svg('path', { d: `M${order.map(at).join('L')}`, fill: 'none', stroke: color, 'stroke-width': 2 }));
    if (kind === 'points') {
      for (const i of order) root.append(svg('circle', { cx: across(i), cy: top(i), r: POINT, fill: color }));
    }
    if (series.length > 1) {
      root.append(text(name, { x: right, y: 14 + 12 * index, 'text-anchor': 'end', fill: color, 'font-weight': 600 }));
    }
  });
  return root;
}

/** The chart as a file. */
export function svgFile(chart: Chart): Blob {
  return new Blob([new XMLSerializer().serializeToString(plot(chart, PRINTED))], { type: 'image/svg+xml' });
}

/** One line an x of the first series; a bar is written with where it begins. */
export function csvOf({ xLabel, series }: Chart): string {
  const [first] = series;
  const rows = Array.from(first?.y ?? [], (_, i) => [first?.x[i], ...series.map(({ y }) => y[i])]);
  const head = [xLabel, ...series.map(({ name }) => name)].map((name) => `"${String(name).replaceAll('"', '""')}"`);
  return [head, ...rows].map((row) => row.join(',')).join('\r\n') + '\r\n';
}

function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Record<string, Words | number>,
): SVGElementTagNameMap[K] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    attribute(element, name, value);
  }
  return element;
}

function text(content: Words, attributes: Record<string, string | number>): SVGTextElement {
  const element = svg('text', attributes);
  say(element, content);
  return element;
}
